// The worker in which the prover's code answers questions, one after the other.
import { type Factory, type WasmModule, withText } from "./wasm_module.js";

interface Prover extends WasmModule {
    _open_prover(): number;
    _ask_prover(prover: number, request: number): number;
}

async function load(): Promise<(request: string) => string> {
    const address = "./wasm/prover.mjs";
    const { default: factory } = (await import(address)) as { default: Factory<Prover> };
    const module = await factory({});
    const prover = module._open_prover();
    return (request) =>
        withText(module, request, (text) => module.UTF8ToString(module._ask_prover(prover, text)));
}

const loaded = load();

self.addEventListener("message", (event: MessageEvent<{ id: number; request: string }>) => {
    const { id, request } = event.data;
    loaded.then(
        (ask) => self.postMessage({ id, answer: ask(request) }),
        (error: unknown) =>
            self.postMessage({ id, answer: JSON.stringify({ error: String(error) }) }),
    );
});
