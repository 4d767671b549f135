// A scene that the reader moves: cameras, points and lines through them, and what the photos show.
// Camera 1 stays at the origin of space.

export type Vector = readonly [number, number, number];
export type Pixel = readonly [number, number];

/** It takes a point X of space to R X + t; R by rows. */
export interface Camera {
    rows: readonly [Vector, Vector, Vector];
    t: Vector;
}

export const photo = { width: 640, height: 480, focal: 600 };

/** Pixels from a point to the handle on its line. */
const arm = 90;

export function dot(a: Vector, b: Vector): number {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vector, b: Vector): Vector {
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/** a + s b. */
export function along(a: Vector, s: number, b: Vector): Vector {
    return [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
}

export function times(s: number, a: Vector): Vector {
    return [s * a[0], s * a[1], s * a[2]];
}

export function unit(a: Vector): Vector {
    return times(1 / Math.hypot(...a), a);
}

export function centreOf(camera: Camera): Vector {
    const [x, y, z] = camera.rows;
    const [a, b, c] = camera.t;
    return [
        -(x[0] * a + y[0] * b + z[0] * c),
        -(x[1] * a + y[1] * b + z[1] * c),
        -(x[2] * a + y[2] * b + z[2] * c),
    ];
}

/** A point in the coordinates of a camera: the third one is its depth. */
export function seenBy(camera: Camera, point: Vector): Vector {
    const [x, y, z] = camera.rows;
    return [dot(x, point) + camera.t[0], dot(y, point) + camera.t[1], dot(z, point) + camera.t[2]];
}

function pixel(seen: Vector): Pixel {
    return [
        (photo.focal * seen[0]) / seen[2] + photo.width / 2,
        (photo.focal * seen[1]) / seen[2] + photo.height / 2,
    ];
}

/** A camera at a place that looks at a target, upright. */
function lookingAt(target: Vector, centre: Vector): Camera {
    const forward = unit(along(target, -1, centre));
    const right = unit(cross([0, 1, 0], forward));
    const down = cross(forward, right);
    const turned: Vector = [dot(right, centre), dot(down, centre), dot(forward, centre)];
    return { rows: [right, down, forward], t: times(-1, turned) };
}

/** Random numbers from 0 to 1, the same for the same seed (mulberry32). */
function randomNumbers(seed: number): () => number {
    let state = seed >>> 0;
    return () => {
        state = (state + 0x6d2b79f5) >>> 0;
        let mixed = Math.imul(state ^ (state >>> 15), state | 1);
        mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
        return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
    };
}

/** What a page asks the solver, and shows. All features are seen by all views. */
export interface ProblemOfDemo {
    id: string;
    notation: string;
    views: number;
    /** For each point how many lines go through it. */
    lines: readonly number[];
    /** The file with solutions of other photos, from which paths lead to those of these. */
    start?: string;
}

export const problems: readonly ProblemOfDemo[] = [
    { id: "five-points", notation: "5*P/P", views: 2, lines: [0, 0, 0, 0, 0] },
    {
        id: "chicago",
        notation: "2*Pa/Pa/Pa + P/P/P",
        views: 3,
        lines: [1, 1, 0],
        start: "data/chicago.start",
    },
];

/** Something in a photo that moves: a point, or the handle of a line through it. */
export interface Handle {
    view: number;
    feature: number;
    /** -1 is the point. */
    line: number;
}

/** The numbers that move one photo's features away from what the camera sees. */
interface Shift {
    moved: [number, number];
    noise: Pixel;
    lines: { turned: number; noise: number }[];
}

export class Scene {
    readonly points: Vector[] = [];
    /** [feature][line], of length 1. */
    readonly directions: Vector[][] = [];
    /** Of all cameras; the first one is at the origin, and stays there. */
    readonly centres: Vector[] = [];
    /** The size of the noise, in pixels. */
    noise = 0;
    private readonly target: Vector = [0, 0, 4];
    private readonly shifts: Shift[][];

    constructor(
        readonly problem: ProblemOfDemo,
        seed: number,
    ) {
        const random = randomNumbers(seed);
        const signed = () => 2 * random() - 1;
        const vector = (): Vector => [signed(), signed(), signed()];
        const normal = () =>
            Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());
        const places: Vector[] = [
            [0, 0, 0],
            [1.3, -0.35, 0.4],
            [-0.6, -1.1, 0.6],
        ];
        for (const place of places.slice(0, problem.views))
            this.centres.push(this.centres.length === 0 ? place : along(place, 0.25, vector()));
        for (const lines of problem.lines) {
            let point: Vector;
            do point = along(this.target, 1, times(0.95, vector()));
            while (this.isNearAnother(point));
            this.points.push(point);
            this.directions.push(Array.from({ length: lines }, () => unit(vector())));
        }
        this.shifts = this.centres.map(() =>
            problem.lines.map((lines) => ({
                moved: [0, 0],
                noise: [normal(), normal()],
                lines: Array.from({ length: lines }, () => ({
                    turned: 0,
                    noise: normal() / arm,
                })),
            })),
        );
    }

    camera(view: number): Camera {
        if (view === 0)
            return {
                rows: [
                    [1, 0, 0],
                    [0, 1, 0],
                    [0, 0, 1],
                ],
                t: [0, 0, 0],
            };
        return lookingAt(this.target, this.centres[view]!);
    }

    /** The cameras as the solver has them: camera 2 at the distance 1 from camera 1. */
    normalisedCameras(): Camera[] {
        return this.centres.map((_, view) => {
            const camera = this.camera(view);
            return { rows: camera.rows, t: times(1 / this.scale(), camera.t) };
        });
    }

    /** How long the solver's unit of length is here. */
    scale(): number {
        return Math.hypot(...this.centres[1]!);
    }

    moveCamera(view: number, by: Vector): void {
        const next = along(this.centres[view]!, 1, by);
        const far = Math.hypot(...along(next, -1, this.target));
        // Neither in the scene, nor in camera 1, nor out of sight.
        if (far > 2.2 && far < 9 && Math.hypot(...next) > 0.15) this.centres[view] = next;
    }

    movePoint(feature: number, by: Vector): void {
        const next = along(this.points[feature]!, 1, by);
        if (Math.hypot(...along(next, -1, this.target)) < 1.9) this.points[feature] = next;
    }

    /** Whether the photos show what the cameras see. */
    isExact(): boolean {
        return (
            this.noise === 0 &&
            this.shifts.flat().every(({ moved, lines }) => {
                const turned = lines.some((line) => line.turned !== 0);
                return moved[0] === 0 && moved[1] === 0 && !turned;
            })
        );
    }

    reset(): void {
        this.noise = 0;
        for (const shift of this.shifts.flat()) {
            shift.moved = [0, 0];
            for (const line of shift.lines) line.turned = 0;
        }
    }

    /** Where a handle is in its photo. */
    place({ view, feature, line }: Handle): Pixel {
        const camera = this.camera(view);
        const shift = this.shifts[view]![feature]!;
        const [x, y] = pixel(seenBy(camera, this.points[feature]!));
        const point: Pixel = [
            x + shift.moved[0] + this.noise * shift.noise[0],
            y + shift.moved[1] + this.noise * shift.noise[1],
        ];
        if (line < 0) return point;
        const angle =
            this.trueAngle(view, feature, line) +
            shift.lines[line]!.turned +
            this.noise * shift.lines[line]!.noise;
        return [point[0] + arm * Math.cos(angle), point[1] + arm * Math.sin(angle)];
    }

    /** Moves what the photo shows, and not the scene. A line turns about its point. */
    movePlace(handle: Handle, to: Pixel): void {
        const { view, feature, line } = handle;
        const shift = this.shifts[view]![feature]!;
        const now = this.place(handle);
        if (line < 0) {
            const x = Math.min(Math.max(to[0], 4), photo.width - 4);
            const y = Math.min(Math.max(to[1], 4), photo.height - 4);
            shift.moved = [shift.moved[0] + x - now[0], shift.moved[1] + y - now[1]];
            return;
        }
        const [x, y] = this.place({ view, feature, line: -1 });
        const before = Math.atan2(now[1] - y, now[0] - x);
        shift.lines[line]!.turned += Math.atan2(to[1] - y, to[0] - x) - before;
    }

    handles(view: number): Handle[] {
        return this.problem.lines.flatMap((lines, feature) =>
            Array.from({ length: lines + 1 }, (_, k) => ({ view, feature, line: k - 1 })),
        );
    }

    /** What the solver reads (atlas/wasm/solver_module.cpp). */
    images(): number[] {
        const views = [...this.centres.keys()];
        const numbers = views.flatMap(() => [
            photo.focal,
            photo.focal,
            photo.width / 2,
            photo.height / 2,
        ]);
        for (const [feature, lines] of this.problem.lines.entries())
            for (const view of views) {
                const point = this.place({ view, feature, line: -1 });
                numbers.push(...point);
                for (let line = 0; line < lines; ++line)
                    numbers.push(...point, ...this.place({ view, feature, line }));
            }
        return numbers;
    }

    /** Whether a photo would show the point near another one. */
    private isNearAnother(point: Vector): boolean {
        return this.centres.some((_, view) => {
            const place = (of: Vector) => pixel(seenBy(this.camera(view), of));
            const [x, y] = place(point);
            return this.points.some((other) => {
                const [a, b] = place(other);
                return Math.hypot(a - x, b - y) < 55;
            });
        });
    }

    private trueAngle(view: number, feature: number, line: number): number {
        const camera = this.camera(view);
        const point = seenBy(camera, this.points[feature]!);
        const end = along(this.points[feature]!, 1, this.directions[feature]![line]!);
        const direction = along(seenBy(camera, end), -1, point);
        // The derivative of the pixel along the line.
        return Math.atan2(
            direction[1] * point[2] - point[1] * direction[2],
            direction[0] * point[2] - point[0] * direction[2],
        );
    }
}
