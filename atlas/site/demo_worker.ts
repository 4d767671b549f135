// The worker in which libpointline solves photos, one after the other.
import { type Factory, type WasmModule, withText } from "./wasm_module.js";
import { headLength, type SolverReply, type SolverRequest } from "./demo_solver.js";

interface SolverModule extends WasmModule {
    HEAPF64: Float64Array;
    _open_solver(problem: number, start: number): number;
    _open_solver_error(): number;
    _solve_images(solver: number, images: number, quick: number): number;
    _solver_error(solver: number): number;
}

/** Lists in lists, down to numbers. */
type Numbers = number | readonly Numbers[];

/** A start as `plprove start` writes it. */
interface StartFile {
    class: number;
    "rotation chart": Numbers;
    "centre chart": Numbers;
    constants: Numbers[];
    images: Numbers[];
    solutions: Numbers[];
}

function flat(numbers: Numbers): number[] {
    return typeof numbers === "number" ? [numbers] : numbers.flatMap(flat);
}

/** In the order that atlas/wasm/solver_module.cpp reads. */
function numbersOf(start: StartFile): number[] {
    const { constants, images, solutions } = start;
    const sizes = [start.class, constants.length, images.length, solutions.length];
    const charts = [start["rotation chart"], start["centre chart"]];
    return flat([...sizes, ...charts, constants, images, solutions]);
}

let module: SolverModule;
let solver = 0;

function withNumbers<Result>(numbers: number[], action: (address: number) => Result): Result {
    const address = module._malloc(8 * Math.max(1, numbers.length));
    try {
        module.HEAPF64.set(numbers, address / 8);
        return action(address);
    } finally {
        module._free(address);
    }
}

async function open(notation: string, start?: string): Promise<void> {
    const address = "./wasm/solver.mjs";
    const { default: factory } = (await import(address)) as { default: Factory<SolverModule> };
    module = await factory({});
    let numbers: number[] = [];
    if (start !== undefined) {
        const response = await fetch(`../${start}`);
        if (!response.ok) throw new Error(`${start} cannot be loaded (${response.status})`);
        numbers = numbersOf((await response.json()) as StartFile);
    }
    solver = withText(module, notation, (text) =>
        withNumbers(numbers, (first) => module._open_solver(text, first)),
    );
    if (solver === 0) throw new Error(module.UTF8ToString(module._open_solver_error()));
}

function solve(images: number[], quick: boolean, length: number): SolverReply {
    const begin = performance.now();
    const answer = withNumbers(images, (first) =>
        module._solve_images(solver, first, quick ? 1 : 0),
    );
    if (answer === 0)
        return { kind: "failed", reason: module.UTF8ToString(module._solver_error(solver)) };
    const first = answer / 8;
    const head = [...module.HEAPF64.subarray(first, first + headLength)];
    const count = head[headLength - 1]! * length;
    const solutions = module.HEAPF64.slice(first + headLength, first + headLength + count);
    return { kind: "answer", head, solutions, milliseconds: performance.now() - begin };
}

async function answerTo(request: SolverRequest): Promise<SolverReply> {
    if (request.kind === "solve") return solve(request.images, request.quick, request.length);
    await open(request.notation, request.start);
    return { kind: "opened" };
}

self.addEventListener("message", (event: MessageEvent<SolverRequest>) => {
    answerTo(event.data).then(
        (reply) => self.postMessage(reply),
        (error: unknown) => self.postMessage({ kind: "failed", reason: String(error) }),
    );
});
