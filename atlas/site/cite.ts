// The page that says how to cite.
import { citationView } from "./citation.js";
import { byId } from "./elements.js";

byId("citation", HTMLElement).replaceChildren(citationView({ key: "certificates", page: "index.html" }));
