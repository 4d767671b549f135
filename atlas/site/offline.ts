// The service worker: what was loaded once is kept, so that the atlas can be read without a
// network. With a network the newest files are taken.
export {};

interface Worker {
    addEventListener(type: "install" | "activate" | "fetch", listener: (event: FetchLike) => void): void;
    skipWaiting(): Promise<void>;
    clients: { claim(): Promise<void> };
}

interface FetchLike {
    request: Request;
    waitUntil(promise: Promise<unknown>): void;
    respondWith(response: Promise<Response>): void;
}

const worker = self as unknown as Worker;
const store = "atlas";

async function keepAll(): Promise<void> {
    const cache = await caches.open(store);
    const list = (await (await fetch("data/offline.json")).json()) as string[];
    await cache.addAll(list);
}

async function answer(request: Request): Promise<Response> {
    const cache = await caches.open(store);
    try {
        const response = await fetch(request);
        if (response.ok) await cache.put(request, response.clone());
        return response;
    } catch (error) {
        const kept = await cache.match(request, { ignoreSearch: true });
        if (kept) return kept;
        throw error;
    }
}

worker.addEventListener("install", (event) => {
    event.waitUntil(keepAll().then(() => worker.skipWaiting()));
});
worker.addEventListener("activate", (event) => event.waitUntil(worker.clients.claim()));
worker.addEventListener("fetch", (event) => {
    if (event.request.method === "GET") event.respondWith(answer(event.request));
});
