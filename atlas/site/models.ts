// All models, those with some words, and a certificate of each. The address has the words, and after
// its # the model that is open.
import { checkOnClick } from "./check_view.js";
import { atlasFile } from "./checker.js";
import { afterPause, byId, make, openItem } from "./elements.js";
import { allModels, solutionsOf, withWords, type Model } from "./model.js";
import { statusMark } from "./problem_links.js";

const words = byId("words", HTMLInputElement);
const list = byId("models", HTMLElement);
const total = byId("total", HTMLElement);

function factsOf(model: Model): HTMLElement {
    const facts = make("p", { class: "facts" }, `${solutionsOf(model)} `, statusMark("certified"));
    if (model.claimed === null) return facts;
    facts.append(` · claimed ${model.claimed}`);
    return facts;
}

/** The text of the model, its certificate, and a button that checks it. */
function detailsOf(model: Model): HTMLElement {
    const file = `certs/models/${model.name}.plc`;
    const button = make("button", { type: "button" }, "Check it now");
    const place = make("div");
    checkOnClick(button, place, { options: [], files: [atlasFile(file)] }, () => {});
    const label = `Text of the model ${model.name}`;
    return make(
        "details",
        {},
        make("summary", {}, "text and certificate"),
        make("pre", { class: "output record", tabindex: "0", "aria-label": label }, model.text),
        make(
            "p",
            { class: "buttons" },
            button,
            make("a", { href: file, download: true }, "the certificate"),
            make("a", { href: "certs/FORMAT.md" }, "what its lines mean (section 16)"),
        ),
        place,
    );
}

function viewOf(model: Model): HTMLElement {
    const { name, title, source } = model;
    return make(
        "li",
        { id: name, class: "card" },
        make("p", { class: "member" }, make("a", { href: `#${name}` }, title)),
        factsOf(model),
        make("p", { class: "quiet" }, source),
        detailsOf(model),
    );
}

async function showList(): Promise<void> {
    try {
        const models = await allModels();
        const shown = withWords(models, words.value);
        list.replaceChildren(...shown.map(viewOf));
        total.textContent = `${shown.length} of ${models.length} models`;
    } catch (error) {
        list.replaceChildren();
        total.textContent = `${String(error)}. Load the page again.`;
    }
}

/** Opens the model that the address names. If the words hide it, they go. */
async function openNamed(): Promise<void> {
    const name = location.hash.slice(1);
    if (name === "" || name === "main") return;
    if (!document.getElementById(name) && words.value !== "") {
        words.value = "";
        await showList();
    }
    if (!openItem(name)) total.textContent += `; none of them is ${name}`;
}

function keepInAddress(): void {
    const query = words.value === "" ? "" : `?${new URLSearchParams({ words: words.value })}`;
    history.replaceState(null, "", location.pathname + query);
}

byId("filter", HTMLFormElement).addEventListener("submit", (event) => event.preventDefault());
words.addEventListener(
    "input",
    afterPause(() => {
        keepInAddress();
        void showList();
    }),
);
window.addEventListener("hashchange", () => void openNamed());

words.value = new URLSearchParams(location.search).get("words") ?? "";
await showList();
await openNamed();
