// The scene in space, with the cameras of all real solutions. It turns.
import { HandleView, placeIn, shape, stepOf } from "./demo_handle.js";
import {
    along,
    centreOf,
    cross,
    dot,
    times,
    type Camera,
    type Pixel,
    type Scene,
    type Vector,
} from "./demo_scene.js";
import type { Solution } from "./demo_solver.js";

const width = 640;
const height = 480;

/** What lies farther away than this, in units of the drawing, is not drawn. */
const farthest = 20_000;

export class SketchView {
    readonly element = shape("svg", {
        class: "drawing play-space",
        viewBox: `0 0 ${width} ${height}`,
        role: "group",
        tabindex: 0,
        "aria-label": "The scene in space. The arrow keys turn it, plus and minus zoom.",
    });
    private readonly others = shape("g");
    private readonly paths: SVGPathElement[] = [];
    private readonly chosen = shape("path", { class: "chosen" });
    private readonly chosenPoints = shape("path", { class: "chosen points" });
    private readonly truth = shape("path", { class: "truth" });
    private readonly lines = shape("path", { class: "space-lines" });
    private readonly cameraHandles: { view: number; handle: HandleView }[] = [];
    private readonly pointHandles: HandleView[] = [];
    private readonly first = shape("text", { class: "first" }, "1");
    private yaw = 0.6;
    private pitch = 0.5;
    private zoom = 85;
    private solutions: readonly Solution[] = [];
    private choice = -1;

    constructor(
        private readonly scene: Scene,
        changed: () => void,
    ) {
        const moved = (by: (step: Vector) => void, from: () => Vector) => ({
            moveTo: (place: Pixel) => {
                const [x, y] = this.project(from());
                by(this.inSpace([place[0] - x, place[1] - y]));
                changed();
            },
            moveBy: (step: Pixel) => {
                by(this.inSpace(step));
                changed();
            },
        });
        for (let view = 1; view < scene.problem.views; ++view) {
            const move = moved(
                (step) => scene.moveCamera(view, step),
                () => scene.centres[view]!,
            );
            const name = `Camera ${view + 1}`;
            const movable = { name, kind: "camera" as const, colour: 9, ...move };
            const handle = new HandleView(this.element, movable, String(view + 1));
            this.cameraHandles.push({ view, handle });
        }
        for (const feature of scene.points.keys()) {
            const move = moved(
                (step) => scene.movePoint(feature, step),
                () => scene.points[feature]!,
            );
            const name = `Point ${feature + 1} in space`;
            const movable = { name, kind: "point" as const, colour: feature, ...move };
            const handle = new HandleView(this.element, movable, String(feature + 1));
            this.pointHandles.push(handle);
        }
        this.element.append(
            this.others,
            this.lines,
            this.chosen,
            this.chosenPoints,
            this.truth,
            this.first,
            ...this.pointHandles.map((handle) => handle.element),
            ...this.cameraHandles.map(({ handle }) => handle.element),
        );
        this.turnByPointerAndKeys();
        this.update();
    }

    /** Shows these solutions; the chosen one stands out, with its points. */
    show(solutions: readonly Solution[], choice: number): void {
        this.solutions = solutions;
        this.choice = choice;
        while (this.paths.length < solutions.length) this.paths.push(shape("path"));
        this.others.replaceChildren(...this.paths.slice(0, solutions.length));
        this.update();
    }

    update(): void {
        const scale = this.scene.scale();
        const ofSolution = (solution: Solution) =>
            solution.cameras.slice(1).map((camera) => this.frustum(camera, scale)).join("");
        for (const [k, solution] of this.solutions.entries()) {
            const front = solution.inFront === this.scene.points.length;
            this.paths[k]!.setAttribute("d", ofSolution(solution));
            this.paths[k]!.setAttribute("class", front ? "solution front" : "solution behind");
        }
        const chosen = this.solutions[this.choice];
        this.chosen.setAttribute("d", chosen ? ofSolution(chosen) : "");
        const points = chosen?.points.map((point) => this.cross(times(scale, point)));
        this.chosenPoints.setAttribute("d", points?.join("") ?? "");
        const cameras = this.scene.centres.map((_, view) => this.scene.camera(view));
        this.truth.setAttribute("d", cameras.map((camera) => this.frustum(camera, 1)).join(""));
        this.lines.setAttribute("d", this.spaceLines());
        const [x, y] = this.project([0, 0, 0]);
        this.first.setAttribute("x", (x + 11).toFixed(1));
        this.first.setAttribute("y", (y - 9).toFixed(1));
        const says = (place: Vector) => place.map((x) => x.toFixed(2)).join(", ");
        for (const { view, handle } of this.cameraHandles) {
            const centre = this.scene.centres[view]!;
            handle.update(this.project(centre), says(centre));
        }
        for (const [feature, point] of this.scene.points.entries())
            this.pointHandles[feature]!.update(this.project(point), says(point));
    }

