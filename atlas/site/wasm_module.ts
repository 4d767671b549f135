// What Emscripten makes of the C++ modules in atlas/wasm: functions, and their memory.

export interface WasmModule {
    HEAPU8: Uint8Array;
    UTF8ToString(address: number): string;
    stringToUTF8(text: string, address: number, size: number): void;
    lengthBytesUTF8(text: string): number;
    _malloc(size: number): number;
    _free(address: number): void;
    progress?: (line: number, records: number, solutions: number) => void;
}

export type Factory<Module> = (options: {
    progress?: (line: number, records: number, solutions: number) => void;
}) => Promise<Module>;

/** Puts a text into the module's memory while an action needs it. */
export function withText<Result>(
    module: WasmModule,
    text: string,
    action: (address: number) => Result,
): Result {
    const size = module.lengthBytesUTF8(text) + 1;
    const address = module._malloc(size);
    try {
        module.stringToUTF8(text, address, size);
        return action(address);
    } finally {
        module._free(address);
    }
}

/** Puts bytes into the module's memory while an action needs them. */
export function withBytes<Result>(
    module: WasmModule,
    bytes: Uint8Array,
    action: (address: number) => Result,
): Result {
    const address = module._malloc(Math.max(1, bytes.length));
    try {
        module.HEAPU8.set(bytes, address);
        return action(address);
    } finally {
        module._free(address);
    }
}
