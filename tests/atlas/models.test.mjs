// The page of models: all of them, those with some words, their addresses, and their certificates,
// replayed in the browser.
import { test } from "node:test";
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { openForTests, outcomeOf, root, until } from "./browser.mjs";

const plcheck = path.join(root, "build/bin/plcheck");
const folder = { cwd: path.join(root, "build/atlas"), encoding: "utf8" };
const files = readdirSync(path.join(root, "models")).filter((name) => name.endsWith(".model"));

const atlas = openForTests();

async function visit(rest = "", options = {}) {
    const page = await atlas.visit(`models.html${rest}`, options);
    await page.waitForSelector("#models li");
    return page;
}

test("all models are there, each with its text and what plcheck says of it", async () => {
    const page = await visit();
    assert.equal(await page.textContent("#total"), `${files.length} of ${files.length} models`);
    const names = await page.locator("#models li").evaluateAll((items) => items.map(({ id }) => id));
    assert.deepEqual([...names].sort(), files.map((file) => file.replace(".model", "")).sort());
    for (const name of ["p3p", "bitangents"]) {
        const certificate = `certs/models/${name}.plc`;
        const [said] = JSON.parse(execFileSync(plcheck, ["--json", certificate], folder)).files;
        const { certified_at_least: least, certified_at_most: most } = said;
        const facts = await page.textContent(`#${name} .facts`);
        assert.match(facts, new RegExp(`^${least === most ? "exactly" : "at least"} ${least} sol`));
        assert.equal(
            await page.textContent(`#${name} .record`),
            readFileSync(path.join(root, "models", `${name}.model`), "utf8"),
        );
    }
});

test("a certificate is replayed in the browser, in the program's words", async () => {
    const page = await visit("#p3p");
    await page.click("#p3p button");
    const { state, output } = await outcomeOf(page, "#p3p");
    assert.match(state, /^VERIFIED/);
    assert.equal(output, execFileSync(plcheck, ["certs/models/p3p.plc"], folder));
});

test("a certificate that was tampered with is refused", async () => {
    const page = await visit("#p3p");
    const text = readFileSync(path.join(root, "certs/models/p3p.plc"), "utf8");
    const body = text.replace(/^polynomial \d+/m, "polynomial 7");
    assert.notEqual(body, text);
    await page.route("**/certs/models/p3p.plc", (route) => route.fulfill({ body }));
    await page.click("#p3p button");
    const { state } = await outcomeOf(page, "#p3p");
    assert.match(state, /^NOT VERIFIED/);
});

test("words choose models; the address has them, and a name that they hide is shown", async () => {
    const page = await visit("?words=rolling");
    assert.match(await page.textContent("#total"), /^\d of /);
    await page.fill("#words", "focal points");
    await until(page, () => location.search === "?words=focal+points");
    await until(page, () => document.querySelectorAll("#models li").length > 2);
    const hidden = await visit("?words=rolling#p3p");
    await hidden.waitForSelector("#p3p details[open]");
    const missing = await visit("#nothing");
    await until(missing, () => document.querySelector("#total").textContent.includes("nothing"));
});

test("the search finds models by their words", async () => {
    const page = await atlas.visit("search.html");
    await page.fill("#spec", "rolling shutter");
    await page.click("#ask button");
    await page.waitForSelector("#answer a[href='models.html#rolling_shutter']");
});
