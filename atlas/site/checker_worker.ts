// The worker in which plcheck runs. One message asks for one call of the command; progress and the
// outcome go back.
import { type Factory, type WasmModule, withBytes, withText } from "./wasm_module.js";
import type { CheckRequest, CheckReply } from "./checker.js";

interface Checker extends WasmModule {
    _begin_run(parameters: number): number;
    _replay_file(run: number, name: number, bytes: number, size: number): void;
    _conclude_run(run: number): void;
    _status_of(run: number): number;
    _output_of(run: number): number;
    _errors_of(run: number): number;
    _report_of(run: number): number;
    _end_run(run: number): void;
}

function reply(message: CheckReply): void {
    self.postMessage(message);
}

async function load(): Promise<Checker> {
    const address = "./wasm/checker.mjs";
    const { default: factory } = (await import(address)) as { default: Factory<Checker> };
    return factory({
        progress: (line, records, solutions) =>
            reply({ kind: "progress", line, records, solutions }),
    });
}

async function bytesOf(file: CheckRequest["files"][number]): Promise<Uint8Array> {
    if (file.bytes) return new Uint8Array(file.bytes);
    const response = await fetch(file.address ?? "");
    if (!response.ok) throw new Error(`${file.name} cannot be loaded (${response.status})`);
    return new Uint8Array(await response.arrayBuffer());
}

async function check(request: CheckRequest): Promise<void> {
    const checker = await load();
    const names = request.files.map((file) => file.name);
    const parameters = [...request.options, "--", ...names].join("\n");
    const run = withText(checker, parameters, (text) => checker._begin_run(text));
    if (checker._status_of(run) === 0) {
        for (const file of request.files) {
            reply({ kind: "file", name: file.name });
            const bytes = await bytesOf(file);
            reply({ kind: "replay", name: file.name, bytes: bytes.length });
            withText(checker, file.name, (name) =>
                withBytes(checker, bytes, (address) =>
                    checker._replay_file(run, name, address, bytes.length),
                ),
            );
        }
        checker._conclude_run(run);
    }
    reply({
        kind: "done",
        status: checker._status_of(run),
        output: checker.UTF8ToString(checker._output_of(run)),
        errors: checker.UTF8ToString(checker._errors_of(run)),
        report: checker.UTF8ToString(checker._report_of(run)),
    });
    checker._end_run(run);
}

self.addEventListener("message", (event: MessageEvent<CheckRequest>) => {
    check(event.data).catch((error: unknown) => reply({ kind: "failed", reason: String(error) }));
});
