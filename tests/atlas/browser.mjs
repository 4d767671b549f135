// A browser on the built atlas, as a reader has it: Debian's Chromium, and Python's web server.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, afterEach, before } from "node:test";
import { fileURLToPath } from "node:url";
import assert from "node:assert/strict";
import path from "node:path";

const require = createRequire(new URL("../../atlas/package.json", import.meta.url));
const { chromium } = require("playwright-core");
const axeSource = require("axe-core").source;

export const root = path.resolve(fileURLToPath(import.meta.url), "../../..");
export const atlas = path.join(root, "build/atlas");

/** A problem that nobody has decided: that of the tests of plprove. */
export const openProblem = (() => {
    const source = readFileSync(path.join(root, "tests/programs/general.cpp"), "utf8");
    const [, literals] = /open_problem =((?:\s*"[^"]*")+);/.exec(source);
    return [...literals.matchAll(/"([^"]*)"/g)].map(([, text]) => text).join("");
})();

/** Milliseconds after which a page that does not answer hangs. (How fast it is, tests/bench/atlas.mjs
 * measures.) */
const patience = 600_000;

/** Serves build/atlas; resolves to its address and the process. */
async function serve() {
    const options = ["-u", "-m", "http.server", "0", "--bind", "127.0.0.1", "--directory", atlas];
    const server = spawn("/usr/bin/python3", options, { stdio: ["ignore", "pipe", "ignore"] });
    const [line] = await once(server.stdout, "data");
    const port = /port (\d+)/.exec(String(line))?.[1];
    return { server, address: `http://127.0.0.1:${port}/` };
}

/** A browser on the atlas. Every page that it opens has to stay without errors. Pages share a context
 * with all that have the same options: a page of the atlas keeps nothing for the next, but a new context
 * compiles everything anew. Without a word in the options there is no service worker: for each context it
 * fetches the whole atlas. */
export async function open() {
    const { server, address } = await serve();
    const browser = await chromium.launch({
        executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
        args: ["--no-sandbox"], // Chromium refuses to run as root otherwise
    });
    const errors = [];
    const watch = (page) => {
        page.setDefaultTimeout(patience);
        page.on("pageerror", (error) => errors.push(error.message));
        page.on("console", (message) => {
            if (message.type() === "error") errors.push(message.text());
        });
        page.on("request", (request) => {
            const own = request.url().startsWith(address) || /^(blob|data):/.test(request.url());
            if (!own) errors.push(`another host is asked: ${request.url()}`);
        });
        return page;
    };
    const contexts = new Map();
    const contextWith = (options) => {
        const key = JSON.stringify(options);
        const standard = { reducedMotion: "reduce", serviceWorkers: "block" };
        if (!contexts.has(key)) contexts.set(key, browser.newContext({ ...standard, ...options }));
        return contexts.get(key);
    };
    return {
        address,
        /** A page at an address in the atlas. */
        async visit(where, options = {}) {
            const context = await contextWith(options);
            const page = watch(await context.newPage());
            await page.addInitScript(axeSource); // the page's policy keeps scripts out, but not these
            await page.goto(address + where);
            return page;
        },
        closePages: () =>
            Promise.all(
                browser.contexts().flatMap((context) => context.pages().map((page) => page.close())),
            ),
        assertNoErrors: () => assert.deepEqual(errors, []),
        async close() {
            await browser.close();
            server.kill();
        },
    };
}

/** The atlas for the tests of a file, in one browser: each test opens pages, which are closed after it. */
export function openForTests() {
    let opened;
    before(async () => (opened = await open()));
    afterEach(() => opened.closePages());
    after(async () => {
        await opened.close();
        opened.assertNoErrors();
    });
    return {
        visit: (where, options) => opened.visit(where, options),
        get address() {
            return opened.address;
        },
    };
}

/** What axe finds wrong with a page. */
export async function violationsOf(page) {
    const { violations } = await page.evaluate(() => globalThis.axe.run());
    return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join("; ")}`);
}

/** Waits until a function in the page is true. (Playwright's own way evaluates texts in the page, which
 * the page's policy forbids.) */
export async function until(page, isTrue, argument) {
    const end = Date.now() + patience;
    while (!(await page.evaluate(isTrue, argument))) {
        assert.ok(Date.now() < end, `waited in vain for ${isTrue}`);
        await page.waitForTimeout(50);
    }
}

/** The text of an element, once it is there. */
export async function textOf(page, selector) {
    await page.waitForSelector(selector);
    return page.textContent(selector);
}

/** Waits for the end of a check; resolves to the line that says how it ended, and the output. */
export async function outcomeOf(page, within = "") {
    const state = await textOf(page, `${within} .state.verified, ${within} .state.refused`);
    return { state, output: await textOf(page, `${within} .check .output`) };
}
