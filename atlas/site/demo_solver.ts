// Solves photos in a worker, with the code of libpointline, and reads its answers.
import type { Camera, ProblemOfDemo, Vector } from "./demo_scene.js";

export interface SpaceLine {
    point: Vector;
    direction: Vector;
}

/** A real solution, as libpointline has it: camera 1 is [I | 0], camera 2 at the distance 1. */
export interface Solution {
    cameras: Camera[];
    points: Vector[];
    /** [feature][line] */
    lines: SpaceLine[][];
    /** How many points are in front of all cameras. */
    inFront: number;
    /** In pixels. */
    residual: number;
}

export interface Answer {
    /** How many complex solutions generic photos have; how many were found. */
    degree: number;
    found: number;
    /** Whether it is certified that there are no more. */
    certified: boolean;
    solutions: Solution[];
    /** How long the solver took. */
    milliseconds: number;
}

export type SolverRequest =
    | { kind: "open"; notation: string; start?: string }
    | { kind: "solve"; images: number[]; quick: boolean; length: number };

export type SolverReply =
    | { kind: "opened" }
    | { kind: "answer"; head: number[]; solutions: Float64Array; milliseconds: number }
    | { kind: "failed"; reason: string };

/** How many numbers the answer has before the solutions. */
export const headLength = 5;

/** Of one solution. */
function lengthOf(problem: ProblemOfDemo): number {
    return problem.lines.reduce((sum, lines) => sum + 3 + 6 * lines, 2 + 12 * problem.views);
}

function readSolution(problem: ProblemOfDemo, numbers: Float64Array): Solution {
    let next = 2;
    const vector = (): Vector => {
        next += 3;
        return [numbers[next - 3]!, numbers[next - 2]!, numbers[next - 1]!];
    };
    const cameras = Array.from({ length: problem.views }, (): Camera => {
        const rows = [vector(), vector(), vector()] as const;
        return { rows, t: vector() };
    });
    const points: Vector[] = [];
    const lines: SpaceLine[][] = [];
    for (const count of problem.lines) {
        points.push(vector());
        lines.push(
            Array.from({ length: count }, () => ({ point: vector(), direction: vector() })),
        );
    }
    return { cameras, points, lines, inFront: numbers[0]!, residual: numbers[1]! };
}

/** Answers one question after the other. */
export class ImageSolver {
    private readonly worker = new Worker(new URL("./demo_worker.js", import.meta.url), {
        type: "module",
    });
    private settle?: { resolve: (reply: SolverReply) => void; reject: (error: Error) => void };

    constructor(readonly problem: ProblemOfDemo) {
        this.worker.addEventListener("message", (event: MessageEvent<SolverReply>) => {
            const reply = event.data;
            if (reply.kind === "failed") this.settle?.reject(new Error(reply.reason));
            else this.settle?.resolve(reply);
        });
        this.worker.addEventListener("error", (event) =>
            this.settle?.reject(new Error(event.message)),
        );
    }

    async open(): Promise<void> {
        const { notation, start } = this.problem;
        await this.ask({ kind: "open", notation, ...(start === undefined ? {} : { start }) });
    }

    /** With `quick`, paths that are lost are not followed again. Rejects where photos are none. */
    async solve(images: number[], quick: boolean): Promise<Answer> {
        const length = lengthOf(this.problem);
        const reply = await this.ask({ kind: "solve", images, quick, length });
        if (reply.kind !== "answer") throw new Error("the worker gave no answer");
        const [degree, found, certified, , real] = reply.head;
        return {
            degree: degree!,
            found: found!,
            certified: certified === 1,
            solutions: Array.from({ length: real! }, (_, k) =>
                readSolution(
                    this.problem,
                    reply.solutions.subarray(k * length, (k + 1) * length),
                ),
            ),
            milliseconds: reply.milliseconds,
        };
    }

    close(): void {
        this.worker.terminate();
    }

    private ask(request: SolverRequest): Promise<SolverReply> {
        return new Promise((resolve, reject) => {
            this.settle = { resolve, reject };
            this.worker.postMessage(request);
        });
    }
}
