// What every page does: it keeps the atlas for reading without a network, where the browser can.

if ("serviceWorker" in navigator && window.isSecureContext) {
    navigator.serviceWorker.register(new URL("../offline.js", import.meta.url)).catch(() => {
        // Some browsers forbid it in private windows. The pages work without.
    });
}
