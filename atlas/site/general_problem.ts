// The page of a problem in general: with shared lines, more than three views, or other cameras.
import { citationView } from "./citation.js";
import { sourceInWords } from "./degree_words.js";
import { download, make, type Child } from "./elements.js";
import { isFamily } from "./family.js";
import { term } from "./glossary.js";
import { nameOfLine, photos, photosAsFile } from "./photos.js";
import { degreeInWords, problemAddress, statusMark } from "./problem_links.js";
import type { Evidence, GeneralAnswer, GeneralReport } from "./prover.js";
import { recordView } from "./record_view.js";
import { sketch } from "./sketch.js";
import { facts, groupRows, notation } from "./verdict_view.js";

function verdictInWords({ minimal }: GeneralReport): Child[] {
    if (minimal === null) return ["No verdict: conjectured not minimal"];
    return minimal ? [term("minimal", "Minimal")] : ["Not ", term("minimal")];
}

/** The verdict as a heading, and the reason. */
export function generalVerdictView(report: GeneralReport): HTMLElement {
    const { minimal, reason } = report;
    return make(
        "div",
        { class: `verdict ${minimal ? "holds" : minimal === null ? "open" : "fails"}` },
        make("p", { class: "verdict-word" }, ...verdictInWords(report)),
        make("p", {}, `${reason.charAt(0).toUpperCase()}${reason.slice(1)}.`),
    );
}

function degreeOf({ degree }: GeneralReport): Child[] {
    if (!degree) return ["nobody has computed it yet"];
    const number = make("strong", {}, degreeInWords(degree));
    return [number, " ", statusMark(degree.status), ` ${sourceInWords(degree)}`];
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
    if (report.group && report.degree) rows.push(...groupRows(report.group, report.degree.value));
    if (report.evidence) rows.push(...evidenceRows(report, report.evidence));
    return facts(rows);
}

/** What is seen of a problem without a verdict. */
function evidenceRows(report: GeneralReport, evidence: Evidence): [string, Child[]][] {
    const { scene, cameras } = report.dimensions;
    const list = (all: (number | string)[]) => (all.length > 0 ? all.join(", ") : "none");
    return [
        [
            "ranks",
            [
                statusMark("evidence"),
                ` ${evidence.ranks.join(", ")} at three random places; ` +
                    `${scene + cameras} would make it minimal`,
            ],
        ],
        [
            "what moves",
            [
                `cameras ${list(evidence.moving_cameras)}; points ${list(evidence.moving_points)}; ` +
                    `lines ${list(evidence.moving_lines.map((line) => nameOfLine(line - 1)))}. ` +
                    "At the first of these places they can move a little, together, and no photo changes.",
            ],
        ],
    ];
}

function section(id: string, title: string, ...children: Child[]): HTMLElement {
    return make("section", { "aria-labelledby": id }, make("h2", { id }, title), ...children);
}

function certificateSection({ general, certificate: text }: GeneralAnswer): HTMLElement {
    const { problem, minimal } = general;
    if (text === undefined || minimal === null)
        return section(
            "certificate",
            "Certificate",
            make(
                "p",
                {},
                "There is none. The prover found no scene that proves the problem minimal, and knows no " +
                    "reason that proves it not minimal. So this is an open question, with evidence.",
            ),
        );
    return section(
        "certificate",
        "Certificate",
        make(
            "p",
            {},
            "The prover found this certificate just now, in this browser. The checker shares no " +
                "source with it, and believes nothing that stands in it.",
        ),
        recordView({ text, problem, minimal }, "problem"),
    );
}

function downloadsSection({ general: report, certificate, scene }: GeneralAnswer): HTMLElement {
    const file = (label: string, name: string, text: () => string) =>
        make("button", { type: "button", click: () => download(name, text()) }, label);
    const buttons = [
        file("picture (SVG)", "problem.svg", () => photosAsFile(scene, report.problem)),
        file("verdict (JSON)", "problem.json", () => `${JSON.stringify(report, null, 2)}\n`),
    ];
    if (certificate !== undefined)
        buttons.unshift(file("certificate (.plc)", "problem.plc", () => certificate));
    return section("downloads", "Downloads", make("p", { class: "buttons" }, ...buttons));
}

function relatedSection({ cameras }: GeneralReport): HTMLElement {
    const family = cameras === "calibrated" ? "plmp" : cameras;
    const words = `all balanced problems of ${cameras} cameras whose views see everything`;
    const link = isFamily(family)
        ? make("a", { href: `families.html?family=${family}` }, words)
        : make("a", { href: "families.html" }, "families of problems");
    return section("related", "Related problems", make("p", {}, link));
}

export function showGeneralProblem(answer: GeneralAnswer, place: HTMLElement): void {
    const { general: report, scene } = answer;
    const { problem, name } = report;
    document.title = `${name} · Atlas of point-line problems`;
    const moving = report.evidence && {
        points: report.evidence.moving_points.map((point) => point - 1),
        lines: report.evidence.moving_lines.map((line) => line - 1),
        cameras: report.evidence.moving_cameras.map((camera) => camera - 1),
    };
    place.replaceChildren(
        make("h1", {}, name),
        make("p", { class: "asked" }, notation(problem)),
        make(
            "div",
            { class: "overview" },
            make(
                "div",
                {},
                make("figure", {}, photos(scene, problem)),
                generalVerdictView(report),
                generalFacts(report),
            ),
            make(
                "div",
                {},
                sketch(scene, moving),
                make("nav", { class: "contents", "aria-label": "On this page", hidden: true }),
            ),
        ),
        certificateSection(answer),
        make("div", { class: "two-columns" }, relatedSection(report), downloadsSection(answer)),
        section(
            "cite",
            "Cite this page",
            citationView({
                what: `problem ${name}, ${problem}`,
                key: name.replace(/\W/g, "-"),
                page: problemAddress(problem),
            }),
        ),
    );
}
