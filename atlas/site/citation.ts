// How to cite the atlas, or one of its problems: a line of text, and an entry for BibTeX. Version,
// commit and year are those that the atlas was built from.
import { make } from "./elements.js";

function built(name: string): string {
    return document.querySelector<HTMLMetaElement>(`meta[name="atlas-${name}"]`)?.content ?? "unknown";
}

const authors = "The point-line-certificates authors";
const title = "Point-line certificates";

/** A problem as citations name it, and its page. */
export interface Cited {
    /** `problem #2394 (Chicago), 2*Pa/Pa/Pa + P/P/P`; nothing: the whole atlas. */
    what?: string;
    /** A word for the entry: `2394`. */
    key: string;
    /** In the atlas. */
    page: string;
}

/** Where the page stays: on the host that the atlas was built for, else where it is read. */
export function stableAddress(page: string): string {
    return new URL(page, built("address") || location.href).href;
}

/** In BibTeX some signs mean something. */
function plain(text: string): string {
    return text.replace(/[#%&_$]/g, (sign) => `\\${sign}`);
}

export function citationText({ what, page }: Cited): string {
    const of = what === undefined ? "" : `: ${what}`;
    return (
        `${authors}. ${title}, version ${built("version")}${of}. ${built("year")}. ` +
        `Commit ${built("commit")}. ${stableAddress(page)}`
    );
}

export function citationBibtex({ what, key, page }: Cited): string {
    const fields = [
        `author  = {{${authors}}}`,
        `title   = {${title}${what === undefined ? "" : `: ${plain(what)}`}}`,
        `year    = {${built("year")}}`,
        `version = {${built("version")}}`,
        `note    = {Commit ${plain(built("commit"))}}`,
        `url     = {${stableAddress(page)}}`,
    ];
    return `@software{pointline-${key},\n  ${fields.join(",\n  ")}\n}\n`;
}

function copyButton(text: string, label: string): HTMLElement {
    const said = make("span", { class: "quiet", role: "status" });
    const copy = async () => {
        try {
            await navigator.clipboard.writeText(text);
            said.textContent = "copied";
        } catch {
            said.textContent = "select the text and copy it";
        }
    };
    const button = make(
        "button",
        { type: "button", "aria-label": label, click: () => void copy() },
        "Copy",
    );
    return make("p", { class: "buttons" }, button, said);
}

/** Both, each with a button that copies it. */
export function citationView(cited: Cited): HTMLElement {
    const text = citationText(cited);
    const bibtex = citationBibtex(cited);
    return make(
        "div",
        { class: "citation" },
        make(
            "div",
            {},
            make("p", { class: "citation-line" }, text),
            copyButton(text, "Copy the citation"),
        ),
        make(
            "div",
            {},
            make("pre", { class: "output", tabindex: "0", "aria-label": "BibTeX" }, bibtex),
            copyButton(bibtex, "Copy the entry for BibTeX"),
        ),
    );
}
