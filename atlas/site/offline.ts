// The service worker: what was loaded once is kept, so that the atlas can be read without a
// network. With a network the newest files are taken. This file is no module: not every browser
// takes modules as service workers.

interface OfflineScope {
    addEventListener(
        type: "install" | "activate" | "fetch",
        listener: (event: OfflineEvent) => void,
    ): void;
    skipWaiting(): Promise<void>;
    clients: { claim(): Promise<void> };
}

interface OfflineEvent {
    request: Request;
    waitUntil(promise: Promise<unknown>): void;
    respondWith(response: Promise<Response>): void;
}

const offlineScope = self as unknown as OfflineScope;
const offlineStore = "atlas";

async function keepAllFiles(): Promise<void> {
    const cache = await caches.open(offlineStore);
    const list = (await (await fetch("data/offline.json")).json()) as string[];
    await cache.addAll(list);
}

async function answerFromNetworkOrStore(request: Request): Promise<Response> {
    const cache = await caches.open(offlineStore);
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

offlineScope.addEventListener("install", (event) => {
    event.waitUntil(keepAllFiles().then(() => offlineScope.skipWaiting()));
});
offlineScope.addEventListener("activate", (event) => event.waitUntil(offlineScope.clients.claim()));
offlineScope.addEventListener("fetch", (event) => {
    if (event.request.method === "GET") event.respondWith(answerFromNetworkOrStore(event.request));
});
