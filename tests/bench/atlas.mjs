// How long a reader of the atlas waits: for the start page, a search, and a replay of the whole
// classification, beside the same replay by plcheck; and how many pictures a second there are on the
// page Play while a camera moves.
//
// Usage: node tests/bench/atlas.mjs       after atlas/build
import { execFileSync } from "node:child_process";
import path from "node:path";
import { open, outcomeOf, root, until } from "../atlas/browser.mjs";

const rounds = 5;

/** The shortest of some rounds, in milliseconds: of what `once` resolves to. */
async function shortest(once) {
    const times = [];
    for (let round = 0; round < rounds; ++round) times.push(await once());
    return Math.min(...times);
}

async function timed(action) {
    const start = performance.now();
    await action();
    return performance.now() - start;
}

const atlas = await open();
try {
    const start = await shortest(async () => {
        const fresh = await open(); // a browser that has nothing of an earlier round
        const page = await fresh.visit("index.html");
        const shown = await page.evaluate(
            () => performance.getEntriesByType("navigation")[0].domContentLoadedEventEnd,
        );
        await fresh.close();
        return shown;
    });
    console.log(`start page            ${start.toFixed(0)} ms`);

    const search = await atlas.visit("search.html");
    await search.waitForSelector(".card");
    let points = 0;
    const found = await shortest(async () => {
        const before = await search.textContent("#total");
        await search.fill("[name=points]", String(++points));
        await until(
            search,
            (was) => document.querySelector("#total").textContent !== was,
            before,
        );
        return Number(await search.getAttribute("#results", "data-milliseconds"));
    });
    console.log(`search                ${found.toFixed(0)} ms`);

    for (const problem of ["five-points", "chicago"]) {
        const seconds = 5;
        const page = await atlas.visit(`demo.html?problem=${problem}`);
        await page.waitForSelector("#demo[data-settled]");
        await page.check("#moving");
        await page.waitForTimeout(1000);
        const pictures = () =>
            page.evaluate(() => Number(document.querySelector("#demo").dataset.pictures));
        const before = await pictures();
        const time = await timed(() => page.waitForTimeout(seconds * 1000));
        const rate = (1000 * ((await pictures()) - before)) / time;
        console.log(`play, ${problem.padEnd(15)} ${rate.toFixed(1)} pictures a second`);
    }

    const browser = await shortest(async () => {
        const page = await atlas.visit("index.html");
        return timed(async () => {
            await page.click("#check-now");
            await outcomeOf(page);
        });
    });
    const plcheck = path.join(root, "build/bin/plcheck");
    const archive = path.join(root, "certs/classification.plc");
    const native = await shortest(() => timed(() => execFileSync(plcheck, [archive])));
    console.log(`replay, in a browser  ${browser.toFixed(0)} ms`);
    console.log(`replay, by plcheck    ${native.toFixed(0)} ms`);
    console.log(`ratio                 ${(browser / native).toFixed(1)}`);
} finally {
    await atlas.close();
}
