// The page of one problem: what is known of it, its certificate, and the button that checks it.
import { certificateView } from "./certificate_view.js";
import { CheckView } from "./check_view.js";
import { degreeChecks } from "./degree_checks.js";
import { citationView } from "./citation.js";
import { showContents } from "./contents.js";
import { byId, download, make, withCommas } from "./elements.js";
import { showGeneralProblem } from "./general_problem.js";
import { photos } from "./photos.js";
import { line, problemAddress, problemLink } from "./problem_links.js";
import {
    Complaint,
    type Extension,
    type FileKind,
    type ProblemAnswer,
    Prover,
    type Row,
} from "./prover.js";
import { sketch } from "./sketch.js";
import { factRows, facts, hintsView, notation, verdictView } from "./verdict_view.js";

const prover = new Prover();
const place = byId("problem", HTMLElement);

/** A word for names of files. */
function fileName(answer: ProblemAnswer): string {
    const { number, standing } = answer.report;
    return number !== undefined && standing === "member" ? `class-${number}` : "problem";
}

function downloads(answer: ProblemAnswer): HTMLElement {
    const kinds: [FileKind, string, string][] = [
        ["certificate", "certificate (.plc)", "plc"],
        ["svg", "picture (SVG)", "svg"],
        ["tikz", "picture (TikZ)", "tex"],
        ["macaulay2", "equations (Macaulay2)", "m2"],
        ["julia", "equations (Julia)", "jl"],
    ];
    // Of a few problems no equations are written: too large ones, and what no view sees.
    const refusal = make("span", { class: "complaint" });
    const buttons = kinds.map(([kind, label, ending]) => {
        const save = async () => {
            refusal.replaceChildren();
            try {
                const text = await prover.file(answer.report.problem, kind);
                download(`${fileName(answer)}.${ending}`, text);
            } catch (error) {
                refusal.replaceChildren(wordsOf(error));
            }
        };
        return make("button", { type: "button", click: () => void save() }, label);
    });
    return make("p", { class: "buttons" }, ...buttons, refusal);
}

/** The verdict's certificate: a button that replays it, and its numbers. */
async function showCertificate(answer: ProblemAnswer, section: HTMLElement): Promise<void> {
    const { problem, verdict } = answer.report;
    const certificate = await prover.certificate(problem);
    const view = new CheckView();
    const run = () =>
        view.run({
            options: ["--expect", problem, "--verdict", verdict],
            files: [
                {
                    name: `${fileName(answer)}.plc`,
                    bytes: new TextEncoder().encode(certificate.text).buffer as ArrayBuffer,
                },
            ],
        });
    section.append(
        make(
            "p",
            {},
            "The prover found this certificate just now, in this browser. The checker " +
                "shares no source with it, and believes nothing that stands in it.",
        ),
        make(
            "p",
            { class: "buttons" },
            make(
                "button",
                { type: "button", id: "check-now", class: "primary", click: () => void run() },
                "Check it now",
            ),
        ),
        view.element,
        certificateView(certificate),
    );
}

/** A list of which the first are in sight, and the rest is folded. */
function foldedList(items: HTMLElement[], most: number): HTMLElement[] {
    const list = (part: HTMLElement[]) => make("ul", { class: "plain columns" }, ...part);
    const rest = items.slice(most);
    if (rest.length === 0) return [list(items)];
    const more = make("summary", {}, `${rest.length} more`);
    return [list(items.slice(0, most)), make("details", {}, more, list(rest))];
}

function related(title: string, explanation: string, rows: Row[]): HTMLElement[] {
    if (rows.length === 0) return [];
    return [
        make("h3", {}, `${title} (${rows.length})`),
        make("p", {}, explanation),
        ...foldedList(rows.map(line), 12),
    ];
}