    private axes(): readonly [Vector, Vector] {
        const right: Vector = [Math.cos(this.yaw), 0, Math.sin(this.yaw)];
        const forward: Vector = [
            -Math.sin(this.yaw) * Math.cos(this.pitch),
            Math.sin(this.pitch),
            Math.cos(this.yaw) * Math.cos(this.pitch),
        ];
        return [right, cross(forward, right)];
    }

    private project(point: Vector): Pixel {
        const [right, down] = this.axes();
        const from = along(point, -1, [0, 0, 2]);
        return [
            width / 2 + this.zoom * dot(right, from),
            height / 2 + this.zoom * dot(down, from),
        ];
    }

    /** The step in space that is this step in the drawing, and none towards the reader. */
    private inSpace(step: Pixel): Vector {
        const [right, down] = this.axes();
        return along(times(step[0] / this.zoom, right), step[1] / this.zoom, down);
    }

    /** The path through points in space; nothing where one is very far away. */
    private path(points: readonly Vector[], close = ""): string {
        const places = points.map((point) => this.project(point));
        const near = places.every(([x, y]) => Math.abs(x) < farthest && Math.abs(y) < farthest);
        if (!near) return "";
        return `M${places.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}${close}`;
    }

    /** A camera as a pyramid: its centre, and its photo in front of it. */
    private frustum({ rows, t }: Camera, scale: number): string {
        const centre = times(scale, centreOf({ rows, t }));
        const corners = [
            [-0.24, -0.18],
            [0.24, -0.18],
            [0.24, 0.18],
            [-0.24, 0.18],
        ].map(([x, y]) =>
            along(along(along(centre, x!, rows[0]), y!, rows[1]), 0.4, rows[2]),
        );
        const [a, b, c, d] = corners as [Vector, Vector, Vector, Vector];
        return (
            this.path([a, b, c, d], "Z") +
            this.path([a, centre, b]) +
            this.path([c, centre, d])
        );
    }

    private cross(point: Vector): string {
        const [x, y] = this.project(point);
        if (!(Math.abs(x) < farthest && Math.abs(y) < farthest)) return "";
        const [left, right] = [(x - 8).toFixed(1), (x + 8).toFixed(1)];
        const [top, bottom] = [(y - 8).toFixed(1), (y + 8).toFixed(1)];
        return `M${left} ${top}L${right} ${bottom}M${left} ${bottom}L${right} ${top}`;
    }

    private spaceLines(): string {
        const { points, directions } = this.scene;
        return directions
            .flatMap((list, feature) =>
                list.map((direction) =>
                    this.path([
                        along(points[feature]!, -0.7, direction),
                        along(points[feature]!, 0.7, direction),
                    ]),
                ),
            )
            .join("");
    }

    private turn([x, y]: Pixel): void {
        this.yaw -= x / 150;
        this.pitch = Math.min(Math.max(this.pitch + y / 150, -1.5), 1.5);
        this.update();
    }

    private turnByPointerAndKeys(): void {
        this.element.addEventListener("pointerdown", (event) => {
            let last = placeIn(this.element, event);
            this.element.setPointerCapture(event.pointerId);
            const move = (moved: PointerEvent) => {
                const place = placeIn(this.element, moved);
                this.turn([place[0] - last[0], place[1] - last[1]]);
                last = place;
            };
            const release = () => {
                this.element.removeEventListener("pointermove", move);
                this.element.removeEventListener("lostpointercapture", release);
            };
            this.element.addEventListener("pointermove", move);
            this.element.addEventListener("lostpointercapture", release);
        });
        this.element.addEventListener("keydown", (event) => {
            const step = stepOf(event);
            const factor = { "+": 1.15, "=": 1.15, "-": 1 / 1.15 }[event.key];
            if (step) this.turn([4 * step[0], 4 * step[1]]);
            else if (factor) this.zoomBy(factor);
            else return;
            event.preventDefault();
        });
    }

    zoomBy(factor: number): void {
        this.zoom = Math.min(Math.max(this.zoom * factor, 10), 500);
        this.update();
    }
}
