// Play: the reader moves photos, points and cameras, and sees all real solutions move.
import { byId, make } from "./elements.js";
import { PhotoView } from "./demo_photo.js";
import { problems, Scene, type Camera } from "./demo_scene.js";
import { SketchView } from "./demo_sketch.js";
import { ImageSolver, type Answer } from "./demo_solver.js";

const demo = byId("demo", HTMLElement);
const problemChoice = byId("problem", HTMLSelectElement);
const noise = byId("noise", HTMLInputElement);
const noiseShown = byId("noise-shown", HTMLOutputElement);
const onlyFront = byId("only-front", HTMLInputElement);
const moving = byId("moving", HTMLInputElement);
const chosenOne = byId("chosen", HTMLInputElement);
const chosenShown = byId("chosen-shown", HTMLOutputElement);

/** What is in front of a reader: a scene, its views, and a solver. */
interface Stage {
    scene: Scene;
    solver: ImageSolver;
    photos: PhotoView[];
    sketch: SketchView;
}

let stage: Stage;
let answer: Answer | undefined;
/** Whether the reader follows the solution that is nearest to the true cameras. */
let followsTruth = true;
let pictures: number[] = [];

/** The largest difference of an entry: of a rotation, or of a translation. */
function distance(a: readonly Camera[], b: readonly Camera[]): number {
    const numbers = (cameras: readonly Camera[]) =>
        cameras.flatMap(({ rows, t }) => [...rows.flat(), ...t]);
    const others = numbers(b);
    return Math.max(...numbers(a).map((x, k) => Math.abs(x - others[k]!)));
}

/** The solution that is nearest to the true cameras, and how far it is from them. */
function nearestToTruth({ solutions }: Answer): { index: number; off: number } {
    const truth = stage.scene.normalisedCameras();
    let nearest = { index: -1, off: Infinity };
    for (const [index, solution] of solutions.entries()) {
        const off = distance(solution.cameras, truth);
        if (off < nearest.off) nearest = { index, off };
    }
    return nearest;
}

function tell(id: string, text: string): void {
    const place = byId(id, HTMLElement);
    if (place.textContent !== text) place.textContent = text;
}

/** How many pictures a second there were lately. */
function rate(): number {
    const seconds = (pictures.at(-1)! - pictures[0]!) / 1000;
    return pictures.length > 1 && seconds > 0 ? (pictures.length - 1) / seconds : 0;
}

function countPicture(): void {
    const now = performance.now();
    // A pause begins a new count.
    if (now - (pictures.at(-1) ?? 0) > 1500) pictures = [];
    pictures = [...pictures.slice(-30), now];
    demo.dataset["pictures"] = String(Number(demo.dataset["pictures"] ?? 0) + 1);
}

function draw(): void {
    if (!answer) return;
    const { solutions, degree, found, certified, milliseconds } = answer;
    const truth = nearestToTruth(answer);
    const all = stage.scene.points.length;
    const front = solutions.filter((solution) => solution.inFront === all);
    const shown = onlyFront.checked ? front : solutions;
    chosenOne.max = String(Math.max(1, shown.length));
    let choice = Number(chosenOne.value) - 1;
    if (followsTruth) choice = shown.indexOf(solutions[truth.index]!);
    choice = Math.min(choice, shown.length - 1);
    if (choice >= 0) chosenOne.value = String(choice + 1);
    stage.sketch.show(shown, choice);
    for (const view of stage.photos) view.update();

    const chosen = shown[choice];
    const chosenText = chosen
        ? `${choice + 1} of ${shown.length}: ${chosen.inFront} of ${all} points in front`
        : "none";
    if (chosenShown.value !== chosenText) chosenShown.value = chosenText;
    tell(
        "complex",
        certified
            ? `${found} of ${degree}; that there are no more is certified`
            : `${found} of ${degree}; ${degree - found} lost`,
    );
    tell("real", String(solutions.length));
    tell("front", String(front.length));
    const exact = stage.scene.isExact();
    const number = shown.indexOf(solutions[truth.index]!) + 1;
    const which = number > 0 ? `solution ${number}` : "a solution that is not shown";
    if (truth.index < 0) tell("truth", "no real solution is left");
    else if (exact && truth.off < 1e-6)
        tell("truth", `found: ${which}, off by ${truth.off.toExponential(0)}`);
    else tell("truth", `nearest: ${which}, off by ${truth.off.toPrecision(2)}`);
    const perSecond = rate();
    tell("rate", perSecond > 0 ? `${perSecond.toFixed(perSecond < 10 ? 1 : 0)} a second` : "one");
    tell("time", `${milliseconds.toFixed(milliseconds < 10 ? 1 : 0)} ms`);
    demo.dataset["real"] = String(solutions.length);
    demo.dataset["found"] = String(found);
    demo.dataset["off"] = String(truth.off);
}

