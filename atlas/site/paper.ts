// The paper's tables beside what the certificates say: in the run with which the atlas was built,
// and in the reader's own run.
import { checkOnClick } from "./check_view.js";
import { atlasFile } from "./checker.js";
import {
    builtCaption,
    builtReport,
    cell,
    countsTable,
    type DegreeClaim,
    ownCaption,
    type ReportOfChecker,
    verdictMark,
    withLinks,
} from "./claims.js";
import { byId, make } from "./elements.js";

/** Each count that differs, why, and a witness. */
function showDifferences(report: ReportOfChecker): void {
    const differing = report.claims.filter((claim) => claim.verdict.startsWith("differs"));
    const entries = differing.flatMap((claim) => [
        make(
            "dt",
            {},
            `${claim.claim.replace(/^(- )*/, "")}: paper ${cell(claim.paper)}, ` +
                `certified ${cell(claim.certified)}`,
        ),
        make(
            "dd",
            {},
            make("p", {}, `${claim.verdict.replace("differs: ", "Why: ")}.`),
            make("p", {}, "Counted: ", ...withLinks(claim.counted.split("\n")[0] ?? "")),
            ...claim.counted
                .split("\n")
                .slice(1)
                .map((text) => make("p", {}, ...withLinks(text.trim()))),
        ),
    ]);
    byId("differences", HTMLElement).replaceChildren(...entries);
}

function certified(claim: DegreeClaim): string {
    if (claim.certified_exactly !== null) return cell(claim.certified_exactly);
    return claim.certified_at_least ? `at least ${cell(claim.certified_at_least)}` : "-";
}

/** The row of all degrees has no claim to compare: all are certified. */
function verdictOf({ verdict, certified_exactly }: DegreeClaim): string {
    return verdict === "-" && certified_exactly !== null ? "all certified" : verdict;
}

function showDegrees(report: ReportOfChecker): void {
    const rows = report.degree_claims.map((claim) =>
        make(
            "tr",
            {},
            make("th", { scope: "row" }, ...withLinks(claim.claim)),
            make("td", { class: "number" }, cell(claim.claimed_exactly)),
            make("td", { class: "number" }, certified(claim)),
            make("td", {}, verdictMark(verdictOf(claim))),
        ),
    );
    byId("degrees", HTMLTableElement).tBodies[0]?.replaceChildren(...rows);
    const count = (verdict: string) =>
        report.degree_claims.filter((claim) => claim.verdict === verdict).length;
    const certifiedExactly = report.degree_claims.filter(
        (claim) => claim.certified_exactly !== null || claim.certified_at_least !== null,
    ).length;
    byId("degrees-sum", HTMLElement).textContent =
        `Each of the ${certifiedExactly} rows has a certified number, none is open: ` +
        `${count("agrees")} are the paper's, ${count("differs")} differ, and of ` +
        `${count("no claim in the paper")} the paper says nothing.`;
}

function showCounts(report: ReportOfChecker, caption: string): void {
    byId("counts", HTMLElement).replaceChildren(countsTable(report.claims, caption));
    showDifferences(report);
}

checkOnClick(
    byId("check-now", HTMLButtonElement),
    byId("check", HTMLElement),
    {
        options: ["--classification", "--errata"],
        files: [atlasFile("certs/classification.plc")],
    },
    (report: ReportOfChecker) => showCounts(report, ownCaption),
);

const built = await builtReport();
showCounts(built, builtCaption);
showDegrees(built);
