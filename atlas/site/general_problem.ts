// The page of a problem in general: with shared lines, more than three views, or projective cameras.
import { download, make, type Child } from "./elements.js";
import { degreeInWords, statusMark } from "./problem_links.js";
import type { GeneralAnswer, GeneralReport } from "./prover.js";
import { recordView } from "./record_view.js";
import { facts, notation } from "./verdict_view.js";

/** The verdict as a heading, and the reason. */
export function generalVerdictView({ minimal, reason }: GeneralReport): HTMLElement {
    return make(
        "div",
        { class: `verdict ${minimal ? "holds" : "fails"}` },
        make("p", { class: "verdict-word" }, minimal ? "Minimal" : "Not minimal"),
        make("p", {}, `${reason.charAt(0).toUpperCase()}${reason.slice(1)}.`),
    );
}

function degreeOf({ degree }: GeneralReport): Child[] {
    if (!degree) return ["none on file"];
    const number = make("strong", {}, degreeInWords(degree));
    return [number, " ", statusMark(degree.status), ` ${degree.source}`];
}

function dimensionsOf({ dimensions: { scene, cameras, images } }: GeneralReport): string {
    const balanced = scene + cameras === images;
    return `scene ${scene} + cameras ${cameras} ${balanced ? "=" : "against"} images ${images}`;
}

/** The rows of facts that search and the page of a problem share. */
export function generalFacts(report: GeneralReport): HTMLElement {
    const rows: [string, Child[]][] = [
        ["cameras", [`${report.views} ${report.cameras} cameras`]],
        ["name", [report.name]],
        ["dimensions", [dimensionsOf(report)]],
    ];
    if (report.minimal) rows.push(["degree", degreeOf(report)]);
    return facts(rows);
}

export function showGeneralProblem(answer: GeneralAnswer, place: HTMLElement): void {
    const { general: report, certificate: text } = answer;
    const { problem, name, minimal, cameras } = report;
    document.title = `${name} · Atlas of point-line problems`;
    const family = cameras === "calibrated" ? "plmp" : cameras;
    place.replaceChildren(
        make("h1", {}, name),
        make("p", { class: "asked" }, notation(problem)),
        generalVerdictView(report),
        generalFacts(report),
        make("h2", {}, "Certificate"),
        make(
            "p",
            {},
            "The prover found this certificate just now, in this browser. The checker shares no " +
                "source with it, and believes nothing that stands in it.",
        ),
        recordView({ text, problem, minimal }, "problem"),
        make(
            "p",
            { class: "buttons" },
            make(
                "button",
                { type: "button", click: () => download("problem.plc", text) },
                "Download the certificate (.plc)",
            ),
            make(
                "a",
                { href: `families.html?family=${family}` },
                `all balanced problems of ${cameras} cameras whose views see everything`,
            ),
        ),
    );
}
