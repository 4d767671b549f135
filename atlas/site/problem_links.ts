// How a problem, a class and a degree look in a list.
import { make, withCommas, type Child } from "./elements.js";
import { photos } from "./photos.js";
import type { GeneralDegree, Row } from "./prover.js";

export function problemAddress(spec: string | number): string {
    const encoded = encodeURIComponent(String(spec));
    return `problem.html?p=${encoded.replaceAll("%20", "+").replaceAll("%2F", "/")}`;
}

export function problemLink(spec: string | number, ...text: Child[]): HTMLAnchorElement {
    return make("a", { href: problemAddress(spec) }, ...text);
}

/** The word says how sure it is; the colour only repeats it. */
export function statusMark(status: string): HTMLElement {
    return make("span", { class: `status ${status}` }, status);
}

export function degreeInWords(degree: Pick<GeneralDegree, "value" | "bound">): string {
    const number = withCommas(degree.value);
    return degree.bound === "exact" ? number : `at least ${number}`;
}

/** A class in a list of results: its picture, notation and verdict. */
export function card(row: Row): HTMLElement {
    const verdict = row.minimal ? "minimal" : `not minimal: ${row.obstruction}`;
    const facts = make("p", { class: "facts" }, verdict);
    if (row.degree) facts.append(` · degree ${withCommas(row.degree)}`);
    return make(
        "li",
        { class: "card" },
        make(
            "a",
            { href: problemAddress(row.number), class: "card-link" },
            ...(row.scene ? [photos(row.scene, row.notation, "small")] : []),
            make("span", { class: "card-number" }, `#${row.number}`),
            make("span", { class: "notation" }, row.notation),
        ),
        facts,
    );
}

/** A class in a short list: one line. */
export function line(row: Row): HTMLElement {
    const exchange = row.added ? `${row.added} instead of ${row.dropped ?? ""}: ` : "";
    const item = make(
        "li",
        {},
        exchange,
        problemLink(
            row.number,
            `#${row.number} `,
            make("span", { class: "notation" }, row.notation),
        ),
        row.minimal ? "" : ` (not minimal: ${row.obstruction})`,
    );
    if (row.degree) item.append(`, degree ${withCommas(row.degree)}`);
    return item;
}
