// Ask about one problem, in notation or drawn; or search all classes. Both are in the address.
import { Board } from "./board.js";
import { afterPause, byId, make, withCommas } from "./elements.js";
import { generalFacts, generalVerdictView } from "./general_problem.js";
import { allModels, withWords } from "./model.js";
import { card, line, problemLink } from "./problem_links.js";
import { photos } from "./photos.js";
import { Complaint, type GeneralAnswer, type ProblemAnswer, Prover } from "./prover.js";
import { factRows, facts, hintsView, notation, verdictView } from "./verdict_view.js";

const rowsOfPage = 24;
const prover = new Prover();
const spec = byId("spec", HTMLInputElement);
const answerPlace = byId("answer", HTMLElement);
const messagePlace = byId("ask-message", HTMLElement);
const form = byId("filters", HTMLFormElement);
const resultPlace = byId("results", HTMLElement);
const totalPlace = byId("total", HTMLElement);
const pager = byId("pager", HTMLElement);
let first = 0;

const board = new Board((text) => {
    spec.value = text;
    void decide(text);
    keepInAddress();
});
byId("board", HTMLElement).append(board.element);

// What the reader asks now; answers to earlier questions are dropped.
let current = 0;

async function decide(text: string): Promise<void> {
    const question = ++current;
    if (text.trim() === "") {
        accept();
        answerPlace.replaceChildren();
        board.showNothing();
        return;
    }
    try {
        const answer = await prover.problem(text);
        if (question !== current) return;
        if ("general" in answer) showGeneralAnswer(answer);
        else await showAnswer(answer, question);
    } catch (error) {
        if (question !== current) return;
        showComplaint(error);
        await showModels(text, question);
    }
}

/** What is no problem may be what a model is called. */
async function showModels(text: string, question: number): Promise<void> {
    const fewest = 3;
    if (text.trim().length < fewest) return;
    const found = withWords(await allModels().catch(() => []), text);
    if (question !== current || found.length === 0) return;
    const links = found.map(({ name, title }) =>
        make("li", {}, make("a", { href: `models.html#${name}` }, title)),
    );
    answerPlace.replaceChildren(
        make("p", {}, "Models with these words, which are given by equations:"),
        make("ul", { class: "plain" }, ...links),
    );
}

function showComplaint(error: unknown): void {
    const words =
        error instanceof Complaint ? error.message : `The program failed: ${String(error)}`;
    spec.setAttribute("aria-invalid", "true");
    messagePlace.replaceChildren(make("p", { class: "complaint" }, words));
    answerPlace.replaceChildren();
}

/** What is typed makes sense. */
function accept(): void {
    spec.removeAttribute("aria-invalid");
    messagePlace.replaceChildren();
}

/** A problem that the drawing board cannot show. */
function showGeneralAnswer({ general: report, scene }: GeneralAnswer): void {
    accept();
    board.showOnly(
        photos(scene, report.problem),
        "The board changes what up to three calibrated cameras see of lines with at most one point.",
    );
    answerPlace.replaceChildren(
        make("p", { class: "asked" }, notation(report.problem)),
        generalVerdictView(report),
        make("p", {}, problemLink(report.problem, "Its page: certificate, check, download")),
        generalFacts(report),
    );
}

async function showAnswer(answer: ProblemAnswer, question: number): Promise<void> {
    const { report } = answer;
    accept();
    board.show(answer.features, answer.scene, report.problem);
    const neighbours = make("div");
    answerPlace.replaceChildren(
        make("p", { class: "asked" }, notation(report.problem)),
        verdictView(report),
        make("p", {}, problemLink(report.problem, "Its page: certificate, check, downloads")),
        facts(factRows(answer)),
        neighbours,
    );
    if (report.hints)
        neighbours.append(make("h3", {}, "What makes it minimal"), hintsView(report.hints));
    if (report.number === undefined || report.standing !== "member") return;
    neighbours.append(make("h3", {}, "Neighbours: one feature exchanged"));
    const list = make("ul", { class: "plain columns" }, make("li", {}, "Looking …"));
    neighbours.append(list);
    const { exchanges } = await prover.relatives(report.number);
    if (question === current) list.replaceChildren(...exchanges.map(line));
}

