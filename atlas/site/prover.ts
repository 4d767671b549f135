// Asks the prover's code, which runs in a worker. The types are those of the answers in
// atlas/wasm/answers.h, and of `plprove problem --json`.

import type { Scene } from "./scene.js";

/** Of a problem in three views or two. */
export interface Degree {
    value: number;
    status: "certified";
}

/** Of a problem in general. */
export interface GeneralDegree {
    value: number;
    bound: "exact" | "at-least";
    status: "certified" | "evidence";
    certified_at_least: number;
    source: string;
}

/** How loops of photos permute the solutions. */
export interface Group {
    name: string;
    order: string;
    width: number;
    status: "certified" | "evidence";
}

export interface Hint {
    add: string | null;
    drop: string | null;
    problem: string;
    verdict: string;
    number?: number;
    degree?: Degree;
}

export interface Families {
    pl0p: boolean;
    at_most_one_pin: boolean;
    plmp: string | null;
    five_point_extension: boolean;
    registration: boolean;
    trifocal_linear: boolean;
}

export interface Report {
    problem: string;
    views: number;
    features: { feature: string; count: number; scene: number; images: number }[];
    dimensions: { scene: number; cameras: number; images: number; balanced: boolean };
    reduction: { rule: string; feature: string; result: string | null }[];
    reduced: string;
    constraints: number;
    verdict: string;
    minimal: boolean;
    camera_minimal: boolean;
    reasons: string[];
    terminal?: string;
    number?: number;
    standing?: string;
    class?: string;
    swap_class?: number;
    constraint_class?: number;
    families?: Families;
    degree?: Degree;
    group?: Group;
    hints?: Hint[];
}

/** What the views see of one feature; bit i of `lines` is its pin i. */
export interface FeatureSights {
    point: boolean;
    lines: number;
    views: { point: boolean; lines: number }[];
}

export interface ProblemAnswer {
    report: Report;
    description: string;
    names: string[];
    features: FeatureSights[];
    explanations: string[];
    extensions: Extension[];
    scene: Scene;
}

/** What may be added to a minimal problem, and the larger problem: the class that decides it, and its
 * degree. */
export interface Extension {
    words: string;
    problem: string;
    number?: number;
    degree?: number;
}

/** What `plprove problem --json` says of a problem in general: with shared lines, more than three
 * views, or projective cameras. */
export interface GeneralReport {
    problem: string;
    name: string;
    cameras: string;
    views: number;
    dimensions: { scene: number; cameras: number; images: number };
    /** null: no certificate is found, and `evidence` says what is seen. */
    minimal: boolean | null;
    reason: string;
    degree?: GeneralDegree;
    group?: Group;
    evidence?: Evidence;
}

/** Of a problem without a verdict: ranks at three random places; and which cameras, points and lines,
 * from 1, move while no image changes. */
export interface Evidence {
    ranks: number[];
    moving_cameras: number[];
    moving_points: number[];
    moving_lines: number[];
}

export interface GeneralAnswer {
    general: GeneralReport;
    certificate?: string;
    scene: Scene;
}

export interface Row {
    number: number;
    notation: string;
    minimal: boolean;
    obstruction: string;
    points: number;
    lines: number;
    degree?: number;
    scene?: Scene;
    dropped?: string;
    added?: string;
}

export interface SearchAnswer {
    total: number;
    rows: Row[];
}

export interface Relatives {
    swap: Row[];
    constraint: Row[];
    exchanges: Row[];
}

export interface Proof {
    kind: "dimension count" | "minimal" | "camera-minimal" | "deficient";
    minor?: string;
    deleted_rows?: number[];
    deleted_columns?: number[];
    kernel?: string[][];
}

export interface CertificateAnswer {
    text: string;
    modulus: string;
    cameras: { quaternion: number[]; translation: number[] }[];
    features: { feature: string; point: number[]; directions: number[][] }[];
    jacobian: { own: number; cameras: number; rows: string[][] }[];
    proof: Proof;
}

export type FileKind = "svg" | "tikz" | "macaulay2" | "julia" | "certificate";

/** What the program says of a question that makes no sense. */
export class Complaint extends Error {}

export class Prover {
    private readonly worker = new Worker(new URL("./prover_worker.js", import.meta.url), {
        type: "module",
    });
    private readonly waiting = new Map<number, (answer: string) => void>();
    private asked = 0;

    constructor() {
        this.worker.addEventListener(
            "message",
            (event: MessageEvent<{ id: number; answer: string }>) => {
                this.waiting.get(event.data.id)?.(event.data.answer);
                this.waiting.delete(event.data.id);
            },
        );
    }

    problem(spec: string): Promise<ProblemAnswer | GeneralAnswer> {
        return this.ask<ProblemAnswer | GeneralAnswer>({ ask: "problem", spec });
    }

    certificate(spec: string): Promise<CertificateAnswer> {
        return this.ask<CertificateAnswer>({ ask: "certificate", spec });
    }

    async file(spec: string, kind: FileKind): Promise<string> {
        return (await this.ask<{ text: string }>({ ask: "file", spec, kind })).text;
    }

    relatives(number: number): Promise<Relatives> {
        return this.ask<Relatives>({ ask: "relatives", number });
    }

    /** `filter` are options of `plprove list`. */
    search(
        filter: string[],
        sort: string,
        descending: boolean,
        first: number,
        most: number,
    ): Promise<SearchAnswer> {
        return this.ask<SearchAnswer>({ ask: "search", filter, sort, descending, first, most });
    }

    private async ask<Answer extends object>(request: object): Promise<Answer> {
        const id = ++this.asked;
        const answer = new Promise<string>((resolve) => this.waiting.set(id, resolve));
        this.worker.postMessage({ id, request: JSON.stringify(request) });
        const parsed = JSON.parse(await answer) as Answer | { error: string };
        if ("error" in parsed) throw new Complaint(parsed.error);
        return parsed;
    }
}