let busy = false;
let stale = false;
let rest = 0;

/** Solves what the photos show now, and again while they change. */
async function solve(quick: boolean): Promise<void> {
    stale = true;
    if (busy) return;
    busy = true;
    clearTimeout(rest);
    const mine = stage;
    delete demo.dataset["settled"];
    try {
        while (stale && mine === stage) {
            stale = false;
            if (moving.checked) moveByItself();
            const next = await mine.solver.solve(mine.scene.images(), quick);
            if (mine !== stage) break;
            answer = next;
            byId("complaint", HTMLElement).hidden = true;
            draw();
            countPicture();
            await new Promise((resolve) => requestAnimationFrame(resolve));
            stale ||= moving.checked;
        }
    } catch (error) {
        const complaint = byId("complaint", HTMLElement);
        complaint.hidden = false;
        complaint.textContent = error instanceof Error ? error.message : String(error);
    }
    busy = false;
    if (mine !== stage) return;
    // At rest there is time for the paths that were lost.
    if (quick && answer && answer.found < answer.degree)
        rest = setTimeout(() => void solve(false), 300);
    else settled();
}

/** Says once, to those who listen, what came of it. */
function settled(): void {
    demo.dataset["settled"] = "";
    if (!answer) return;
    const front = byId("front", HTMLElement).textContent;
    const real = answer.solutions.length;
    tell("summary", `${real} real solutions, ${front} with all points in front.`);
}

function changed(): void {
    for (const view of stage.photos) view.update();
    stage.sketch.update();
    void solve(true);
}

let phase = 0;

/** Takes camera 2 a little further on its way. */
function moveByItself(): void {
    const before = phase;
    phase += 0.03;
    const step = (at: number) => [0.5 * Math.sin(at), 0.3 * Math.sin(1.7 * at)] as const;
    const [x, y] = step(phase);
    const [a, b] = step(before);
    stage.scene.moveCamera(1, [x - a, y - b, 0]);
    stage.sketch.update();
}

/** Puts a problem and a scene on the stage. */
async function raise(id: string, seed: number): Promise<void> {
    const problem = problems.find((one) => one.id === id) ?? problems[0]!;
    const scene = new Scene(problem, seed);
    const kept = stage?.solver.problem === problem && !busy ? stage.solver : undefined;
    if (!kept) stage?.solver.close();
    const solver = kept ?? new ImageSolver(problem);
    const photos = scene.centres.map((_, view) => new PhotoView(scene, view, changed));
    const sketch = new SketchView(scene, changed);
    stage = { scene, solver, photos, sketch };
    answer = undefined;
    busy = false;
    followsTruth = true;
    scene.noise = Number(noise.value);
    problemChoice.value = problem.id;
    demo.dataset["problem"] = problem.id;
    byId("photos", HTMLElement).replaceChildren(...photos.map((view) => view.element));
    byId("sketch", HTMLElement).replaceChildren(sketch.element);
    const page = `problem.html?p=${encodeURIComponent(problem.notation)}`;
    byId("about", HTMLElement).replaceChildren(make("a", { href: page }, "The problem's page"));
    const address = new URL(location.href);
    address.searchParams.set("problem", problem.id);
    address.searchParams.set("scene", String(seed));
    history.replaceState(null, "", address);
    try {
        if (!kept) await solver.open();
    } catch (error) {
        const complaint = byId("complaint", HTMLElement);
        complaint.hidden = false;
        complaint.textContent = error instanceof Error ? error.message : String(error);
        return;
    }
    if (stage.solver === solver) await solve(true);
}

const asked = new URLSearchParams(location.search);
let seed = Number(asked.get("scene") ?? 1) || 1;

problemChoice.addEventListener("change", () => void raise(problemChoice.value, seed));
byId("another", HTMLButtonElement).addEventListener("click", () =>
    void raise(problemChoice.value, ++seed),
);
byId("reset", HTMLButtonElement).addEventListener("click", () => {
    stage.scene.reset();
    noise.value = "0";
    noiseShown.value = "0 pixels";
    changed();
});
noise.addEventListener("input", () => {
    stage.scene.noise = Number(noise.value);
    noiseShown.value = `${noise.value} pixels`;
    changed();
});
onlyFront.addEventListener("change", draw);
moving.addEventListener("change", () => void solve(true));
chosenOne.addEventListener("input", () => {
    followsTruth = false;
    draw();
});
byId("follow", HTMLButtonElement).addEventListener("click", () => {
    followsTruth = true;
    draw();
});
for (const [id, factor] of [["nearer", 1.2], ["farther", 1 / 1.2]] as const)
    byId(id, HTMLButtonElement).addEventListener("click", () => stage.sketch.zoomBy(factor));

void raise(asked.get("problem") ?? "five-points", seed);
