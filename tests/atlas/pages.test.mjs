// Every page: accessible, readable on a phone, light and dark, small, without a network; and the
// files are those that the digests say.
import { test } from "node:test";
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync, statSync } from "node:fs";
import path from "node:path";
import { atlas as folder, openForTests, openProblem, textOf, violationsOf } from "./browser.mjs";

const pages = {
    "index.html": "#counts tbody tr",
    "search.html?p=2*Pa/Pa/Pa+%2B+P/P/P": ".card",
    "problem.html?p=2394": "[data-ready]",
    "problem.html?p=P/P/P+%2B+a/a/a+%2B+5*-/P/P+%2B+P/-/P": "[data-ready]",
    "problem.html?p=1021_1": "[data-ready]",
    "problem.html?p=projective:+4*PL/PL+%2B+2*P/P": "[data-ready]",
    [`problem.html?p=${encodeURIComponent(openProblem)}`]: "[data-ready]",
    "problem.html?p=nonsense": ".complaint",
    "paper.html": "#degrees tbody tr",
    "families.html": "#problems li",
    "families.html?family=projective&views=9": "#problems li",
    "models.html": "#models li",
    "models.html#p3p": "details[open]",
    "check.html": "#files",
    "how.html": ".matrix",
    "cite.html": "#citation pre",
    "demo.html": "#demo[data-settled]",
};

const atlas = openForTests();

const phone = { width: 360, height: 740 };
const desk = { width: 1280, height: 720 };

for (const [address, ready] of Object.entries(pages))
    test(`${address} fits a phone, axe finds nothing in dark and light, and links lead somewhere`, async () => {
        const page = await atlas.visit(address, { colorScheme: "dark", viewport: phone });
        await page.waitForSelector(ready);
        const width = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(width <= phone.width, `${width} pixels wide`);
        await page.setViewportSize(desk);
        assert.deepEqual(await violationsOf(page), []);
        await page.emulateMedia({ colorScheme: "light" });
        assert.deepEqual(await violationsOf(page), []);
        const links = await page
            .locator("a[href]")
            .evaluateAll((all) => all.map((link) => link.href));
        assert.ok(links.length > 4);
        for (const link of links.filter((link) => link.startsWith(atlas.address))) {
            const file = decodeURIComponent(new URL(link).pathname.slice(1)) || "index.html";
            assert.ok(statSync(path.join(folder, file)).isFile(), link);
        }
    });

test("the start page asks for at most 300 kB", async () => {
    const page = await atlas.visit("index.html");
    await page.waitForSelector("#counts tbody tr");
    const bytes = await page.evaluate(() =>
        [
            ...performance.getEntriesByType("navigation"),
            ...performance.getEntriesByType("resource"),
        ].reduce((sum, entry) => sum + entry.decodedBodySize, 0),
    );
    assert.ok(bytes > 10_000 && bytes < 300_000, `${bytes} bytes`);
});

test("once visited, the atlas is read and checks without a network", async () => {
    const page = await atlas.visit("index.html", { serviceWorkers: "allow" });
    await page.evaluate(() => navigator.serviceWorker.ready);
    await page.context().setOffline(true);
    await page.goto(`${atlas.address}problem.html?p=2394`);
    await page.click("#check-now");
    assert.match(await textOf(page, ".state.verified"), /^VERIFIED/);
    await page.goto(`${atlas.address}search.html?pl0p=on&verdict=minimal`);
    await page.waitForSelector(".card");
    assert.match(await page.textContent("#total"), /^51 of/);
});

test("a deep link leads to a problem by number, name and notation", async () => {
    for (const spec of ["2394", "%232394", "Chicago", "2*Pa/Pa/Pa+%2B+P/P/P"]) {
        const page = await atlas.visit(`problem.html?p=${spec}`);
        assert.equal(await textOf(page, "#problem .verdict-word"), "Minimal");
        assert.equal(await page.textContent("h1"), "Chicago, #2394");
    }
});

test("every page has a strict policy and no script of its own", () => {
    for (const name of readdirSync(folder).filter((file) => file.endsWith(".html"))) {
        const text = readFileSync(path.join(folder, name), "utf8");
        assert.match(text, /default-src 'none'; script-src 'self' 'wasm-unsafe-eval';/, name);
        assert.doesNotMatch(
            text,
            /unsafe-inline|'unsafe-eval'|<script(?![^>]* src=)|\son[a-z]+=|<style|@[A-Z]+@/,
            name,
        );
    }
});

test("every page describes itself, for those who pass a link on", () => {
    const descriptions = readdirSync(folder)
        .filter((file) => file.endsWith(".html"))
        .map((name) => {
            const text = readFileSync(path.join(folder, name), "utf8");
            const [, words] = /<meta name="description" content="([^"]{40,200})">/.exec(text) ?? [];
            assert.ok(words, name);
            assert.ok(text.includes(`<meta property="og:description" content="${words}">`), name);
            return words;
        });
    assert.equal(new Set(descriptions).size, descriptions.length);
});

test("the scripts never make HTML of text", () => {
    const scripts = readdirSync(path.join(folder, "site")).filter((file) => file.endsWith(".js"));
    assert.ok(scripts.length > 10);
    for (const name of scripts) {
        const text = readFileSync(path.join(folder, "site", name), "utf8");
        assert.doesNotMatch(
            text,
            /innerHTML|outerHTML|insertAdjacentHTML|document\.write|\beval\(|"text\/html"/,
            name,
        );
    }
});

test("the files are those of the digests, and 80 MB at most", () => {
    const listed = readFileSync(path.join(folder, "SHA256SUMS"), "utf8").trim().split("\n");
    const all = readdirSync(folder, { recursive: true }).filter((name) =>
        statSync(path.join(folder, name)).isFile(),
    );
    assert.deepEqual(
        listed.map((line) => line.slice(66)).sort(),
        all.filter((name) => name !== "SHA256SUMS").sort(),
    );
    execFileSync("sha256sum", ["--check", "--quiet", "SHA256SUMS"], { cwd: folder });
    const bytes = all.reduce((sum, name) => sum + statSync(path.join(folder, name)).size, 0);
    assert.ok(bytes < 80e6, `${bytes} bytes`);
});