/** The filters as options of `plprove list`. */
function options(): string[] {
    const words: string[] = [];
    for (const [name, value] of new FormData(form)) {
        const text = String(value).trim();
        if (text === "" || name === "sort" || name === "order") continue;
        if (name === "verdict" || text === "on") words.push(`--${text === "on" ? name : text}`);
        else words.push(`--${name}`, text);
    }
    return words;
}

async function search(): Promise<void> {
    const data = new FormData(form);
    markField("", "");
    const descending = data.get("order") === "descending";
    try {
        const start = performance.now();
        const answer = await prover.search(
            options(),
            String(data.get("sort")),
            descending,
            first,
            rowsOfPage,
        );
        resultPlace.dataset.milliseconds = String(Math.round(performance.now() - start));
        totalPlace.textContent = `${withCommas(answer.total)} of 143,494 classes`;
        resultPlace.replaceChildren(...answer.rows.map(card));
        showPager(answer.total);
    } catch (error) {
        const words = error instanceof Complaint ? error.message : String(error);
        totalPlace.textContent = words;
        const [, option = ""] = /--([a-z-]+)/.exec(words) ?? [];
        markField(option, words);
        resultPlace.replaceChildren();
        pager.replaceChildren();
    }
}

/** Shows a complaint beside the field of this name; at other fields none. */
function markField(name: string, words: string): void {
    for (const control of form.elements) {
        if (!(control instanceof HTMLInputElement) || control.type !== "text") continue;
        control.removeAttribute("aria-invalid");
        control.parentElement?.querySelector(".field-message")?.remove();
        if (control.name !== name) continue;
        control.setAttribute("aria-invalid", "true");
        control.after(make("span", { class: "field-message" }, words.replace(/^--[a-z-]+: /, "")));
    }
}

function showPager(total: number): void {
    const turn = (label: string, to: number, possible: boolean) =>
        make(
            "button",
            {
                type: "button",
                disabled: !possible,
                click: () => {
                    first = to;
                    keepInAddress();
                    void search();
                    totalPlace.scrollIntoView();
                },
            },
            label,
        );
    const last = Math.min(first + rowsOfPage, total);
    pager.replaceChildren(
        turn("Previous", Math.max(0, first - rowsOfPage), first > 0),
        ` ${total === 0 ? 0 : withCommas(first + 1)} to ${withCommas(last)} `,
        turn("Next", first + rowsOfPage, last < total),
    );
}

function keepInAddress(): void {
    const address = new URLSearchParams();
    if (spec.value.trim() !== "") address.set("p", spec.value);
    for (const [name, value] of new FormData(form))
        if (String(value) !== "" && !isDefault(name, String(value)))
            address.append(name, String(value));
    if (first > 0) address.set("first", String(first));
    const query = address.toString();
    history.replaceState(null, "", query === "" ? location.pathname : `?${query}`);
}

function isDefault(name: string, value: string): boolean {
    return (name === "sort" && value === "size") || (name === "order" && value === "ascending");
}

function readAddress(): void {
    const address = new URLSearchParams(location.search);
    spec.value = address.get("p") ?? "";
    first = Math.max(0, Math.floor(Number(address.get("first") ?? 0))) || 0;
    for (const control of form.elements) {
        if (control instanceof HTMLInputElement && control.type === "checkbox")
            control.checked = address.has(control.name);
        else if (control instanceof HTMLInputElement || control instanceof HTMLSelectElement)
            control.value = address.get(control.name) ?? control.dataset.default ?? "";
    }
}

readAddress();
void decide(spec.value);
void search();
spec.addEventListener(
    "input",
    afterPause(() => {
        keepInAddress();
        void decide(spec.value);
    }),
);
byId("ask", HTMLFormElement).addEventListener("submit", (event) => {
    event.preventDefault();
    void decide(spec.value);
});
form.addEventListener("submit", (event) => event.preventDefault());
form.addEventListener(
    "input",
    afterPause(() => {
        first = 0;
        keepInAddress();
        void search();
    }),
);
byId("clear-filters", HTMLButtonElement).addEventListener("click", () => {
    form.reset();
    first = 0;
    keepInAddress();
    void search();
});
