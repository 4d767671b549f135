// Calls plcheck in a worker of its own, which ends with the call: nothing is kept from one to the
// next.

import { inKilobytes } from "./elements.js";

export interface CheckFile {
    name: string;
    /** Either the bytes, or an address to load them from. */
    bytes?: ArrayBuffer;
    address?: string;
}

/** A file of the atlas, by its path there. The worker that loads it lies in the folder site. */
export function atlasFile(name: string): CheckFile {
    return { name, address: `../${name}` };
}

export interface CheckRequest {
    /** Options of plcheck, such as --expect and what follows it. */
    options: string[];
    files: CheckFile[];
}

export interface Outcome {
    /** As the command: 0 verified, 1 refused or not proved, 2 not well-formed, 3 wrong usage. */
    status: number;
    output: string;
    errors: string;
    /** What --json prints. */
    report: string;
}

export type CheckReply =
    | { kind: "file"; name: string }
    | { kind: "replay"; name: string; bytes: number }
    | { kind: "progress"; line: number; records: number; solutions: number }
    | ({ kind: "done" } & Outcome)
    | { kind: "failed"; reason: string };

/** Runs plcheck on the files; `tell` hears of progress in a few words. */
export function check(request: CheckRequest, tell: (words: string) => void): Promise<Outcome> {
    const worker = new Worker(new URL("./checker_worker.js", import.meta.url), { type: "module" });
    return new Promise<Outcome>((resolve, reject) => {
        worker.addEventListener("message", (event: MessageEvent<CheckReply>) => {
            const reply = event.data;
            if (reply.kind === "file") tell(`Loading ${reply.name}`);
            if (reply.kind === "replay") tell(`Replaying ${reply.name}: ${inKilobytes(reply.bytes)}`);
            if (reply.kind === "progress")
                tell(`Replaying: ${reply.records} records, ${reply.solutions} solutions`);
            if (reply.kind === "done") resolve(reply);
            if (reply.kind === "failed") reject(new Error(reply.reason));
        });
        worker.addEventListener("error", (event) => reject(new Error(event.message)));
        worker.postMessage(request);
    }).finally(() => worker.terminate());
}

/** The command that does the same on a command line. */
export function commandLine(request: CheckRequest): string {
    const quoted = request.options.map((word) =>
        /^[\w./=<>-]+$/.test(word) && !/[<>]/.test(word) ? word : `'${word}'`,
    );
    return ["plcheck", ...quoted, ...request.files.map((file) => file.name)].join(" ");
}
