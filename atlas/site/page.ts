// What every page does: it keeps the atlas for reading without a network, where the browser can; its
// long pages have a table of contents; and its words say what they mean.
import { showContents } from "./contents.js";
import { explainTerms, term } from "./glossary.js";

if ("serviceWorker" in navigator && window.isSecureContext) {
    navigator.serviceWorker.register(new URL("../offline.js", import.meta.url)).catch(() => {
        // Some browsers forbid it in private windows. The pages work without.
    });
}

// In the text of pages: <dfn data-term="minimal">minimal</dfn>.
for (const word of document.querySelectorAll<HTMLElement>("dfn[data-term]"))
    word.replaceChildren(term(word.dataset.term ?? "", word.textContent ?? ""));
explainTerms();
showContents();
