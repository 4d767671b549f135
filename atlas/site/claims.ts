// The report of plcheck (docs/report.schema.json), as far as pages show it: the counts and degrees
// of the paper beside those that are certified.
import { make, withCommas } from "./elements.js";
import { problemLink } from "./problem_links.js";

export interface Claim {
    claim: string;
    paper: number | string | null;
    certified: number | string | null;
    verdict: string;
    counted: string;
}

export interface DegreeClaim {
    claim: string;
    claimed_exactly: number | null;
    certified_at_least: number | null;
    certified_exactly: number | null;
    verdict: string;
}

export interface ReportOfChecker {
    claims: Claim[];
    degree_claims: DegreeClaim[];
}

export const builtCaption =
    "The counts of the paper, and those certified in the run with which this atlas was built";
export const ownCaption =
    "The counts of the paper, and those that your browser just derived from the certificates";

/** The report of the run with which the atlas was built. */
export async function builtReport(): Promise<ReportOfChecker> {
    return (await (await fetch("data/report.json")).json()) as ReportOfChecker;
}

export function cell(value: number | string | null | undefined): string {
    if (value === null || value === undefined) return "-";
    return typeof value === "number" ? withCommas(value) : value;
}

/** Whether a count is the paper's, in the program's words. */
export function verdictMark(verdict: string): HTMLElement {
    const kind =
        verdict === "confirmed" ? "confirmed" : verdict.startsWith("differs") ? "differs" : "other";
    return make("span", { class: `claim ${kind}` }, verdict);
}

/** A text in which `class 2394` is a link. */
export function withLinks(text: string): (Node | string)[] {
    return text.split(/(class \d+)/).map((part) => {
        const number = /^class (\d+)$/.exec(part)?.[1];
        return number === undefined ? part : problemLink(number, part);
    });
}

/** A claim as a row of a table: what is counted, the paper's number, the certified one. */
function claimRow(claim: Claim): HTMLElement {
    const indent = /^(- )*/.exec(claim.claim)?.[0].length ?? 0;
    return make(
        "tr",
        {},
        make(
            "th",
            { scope: "row", class: `indent-${indent / 2}` },
            ...withLinks(claim.claim.slice(indent)),
        ),
        make("td", { class: "number" }, cell(claim.paper)),
        make("td", { class: "number" }, cell(claim.certified)),
        make("td", {}, verdictMark(claim.verdict)),
    );
}

/** The claims as a table. */
export function countsTable(claims: Claim[], caption: string): HTMLTableElement {
    const heads = [
        make("th", { scope: "col" }, "claim"),
        make("th", { scope: "col", class: "number" }, "paper"),
        make("th", { scope: "col", class: "number" }, "certified"),
        make("th", { scope: "col" }, "verdict"),
    ];
    return make(
        "table",
        {},
        make("caption", {}, caption),
        make("thead", {}, make("tr", {}, ...heads)),
        make("tbody", {}, ...claims.map(claimRow)),
    );
}
