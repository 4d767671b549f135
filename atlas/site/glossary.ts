// The words of the field, each in a sentence or two: shown where a word is pointed at or focused, and
// all together on the page that explains how it works.
import { make } from "./elements.js";

export const glossary: Readonly<Record<string, string>> = {
    problem:
        "Some points and lines, and what each photo sees of them. The question is where the cameras were.",
    minimal:
        "Generic photos of the problem leave finitely many solutions, at least one. Each datum counts: with one less there would be infinitely many.",
    "camera-minimal":
        "Generic photos leave finitely many solutions for the cameras, at least one. Parts of the scene may stay open.",
    generic: "As most photos are: all but those that satisfy an equation of their own, such as three points in a line.",
    degree:
        "How many solutions a problem has for generic photos, counted over the complex numbers. A solver has to find all of them, so a small degree means a fast solver.",
    group: "How loops of photos permute the solutions. S312 means: in every way, so the problem with its 312 solutions does not decompose into smaller ones. <S8 wr S2 wr S10 means: 10 blocks of 2 blocks of 8 solutions stay together, so there are steps with 10, 2 and 8 solutions.",
    width: "How many solutions the hardest step of the problem has. It is less than the degree where solutions stay together in blocks.",
    obstructed: "Not minimal for a reason that has a name: see obstruction.",
    dimensions:
        "How many numbers it takes to say where the scene is, where the cameras are, and what the images show.",
    pin: "A line through one point of the problem. A photo may see both, one of them, or neither.",
    "free line": "A line through no point of the problem.",
    feature: "A free line, or a point with the lines through it.",
    notation:
        "A feature says what views 1/2/3 see of it: P is the point, each letter a line, - nothing. 2* means two of a kind.",
    "label class":
        "Problems that differ by the order of their views only. The paper lists 143,494 of them as candidates, and numbers them.",
    "swap class":
        "Label classes with the same terminal problem: they differ by a swap of features that changes no camera.",
    "constraint class": "Classes whose cameras satisfy the same equations, so they have the same degree.",
    terminal:
        "The core of a camera-minimal problem: what says nothing of the cameras is gone, pins that may go, too. Problems with the same core have the same degree.",
    reduction: "Features and pins that say nothing of the cameras are taken away, step by step.",
    balanced:
        "The images have as many numbers as scene and cameras together. Each minimal problem is balanced.",
    obstruction:
        "A reason why a balanced problem is not minimal. Epipolar: two views share six points or more. Star: a point with three pins or more lets a camera slide.",
    "complete visibility": "Every photo sees every point and every line.",
    "five-point extension":
        "A problem in which two photos share exactly five points: these fix two cameras, with 20 solutions, and the rest fixes the third.",
    "camera registration": "Finding one more camera when scene and other cameras are known.",
    PL0P: "A problem of free points and free lines only: no pins.",
    calibrated: "A camera whose focal length and principal point are known. Where it was and how it was turned is not.",
    projective: "A camera of which nothing is known but that straight lines stay straight.",
    certificate:
        "A file that proves a verdict to anyone who replays it: a scene in small integers and a number, or a reason.",
    Jacobian:
        "The matrix that says how much each image moves when cameras and features move a little.",
    certified: "It follows from a certificate that was replayed, and from the proofs of the repository.",
    evidence: "A computation suggests it. Computations of this kind can be wrong.",
};

/** A page's address of a word. */
function wordId(word: string): string {
    return `word-${word.replaceAll(" ", "-").toLowerCase()}`;
}

/** A word that says what it means when it is pointed at or focused; `shown` stands in the page. */
export function term(word: string, shown = word): HTMLAnchorElement {
    return make("a", { class: "term", href: `how.html#${wordId(word)}`, "data-term": word }, shown);
}

/** All words, for a page. */
export function glossaryView(): HTMLElement {
    const list = make("dl", { class: "glossary" });
    const words = Object.keys(glossary).sort((a, b) => a.localeCompare(b, "en"));
    for (const word of words)
        list.append(
            make("dt", { id: wordId(word) }, word),
            make("dd", {}, glossary[word] ?? ""),
        );
    return list;
}

/** Lets every word of the page say what it means. */
export function explainTerms(): void {
    const tip = make("div", { id: "tip", class: "tip", role: "tooltip", hidden: true });
    document.body.append(tip);
    let hides = 0;
    const hide = () => {
        tip.hidden = true;
        document.querySelector("[aria-describedby=tip]")?.removeAttribute("aria-describedby");
    };
    const showFor = (target: EventTarget | null) => {
        const word = target instanceof HTMLElement ? target.closest<HTMLElement>(".term") : null;
        const words = glossary[word?.dataset.term ?? ""];
        if (!word || words === undefined) return;
        clearTimeout(hides);
        hide();
        tip.textContent = words;
        tip.hidden = false;
        word.setAttribute("aria-describedby", "tip");
        const { left, top, bottom } = word.getBoundingClientRect();
        const room = document.documentElement.clientWidth - tip.offsetWidth - 8;
        const below = bottom + tip.offsetHeight + 8 < window.innerHeight;
        tip.style.left = `${window.scrollX + Math.max(8, Math.min(left, room))}px`;
        tip.style.top = `${window.scrollY + (below ? bottom + 4 : top - tip.offsetHeight - 4)}px`;
    };
    // Those who read a tip may point at it, too.
    const hideSoon = () => {
        clearTimeout(hides);
        hides = setTimeout(hide, 250);
    };
    document.addEventListener("mouseover", (event) => {
        if (tip.contains(event.target as Node)) clearTimeout(hides);
        else showFor(event.target);
    });
    document.addEventListener("mouseout", hideSoon);
    document.addEventListener("focusin", (event) => showFor(event.target));
    document.addEventListener("focusout", hideSoon);
    document.addEventListener("keydown", (event) => {
        if (event.key === "Escape") hide();
    });
}
