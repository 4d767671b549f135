// What the program decides of a problem, for people: the verdict, why, and what follows.
import { make, withCommas, type Child } from "./elements.js";
import { term } from "./glossary.js";
import { problemLink, statusMark } from "./problem_links.js";
import type { Degree, Families, Group, Hint, ProblemAnswer, Report } from "./prover.js";

const neither = (why: Child): Child[] => [
    "Neither ",
    term("minimal"),
    " nor ",
    term("camera-minimal"),
    ": ",
    why,
];

export function verdictInWords({ verdict }: Report): Child[] {
    if (verdict === "minimal") return [term("minimal", "Minimal")];
    if (verdict === "camera-minimal")
        return [term("camera-minimal", "Camera-minimal"), ", but not minimal"];
    return neither(verdict === "obstructed" ? term("obstructed") : verdict);
}

export function notation(text: string): HTMLElement {
    return make("span", { class: "notation" }, text === "" ? "nothing" : text);
}

/** The verdict as a heading, and the reasons. */
export function verdictView(report: Report): HTMLElement {
    return make(
        "div",
        { class: `verdict ${report.camera_minimal ? "holds" : "fails"}` },
        make("p", { class: "verdict-word" }, ...verdictInWords(report)),
        ...report.reasons.map((reason) => make("p", {}, sentence(reason))),
    );
}

function sentence(text: string): string {
    return `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
}

export function familyNames(families: Families): Child[][] {
    const names: [boolean, Child[]][] = [
        [families.pl0p, ["free points and free lines only (", term("PL0P"), ")"]],
        [families.at_most_one_pin, ["at most one ", term("pin"), " per point"]],
        [
            families.plmp !== null,
            [term("complete visibility"), `: ${families.plmp ?? ""} in PLMP`],
        ],
        [
            families.five_point_extension,
            [term("five-point extension", "extension of the five-point problem")],
        ],
        [families.registration, [term("camera registration")]],
        [families.trifocal_linear, ["one of the 66 problems linear in the trifocal tensor"]],
    ];
    return names.filter(([member]) => member).map(([, name]) => name);
}

/** A degree, and how sure it is. */
export function degreeView(degree: Degree): HTMLElement {
    return make(
        "span",
        {},
        make("strong", {}, withCommas(degree.value)),
        " ",
        statusMark(degree.status),
    );
}

/** What rows are called, and the word of the glossary that says what it means. */
const words: Readonly<Record<string, string>> = {
    class: "label class",
    degree: "degree",
    group: "group",
    width: "width",
    dimensions: "dimensions",
    reduction: "reduction",
    terminal: "terminal",
};

function rowName(name: string): Child {
    const word = words[name];
    return word === undefined ? name : term(word, name);
}

/** A table of names and what stands for them. */
export function facts(rows: [string, Child[]][]): HTMLElement {
    const list = make("dl", { class: "facts-list" });
    for (const [name, value] of rows)
        list.append(make("dt", {}, rowName(name)), make("dd", {}, ...value));
    return list;
}

/** The rows of a group of so many solutions: its name, and where it decomposes its width. */
export function groupRows({ name, width, status }: Group, solutions: number): [string, Child[]][] {
    const rows: [string, Child[]][] = [["group", [`${name} `, statusMark(status)]]];
    if (width < solutions) rows.push(["width", [`${width} `, statusMark(status)]]);
    return rows;
}

/** The rows of facts that search and the page of a problem share. */
export function factRows(answer: ProblemAnswer): [string, Child[]][] {
    const { report, explanations } = answer;
    const rows: [string, Child[]][] = [];
    if (report.number !== undefined) {
        const standing = report.standing === "member" ? "" : " (it is decided by this class)";
        rows.push(["class", [problemLink(report.number, `#${report.number}`), standing]]);
    }
    if (answer.names.length > 0) rows.push(["name", [answer.names.join(", ")]]);
    if (report.degree) rows.push(["degree", [degreeView(report.degree)]]);
    if (report.group && report.degree) rows.push(...groupRows(report.group, report.degree.value));
    rows.push(["dimensions", [dimensionsInWords(report)]]);
    if (report.reduction.length > 0) {
        const steps = report.reduction.map((step, index) =>
            make(
                "li",
                {},
                notation(step.feature),
                " becomes ",
                notation(step.result ?? ""),
                `: ${explanations[index] ?? ""}`,
            ),
        );
        rows.push(["reduction", [make("ol", { class: "plain" }, ...steps)]]);
        rows.push(["reduced", [notation(report.reduced)]]);
    }
    if (report.terminal !== undefined && report.views === 3)
        rows.push(["terminal", [notation(report.terminal)]]);
    if (report.families) {
        const names = familyNames(report.families);
        const joined = names.flatMap((name, index) => (index === 0 ? name : ["; ", ...name]));
        rows.push(["families", names.length > 0 ? joined : ["none of the named ones"]]);
    }
    return rows;
}

function dimensionsInWords({ dimensions }: Report): string {
    const { scene, cameras, images, balanced } = dimensions;
    return balanced
        ? `scene ${scene} + cameras ${cameras} = images ${images}: balanced`
        : `scene ${scene} + cameras ${cameras} against images ${images}: unbalanced`;
}

function hintInWords(hint: Hint): string {
    if (hint.add && hint.drop) return `Put ${hint.add} for ${hint.drop}`;
    return hint.add ? `Add ${hint.add}` : `Drop ${hint.drop ?? ""}`;
}

/** What makes the problem minimal: changes by one feature. */
export function hintsView(hints: Hint[]): HTMLElement {
    const items = hints.map((hint) => {
        const item = make(
            "li",
            {},
            problemLink(hint.problem, hintInWords(hint)),
            `: ${hint.verdict}`,
            hint.number === undefined ? "" : `, #${hint.number}`,
        );
        if (hint.degree) item.append(`, degree ${withCommas(hint.degree.value)}`);
        return item;
    });
    return make("ul", { class: "plain columns" }, ...items);
}