function extensionsView(extensions: Extension[]): HTMLElement[] {
    if (extensions.length === 0) return [];
    const items = extensions.map(({ words, problem, number, degree }) => {
        const by = number === undefined ? "" : `, decided by class #${number}`;
        const item = make("li", {}, problemLink(problem, words), by);
        if (degree !== undefined) item.append(`, degree ${withCommas(degree)}`);
        return item;
    });
    return [
        make("h3", {}, `Extensions (${extensions.length})`),
        make("p", {}, "It stays minimal, with the same degree: the cameras do not feel the change."),
        ...foldedList(items, 6),
    ];
}

async function showRelatives(answer: ProblemAnswer, section: HTMLElement): Promise<void> {
    const { report } = answer;
    if (report.hints)
        section.append(make("h3", {}, "What makes it minimal"), hintsView(report.hints));
    section.append(...extensionsView(answer.extensions));
    if (report.number === undefined) return;
    const { swap, constraint, exchanges } = await prover.relatives(report.number);
    section.append(
        ...related("The same swap class", "They have the same terminal problem.", swap),
        ...related(
            "The same constraint class",
            "They have the same camera equations, and so the same degree.",
            constraint,
        ),
        ...related("One feature exchanged", "For another of the same weight.", exchanges),
    );
}

/** Where the table of contents will stand. */
const contentsPlace = { class: "contents", "aria-label": "On this page", hidden: true } as const;

function section(id: string, title: string): HTMLElement {
    return make("section", { "aria-labelledby": id }, make("h2", { id }, title));
}

async function show(spec: string): Promise<void> {
    const answer = await prover.problem(spec);
    if ("general" in answer) showGeneralProblem(answer, place);
    else await showProblem(answer, spec);
    showContents();
    place.dataset.ready = "yes";
}

async function showProblem(answer: ProblemAnswer, spec: string): Promise<void> {
    const { report } = answer;
    const number =
        report.number !== undefined && report.standing === "member" ? `#${report.number}` : "";
    const title = [...answer.names.slice(0, 1), number].filter((word) => word !== "").join(", ");
    document.title = `${title || report.problem} · Atlas of point-line problems`;
    const page = problemAddress(number === "" ? report.problem : number.slice(1));
    const files = section("downloads", "Downloads");
    files.append(downloads(answer));
    const cite = section("cite", "Cite this page");
    cite.append(
        citationView({
            what: `problem ${[number, answer.names[0] ?? "", report.problem]
                .filter((word) => word !== "")
                .join(", ")}`,
            key: number === "" ? "problem" : number.slice(1),
            page,
        }),
    );
    const certificate = section("certificate", "Certificate");
    const degree = section("degree", "Degree");
    const relatives = section("related", "Related problems");
    place.replaceChildren(
        make("h1", {}, title || "A problem"),
        make("p", { class: "asked" }, notation(report.problem)),
        make("p", { class: "quiet" }, `${answer.description}.`),
        make(
            "div",
            { class: "overview" },
            make(
                "div",
                {},
                make("figure", {}, photos(answer.scene, report.problem)),
                verdictView(report),
                facts(factRows(answer)),
                make(
                    "p",
                    {},
                    make(
                        "a",
                        { href: problemAddress(spec).replace("problem", "search") },
                        "Change it on the drawing board",
                    ),
                ),
            ),
            make("div", {}, sketch(answer.scene), make("nav", contentsPlace)),
        ),
        certificate,
        make("div", { class: "two-columns" }, degree, files),
        relatives,
        cite,
    );
    await showCertificate(answer, certificate);
    await degreeChecks(report, degree);
    await showRelatives(answer, relatives);
}

function wordsOf(error: unknown): string {
    return error instanceof Complaint ? error.message : `The program failed: ${String(error)}`;
}

function complain(error: unknown): void {
    place.replaceChildren(
        make("h1", {}, "No such problem"),
        make("p", { class: "complaint" }, wordsOf(error)),
        make("p", {}, make("a", { href: "search.html" }, "Search the atlas")),
    );
}

show(new URLSearchParams(location.search).get("p") ?? "").catch(complain);
