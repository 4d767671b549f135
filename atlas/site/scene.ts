// A scene in space for a problem, and cameras around it: what the photos of a page show, and the
// sketch that one can turn. Positions mean nothing but this: they are in general position, and
// points that share a line lie on it. The same problem always gets the same scene.

/** What the program says of a problem (atlas/wasm/answers.h): bit v of a set is view v + 1. */
export interface Scene {
    views: number;
    points: number[];
    lines: { points: number[]; seen: number }[];
}

export type Vector = readonly [number, number, number];

/** A line is drawn as a segment. */
export interface Segment {
    from: Vector;
    to: Vector;
}

/** A camera: where it is, and what is right, up and ahead of it. */
export interface Camera {
    place: Vector;
    right: Vector;
    up: Vector;
    ahead: Vector;
}

export interface PlacedScene {
    points: Vector[];
    lines: Segment[];
    cameras: Camera[];
}

export function sees(views: number, view: number): boolean {
    return Math.floor(views / 2 ** view) % 2 === 1;
}

export function add(a: Vector, b: Vector, factor = 1): Vector {
    return [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]];
}

export function dot(a: Vector, b: Vector): number {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Vector, b: Vector): Vector {
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function unit(a: Vector): Vector {
    const length = Math.sqrt(dot(a, a));
    return [a[0] / length, a[1] / length, a[2] / length];
}

const degrees = Math.PI / 180;

/** Cameras on an arc before the scene, which they look at; each a little higher or lower. */
function camerasAround(views: number): Camera[] {
    const spread = (views < 4 ? 34 : Math.min(75, 14 * views)) * degrees;
    return Array.from({ length: views }, (_, view) => {
        const angle = views === 1 ? 0 : spread * ((2 * view) / (views - 1) - 1);
        const height = (view % 2 === 0 ? 10 : -13) * degrees;
        const distance = 4.4 + 0.5 * Math.sin(2.4 * view);
        const place: Vector = [
            distance * Math.sin(angle) * Math.cos(height),
            distance * Math.sin(height),
            distance * Math.cos(angle) * Math.cos(height),
        ];
        return lookingAtScene(place, (view - (views - 1) / 2) * 4 * degrees);
    });
}

function lookingAtScene(place: Vector, roll: number): Camera {
    const ahead = unit([-place[0], -place[1], -place[2]]);
    const right = unit(cross(ahead, [0, 1, 0]));
    const up = cross(right, ahead);
    const turned = (a: Vector, b: Vector, sign: number): Vector =>
        add([a[0] * Math.cos(roll), a[1] * Math.cos(roll), a[2] * Math.cos(roll)], b, sign * Math.sin(roll));
    return { place, ahead, right: turned(right, up, 1), up: turned(up, right, -1) };
}

/** Where a camera sees a point: right and up, in units of the distance. */
export function seenAt(camera: Camera, point: Vector): [number, number] {
    const from = add(point, camera.place, -1);
    const depth = dot(from, camera.ahead);
    return [dot(from, camera.right) / depth, dot(from, camera.up) / depth];
}

/** The k-th of places that fill a box evenly (Roberts' sequence). */
function candidate(k: number): Vector {
    const part = (base: number) => ((0.5 + k * base) % 1) * 2 - 1;
    return [1.15 * part(0.8191725), 0.8 * part(0.6710436), 0.75 * part(0.5497005)];
}

/** Of many places the one that is farthest, in every photo, from what is there: itself, and so are its
 * ends, which lie `reach` to both sides. */
function freePlace(
    taken: Vector[],
    cameras: Camera[],
    first: number,
    reach: Vector = [0, 0, 0],
): Vector {
    let best = candidate(first);
    let bestDistance = -1;
    for (let k = 0; k < 40; ++k) {
        const place = candidate(first + k);
        let distance = 9 - Math.abs(place[0]) / 50;
        for (const camera of cameras) {
            for (const side of [-1, 0, 1]) {
                const [x, y] = seenAt(camera, add(place, reach, side));
                for (const other of taken) {
                    const [u, v] = seenAt(camera, other);
                    distance = Math.min(distance, Math.hypot(x - u, y - v));
                }
            }
        }
        if (distance > bestDistance) [best, bestDistance] = [place, distance];
    }
    return best;
}

/** How far along the line through two points the next ones lie. */
const steps = [0.48, 1.42, -0.4, 0.75, 0.22, 1.75, -0.7];

/** A point on the line through earlier ones, if it lies on one. */
function placeOnLine(scene: Scene, point: number, placed: Vector[]): Vector | null {
    for (const { points } of scene.lines) {
        const earlier = points.filter((other) => other < point);
        const [a, b] = [placed[earlier[0] ?? -1], placed[earlier[1] ?? -1]];
        if (!points.includes(point) || !a || !b) continue;
        const step = steps[(earlier.length - 2) % steps.length] ?? 0.5;
        return add(a, add(b, a, -1), step);
    }
    return null;
}

/** The direction of the k-th of several lines through a point, or of a free line. */
function direction(k: number, of: number, seed: number): Vector {
    const angle = (k / of + seed * 0.381966) * Math.PI + 0.5;
    return unit([Math.cos(angle), Math.sin(angle), 0.55 * Math.sin(2.4 * k + 1.7 * seed)]);
}

function segmentAround(middle: Vector, along: Vector, half: number): Segment {
    return { from: add(middle, along, -half), to: add(middle, along, half) };
}

/** The line that joins points, a little longer. */
function segmentThrough(points: Vector[]): Segment {
    const [a, b] = [points[0] as Vector, points[1] as Vector];
    const along = unit(add(b, a, -1));
    const ways = points.map((point) => dot(add(point, a, -1), along));
    return {
        from: add(a, along, Math.min(...ways) - 0.22),
        to: add(a, along, Math.max(...ways) + 0.22),
    };
}

export function placeScene(scene: Scene): PlacedScene {
    const cameras = camerasAround(scene.views);
    const points: Vector[] = [];
    scene.points.forEach((_, point) => {
        points.push(placeOnLine(scene, point, points) ?? freePlace(points, cameras, 7 * point));
    });
    const pins = points.map((_, point) =>
        scene.lines.filter((line) => line.points.length === 1 && line.points[0] === point),
    );
    const taken = [...points];
    const keep = (segment: Segment): Segment => {
        taken.push(segment.from, segment.to);
        return segment;
    };
    const through = scene.lines.map(({ points: on }, index) => {
        const places = on.map((point) => points[point] as Vector);
        const [first = -1] = on;
        const [place] = places;
        if (!place) return null;
        if (on.length > 1) return keep(segmentThrough(places));
        const all = pins[first] ?? [];
        const which = all.indexOf(scene.lines[index] as Scene["lines"][number]);
        return keep(segmentAround(place, direction(which, all.length, first), 0.36));
    });
    const lines = through.map((segment, index) => {
        if (segment) return segment;
        const along = direction(0, 1, index + 2);
        const half = 0.45;
        const reach = add([0, 0, 0], along, half);
        const place = freePlace(taken, cameras, 11 * index + 3, reach);
        taken.push(place);
        return keep(segmentAround(place, along, half));
    });
    return { points, lines, cameras };
}
