// The scene with its cameras, in space: a sketch that turns when it is dragged, by the arrow keys,
// and by buttons.
import { make } from "./elements.js";
import { nameOfLine, nameOfPoint, shape } from "./photos.js";
import {
    add,
    type Camera,
    placeScene,
    type PlacedScene,
    type Scene,
    sees,
    type Vector,
} from "./scene.js";

const width = 400;
const height = 320;
const step = 12;

/** How far the reader's eye is from the middle. */
const distance = 13;

/** The middle of the turning is this place, between scene and cameras. */
const middle: Vector = [0, -0.3, 1.5];

interface Turn {
    /** Degrees about the vertical, and up or down. */
    around: number;
    above: number;
    scale: number;
}

const standard = { around: 64, above: 30 };

/** So that cameras and scene are on the sheet, however they are turned about the vertical. */
function scaleFor({ cameras, points, lines }: PlacedScene): number {
    const places = [...points, ...lines.flatMap(({ from, to }) => [from, to])];
    for (const { place, ahead } of cameras) places.push(add(place, ahead, -0.4));
    const farthest = Math.max(
        ...places.map((place) => {
            const [x, , z] = add(place, middle, -1);
            return Math.hypot(x, z);
        }),
    );
    return ((width / 2 - 8) * (distance - 0.15 * farthest)) / farthest;
}

/** Where a place appears in the sketch. */
function onSheet(place: Vector, { around, above, scale }: Turn): [number, number] {
    const [x, y, z] = add(place, middle, -1);
    const [a, b] = [(around * Math.PI) / 180, (above * Math.PI) / 180];
    const right = x * Math.cos(a) - z * Math.sin(a);
    const near = x * Math.sin(a) + z * Math.cos(a);
    const up = y * Math.cos(b) - near * Math.sin(b);
    const depth = distance - (near * Math.cos(b) + y * Math.sin(b));
    return [width / 2 + (scale * right) / depth, height / 2 - (scale * up) / depth];
}

function line(from: Vector, to: Vector, turn: Turn, name: string): SVGElement {
    const [x1, y1] = onSheet(from, turn);
    const [x2, y2] = onSheet(to, turn);
    return shape("line", { class: name, x1, y1, x2, y2 });
}

function text(words: string, at: [number, number], name = "letter"): SVGElement {
    return shape("text", { class: name, x: at[0], y: at[1] }, words);
}

/** Points, lines and cameras that can move while no photo changes, by their numbers from 0. */
export interface Moving {
    points: number[];
    lines: number[];
    cameras: number[];
}

/** A pyramid with its picture: the corners of what the camera sees. */
function pyramid(camera: Camera, view: number, turn: Turn, moves: boolean): SVGElement[] {
    const corners = [
        [-1, -0.75],
        [1, -0.75],
        [1, 0.75],
        [-1, 0.75],
    ].map(([x = 0, y = 0]) =>
        add(
            add(add(camera.place, camera.ahead, 0.62), camera.right, 0.36 * x),
            camera.up,
            0.36 * y,
        ),
    );
    const parts = corners.flatMap((corner, index) => [
        line(camera.place, corner, turn, moves ? "camera moving" : "camera"),
        line(corner, corners[(index + 1) % 4] as Vector, turn, moves ? "camera moving" : "camera"),
    ]);
    const [x, y] = onSheet(add(camera.place, camera.ahead, -0.42), turn);
    return [...parts, text(String(view + 1), [x, y], "camera-name")];
}

/** A square under the scene, so that one sees what is below. */
function ground(turn: Turn): SVGElement[] {
    const level = -1.35;
    const end = 1.6;
    return [-2, -1, 0, 1, 2].flatMap((k) => [
        line([(k * end) / 2, level, -end], [(k * end) / 2, level, end], turn, "ground"),
        line([-end, level, (k * end) / 2], [end, level, (k * end) / 2], turn, "ground"),
    ]);
}

/** From each camera to the points that it sees; of many, none. */
function rays(scene: Scene, placed: PlacedScene, turn: Turn): SVGElement[] {
    if (scene.points.length * scene.views > 24) return [];
    return placed.cameras.flatMap((camera, view) =>
        placed.points.flatMap((point, index) =>
            sees(scene.points[index] ?? 0, view) ? [line(camera.place, point, turn, "ray")] : [],
        ),
    );
}

