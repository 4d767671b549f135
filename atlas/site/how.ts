// The explanation: its second picture is the matrix of a problem, computed here.
import { byId } from "./elements.js";
import { jacobian } from "./certificate_view.js";
import { Prover } from "./prover.js";

const answer = await new Prover().certificate("2*Pa/Pa/Pa + P/P/P");
byId("matrix", HTMLElement).replaceChildren(jacobian(answer));
