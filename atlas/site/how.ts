// The explanation: its second picture is the matrix of a problem, computed here; and the glossary.
import { byId } from "./elements.js";
import { jacobian } from "./certificate_view.js";
import { glossaryView } from "./glossary.js";
import { Prover } from "./prover.js";

byId("words", HTMLElement).replaceChildren(glossaryView());
// The address may name a word, which was not there yet.
if (location.hash.startsWith("#word-")) document.getElementById(location.hash.slice(1))?.scrollIntoView();
const answer = await new Prover().certificate("2*Pa/Pa/Pa + P/P/P");
byId("matrix", HTMLElement).replaceChildren(jacobian(answer));