/** A little beyond the end of a segment on the sheet. */
function beyond([x1, y1]: [number, number], [x2, y2]: [number, number]): [number, number] {
    const angle = Math.atan2(y2 - y1, x2 - x1);
    return [x2 + 9 * Math.cos(angle), y2 + 4 + 9 * Math.sin(angle)];
}

function draw(scene: Scene, placed: PlacedScene, turn: Turn, moving: Moving): SVGElement[] {
    const name = (moves: boolean) => (moves ? "seen moving" : "seen");
    const segments = placed.lines.flatMap(({ from, to }, index) => [
        line(from, to, turn, name(moving.lines.includes(index))),
        text(nameOfLine(index), beyond(onSheet(from, turn), onSheet(to, turn))),
    ]);
    const dots = placed.points.flatMap((point, index) => {
        const [cx, cy] = onSheet(point, turn);
        return [
            shape("circle", { class: name(moving.points.includes(index)), cx, cy, r: 3.6 }),
            text(nameOfPoint(index), [cx + 9, cy - 5]),
        ];
    });
    const cameras = placed.cameras.flatMap((camera, view) =>
        pyramid(camera, view, turn, moving.cameras.includes(view)),
    );
    return [...ground(turn), ...rays(scene, placed, turn), ...cameras, ...segments, ...dots];
}

const keys: Readonly<Record<string, readonly [number, number]>> = {
    ArrowLeft: [-step, 0],
    ArrowRight: [step, 0],
    ArrowUp: [0, step],
    ArrowDown: [0, -step],
};

const nothing: Moving = { points: [], lines: [], cameras: [] };

/** The sketch, with its buttons. */
export function sketch(scene: Scene, moving = nothing): HTMLElement {
    const placed = placeScene(scene);
    const turn = { ...standard, scale: scaleFor(placed) };
    const sheet = shape("svg", {
        class: "space",
        viewBox: `0 0 ${width} ${height}`,
        "aria-hidden": "true",
    });
    const frame = make(
        "div",
        {
            class: "sketch-frame",
            tabindex: "0",
            role: "group",
            "aria-label": `The scene and its ${scene.views} cameras in space. Arrow keys turn it.`,
        },
    );
    frame.append(sheet);
    const show = () => {
        sheet.replaceChildren(...draw(scene, placed, turn, moving));
        frame.dataset.turn = `${Math.round(turn.around)} ${Math.round(turn.above)}`;
    };
    const turnBy = (around: number, above: number) => {
        turn.around += around;
        turn.above = Math.max(-80, Math.min(85, turn.above + above));
        show();
    };
    frame.addEventListener("keydown", (event) => {
        const by = keys[event.key];
        if (!by) return;
        event.preventDefault();
        turnBy(...by);
    });
    frame.addEventListener("pointerdown", (event) => frame.setPointerCapture(event.pointerId));
    frame.addEventListener("pointermove", (event) => {
        if (frame.hasPointerCapture(event.pointerId))
            turnBy(-event.movementX / 2, event.movementY / 2);
    });
    show();
    swing(turn, show);
    const button = (words: string, label: string, around: number, above: number) =>
        make(
            "button",
            { type: "button", "aria-label": label, click: () => turnBy(around, above) },
            words,
        );
    return make(
        "figure",
        { class: "sketch" },
        frame,
        make(
            "figcaption",
            {},
            make(
                "span",
                { class: "turns" },
                button("←", "Turn left", -step, 0),
                button("→", "Turn right", step, 0),
                button("↑", "Turn up", 0, step),
                button("↓", "Turn down", 0, -step),
            ),
            ` One scene and its ${scene.views} cameras. Drag it to turn it.` +
                (moving === nothing ? "" : " What can move while no photo changes is red."),
        ),
    );
}

/** At the beginning it turns a little, so that it looks like space; not for readers who want rest. */
function swing(turn: Turn, show: () => void): void {
    if (!window.matchMedia("(prefers-reduced-motion: no-preference)").matches) return;
    const start = performance.now();
    let before = 0;
    const move = (now: number) => {
        const part = Math.min(1, (now - start) / 1600);
        const way = 24 * part * part * (3 - 2 * part);
        turn.around += way - before;
        before = way;
        show();
        if (part < 1) requestAnimationFrame(move);
    };
    turn.around -= 24;
    requestAnimationFrame(move);
}
