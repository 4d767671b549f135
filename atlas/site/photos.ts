// What each camera sees of a scene, as a photo: the same points and lines from different places.
// Black is what the photo shows, grey what it misses.
import { make } from "./elements.js";
import { placeScene, type PlacedScene, type Scene, seenAt, sees, type Vector } from "./scene.js";

const namespace = "http://www.w3.org/2000/svg";
const width = 160;
const height = 120;
const margin = 13;

export function shape(
    name: string,
    attributes: Readonly<Record<string, string | number>>,
    ...children: (Node | string)[]
): SVGElement {
    const element = document.createElementNS(namespace, name);
    for (const [key, value] of Object.entries(attributes))
        element.setAttribute(key, typeof value === "number" ? String(Math.round(value * 100) / 100) : value);
    element.append(...children);
    return element;
}

/** The names of points and lines, the same in all photos and in the sketch: 1, 2, ... and a, b, ... */
export function nameOfPoint(point: number): string {
    return String(point + 1);
}

export function nameOfLine(line: number): string {
    const round = Math.floor(line / 26);
    return String.fromCharCode("a".charCodeAt(0) + (line % 26)) + (round > 0 ? String(round) : "");
}

/** A photo's scale and middle: everything is in the frame, and not too small. */
function framings(placed: PlacedScene): ((place: Vector) => [number, number])[] {
    const boxes = placed.cameras.map((camera) => {
        const all = [...placed.points, ...placed.lines.flatMap(({ from, to }) => [from, to])];
        const seen = all.map((place) => seenAt(camera, place));
        const range = (axis: 0 | 1): [number, number] => [
            Math.min(...seen.map((place) => place[axis])),
            Math.max(...seen.map((place) => place[axis])),
        ];
        return { x: range(0), y: range(1) };
    });
    const fits = boxes.flatMap(({ x, y }) => [
        (width - 2 * margin) / Math.max(0.3, x[1] - x[0]),
        (height - 2 * margin) / Math.max(0.3, y[1] - y[0]),
    ]);
    const common = 1.5 * Math.min(...fits);
    return placed.cameras.map((camera, view) => (place) => {
        const { x, y } = boxes[view] as (typeof boxes)[number];
        const scale = Math.min(common, fits[2 * view] ?? common, fits[2 * view + 1] ?? common);
        const [u, v] = seenAt(camera, place);
        return [
            width / 2 + scale * (u - (x[0] + x[1]) / 2),
            height / 2 - scale * (v - (y[0] + y[1]) / 2),
        ];
    });
}

function label(text: string, x: number, y: number): SVGElement {
    const inside = (value: number, most: number) => Math.max(5, Math.min(most - 4, value));
    return shape("text", { class: "letter", x: inside(x, width), y: inside(y, height) + 2.5 }, text);
}

/** Of eight directions the one that is farthest from these lines. */
function freeAngle(lines: number[]): number {
    const eighths = [-1, 1, 3, 5, 0, 2, 4, 6].map((eighth) => (eighth * Math.PI) / 4);
    const clearance = (angle: number) =>
        Math.min(1, ...lines.map((line) => Math.abs(Math.sin(angle - line))));
    return eighths.reduce((best, angle) => (clearance(angle) > clearance(best) + 0.01 ? angle : best));
}

/** One photo: lines, then points, each with its number in the scene, so that others find it. */
function photo(
    scene: Scene,
    placed: PlacedScene,
    view: number,
    place: (place: Vector) => [number, number],
    labels: boolean,
): SVGElement {
    const panel = shape("g", {}, shape("rect", { class: "frame", width, height }));
    const names: SVGElement[] = [];
    const busy: number[][] = scene.points.map(() => []);
    const order = (seen: number) => (sees(seen, view) ? "seen" : "unseen");
    for (const wanted of ["unseen", "seen"])
        scene.lines.forEach(({ seen }, line) => {
            const segment = placed.lines[line];
            if (!segment || order(seen) !== wanted) return;
            const [x1, y1] = place(segment.from);
            const [x2, y2] = place(segment.to);
            panel.append(
                shape("line", { class: wanted, "data-line": line, x1, y1, x2, y2, "stroke-width": 1.5 }),
            );
            const angle = Math.atan2(y2 - y1, x2 - x1);
            for (const point of scene.lines[line]?.points ?? []) busy[point]?.push(angle);
            if (labels && wanted === "seen")
                names.push(label(nameOfLine(line), x2 + 6 * Math.cos(angle), y2 + 6 * Math.sin(angle)));
        });
    scene.points.forEach((seen, point) => {
        const [cx, cy] = place(placed.points[point] as Vector);
        panel.append(shape("circle", { class: order(seen), "data-point": point, cx, cy, r: 3 }));
        if (!labels || order(seen) !== "seen") return;
        const angle = freeAngle(busy[point] ?? []);
        const [x, y] = [cx + 8 * Math.cos(angle), cy + 8 * Math.sin(angle)];
        names.push(label(nameOfPoint(point), x, y));
    });
    panel.append(...names);
    return shape("svg", { class: "photo", viewBox: `0 0 ${width} ${height}`, "aria-hidden": "true" }, panel);
}

/** The photos of a problem side by side. Small ones have no names of points and lines. */
export function photos(scene: Scene, problem: string, size: "large" | "small" = "large"): HTMLElement {
    const placed = placeScene(scene);
    const places = framings(placed);
    const figures = places.map((place, view) => {
        const drawing = photo(scene, placed, view, place, size === "large");
        const words = make("span", { class: "photo-name", "aria-hidden": "true" }, `view ${view + 1}`);
        return make("span", { class: "photo-frame" }, drawing, ...(size === "large" ? [words] : []));
    });
    const count = scene.views > 3 ? "many" : scene.views === 2 ? "two" : "few";
    return make(
        "div",
        { class: `photos ${size} ${count}`, role: "img", "aria-label": `Photos of ${problem}` },
        ...figures,
    );
}

/** The photos as one file that needs no style sheet. */
export function photosAsFile(scene: Scene, problem: string): string {
    const placed = placeScene(scene);
    const columns = Math.min(scene.views, 3);
    const rows = Math.ceil(scene.views / columns);
    const gap = 10;
    const sheet = shape("svg", {
        viewBox: `-4 -4 ${columns * (width + gap)} ${rows * (height + gap)}`,
        width: columns * (width + gap),
        height: rows * (height + gap),
        "font-family": "sans-serif",
        "font-size": 8,
    });
    sheet.append(shape("title", {}, problem));
    framings(placed).forEach((place, view) => {
        const panel = photo(scene, placed, view, place, true).firstElementChild as SVGElement;
        const [column, row] = [view % columns, Math.floor(view / columns)];
        panel.setAttribute("transform", `translate(${column * (width + gap)} ${row * (height + gap)})`);
        for (const part of panel.children) colour(part);
        sheet.append(panel);
    });
    return `${new XMLSerializer().serializeToString(sheet)}\n`;
}

function colour(part: Element): void {
    const ink = part.getAttribute("class") === "unseen" ? "#bdbab0" : "#1c1c1a";
    if (part.localName === "line") part.setAttribute("stroke", ink);
    else if (part.localName === "rect") {
        part.setAttribute("fill", "#ffffff");
        part.setAttribute("stroke", "#dbd7cb");
    } else part.setAttribute("fill", ink);
}
