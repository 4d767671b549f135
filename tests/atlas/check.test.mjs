// Checking in the browser: what the page says is what the program says, of good files and of bad
// ones.
import { test } from "node:test";
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { openForTests, outcomeOf, root, textOf } from "./browser.mjs";

const plcheck = path.join(root, "build/bin/plcheck");
const plprove = path.join(root, "build/bin/plprove");
const folder = mkdtempSync(path.join(tmpdir(), "atlas-"));

const atlas = openForTests();

test("the whole classification is replayed, and fills the table", async () => {
    const page = await atlas.visit("index.html");
    await page.click("#check-now");
    const { state, output } = await outcomeOf(page);
    assert.match(state, /^VERIFIED in this browser/);
    assert.match(output, /all 143494 label classes are certified, 140616 minimal/);
    assert.match(await page.textContent("#counts caption"), /your browser just derived/);
    assert.match(
        await page.textContent("#counts tbody"),
        /label classes, minimal140,616140,616confirmed/,
    );
});

test("a problem's certificate is found and checked on its page", async () => {
    const page = await atlas.visit("problem.html?p=2394");
    await page.click("#check-now");
    const { output } = await outcomeOf(page);
    assert.match(output, /VERIFIED: 2\*Pa\/Pa\/Pa \+ P\/P\/P is minimal \(class-2394\.plc\)/);
    const minor = /^minimal 2394 1 (\d+)$/m.exec(
        execFileSync(plprove, ["certify", "2394"], { encoding: "utf8" }),
    )[1];
    assert.ok((await page.textContent("#problem")).includes(minor));
});

test("an obstructed problem's certificate is checked, too", async () => {
    const page = await atlas.visit("problem.html?p=P/P/P+%2B+a/a/a+%2B+5*-/P/P+%2B+P/-/P");
    await page.click("#check-now");
    assert.match((await outcomeOf(page)).output, /VERIFIED: .* is obstructed/);
});

test("a problem of six views is certified and checked on its page", async () => {
    const page = await atlas.visit("problem.html?p=1021_1");
    await page.getByRole("button", { name: "Check this certificate" }).click();
    const { output } = await outcomeOf(page);
    assert.match(output, /^VERIFIED: Pa\/Pa\/Pa\/Pa\/Pa\/Pa \+ 2\*a\/a\/a\/a\/a\/a is minimal/m);
    const native = execFileSync(plprove, ["certify", "1021_1"], { encoding: "utf8" });
    assert.equal(await page.textContent(".record"), native);
});

test("an extension of a problem stays minimal, of the same class", async () => {
    const page = await atlas.visit("problem.html?p=2394");
    await page.waitForSelector("[data-ready]");
    await page.getByRole("link", { name: "add a/a/-" }).click();
    await page.waitForSelector("[data-ready]");
    assert.equal(await textOf(page, "#problem .verdict-word"), "Minimal");
    assert.match(await textOf(page, "#problem .facts-list"), /#2394 \(it is decided by this class\)/);
});

test("a degree is certified in the browser, lower and upper bound", async () => {
    const page = await atlas.visit("problem.html?p=4");
    await page.click("#check-degree");
    const { state, output } = await outcomeOf(page, "section:has(#check-degree)");
    assert.match(state, /^VERIFIED/);
    assert.match(output, /has exactly 64 camera solutions/);
});

test("a file of the reader's is checked; a tampered one is refused with its reason", async () => {
    const good = path.join(folder, "good.plc");
    execFileSync(plprove, ["certify", "2394", "-o", good]);
    const text = readFileSync(good, "utf8");
    const bad = path.join(folder, "bad.plc");
    writeFileSync(bad, text.replace("point 3 -2 -1", "point 3 -2 -2"));
    const page = await atlas.visit("check.html");
    await page.setInputFiles("#files", good);
    assert.match((await outcomeOf(page)).state, /^VERIFIED/);
    await page.setInputFiles("#files", bad);
    await page.waitForSelector(".state.refused");
    const { state, output } = await outcomeOf(page);
    assert.match(state, /^NOT VERIFIED .* status 1/);
    const native = spawnSync(plcheck, ["bad.plc"], { cwd: folder, encoding: "utf8" });
    assert.equal(output, native.stderr + native.stdout);
    assert.match(output, /bad\.plc:\d+: .*minor/);
});

test("a file proves no more than what is expected of it", async () => {
    const good = path.join(folder, "good.plc");
    const page = await atlas.visit("check.html");
    await page.fill("[name=expect]", "3*P/P/P + a/a/a");
    await page.selectOption("[name=verdict]", "minimal");
    await page.setInputFiles("#files", good);
    assert.match((await outcomeOf(page)).state, /^NOT VERIFIED/);
});

test("text in a file never becomes a part of the page", async () => {
    const hostile = path.join(folder, "hostile.plc");
    writeFileSync(hostile, "plcert 2 <img/src=x/onerror=alert(1)>\n");
    const page = await atlas.visit("check.html");
    await page.setInputFiles("#files", hostile);
    assert.match((await outcomeOf(page)).output, /<img\/src=x/);
    assert.equal(await page.locator("main img").count(), 0);
});

test("the checker says of every file what the program says, to the letter", async () => {
    const corpus = path.join(root, "tests/fuzz/corpus/certificate");
    const regressions = path.join(root, "tests/fuzz/regressions/certificate");
    const files = [corpus, regressions].flatMap((from) =>
        readdirSync(from).map((name) => path.join(from, name)),
    );
    files.push(path.join(root, "certs/models/registrations/s_l0_i0_r111111.plc"));
    assert.ok(files.length > 20);
    const page = await atlas.visit("check.html");
    for (const file of files) {
        const native = spawnSync(plcheck, ["--json", path.basename(file)], {
            cwd: path.dirname(file),
            encoding: "utf8",
            maxBuffer: 1 << 26,
        });
        const outcome = await page.evaluate(
            async ([name, base64]) => {
                const { check } = await import("./site/checker.js");
                const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
                return check({ options: [], files: [{ name, bytes: bytes.buffer }] }, () => {});
            },
            [path.basename(file), readFileSync(file).toString("base64")],
        );
        // A page has no working folder, which one message names.
        const nowhere = (text) => text.replaceAll(`folder, ${path.dirname(file)};`, "folder, ;");
        assert.equal(outcome.status, native.status, file);
        assert.equal(outcome.report, nowhere(native.stdout), file);
        assert.equal(outcome.errors, nowhere(native.stderr), file);
    }
});

test("the prover says of a problem what the program says, to the letter", async () => {
    const page = await atlas.visit("check.html");
    const specs = [
        "Chicago",
        "five-point",
        "P3P+five-point",
        "0",
        "2394",
        "72050",
        "143493",
        "3*P/P/P + P/P/a + Pa/-/-",
        "7*P/P/P",
        "P/P/P",
        "6*P/P",
        "2*Pa/Pa/Pa + a/a/-",
    ];
    for (const spec of specs) {
        const run = (...words) => execFileSync(plprove, words, { encoding: "utf8" });
        const answers = await page.evaluate(async (asked) => {
            const { Prover } = await import("./site/prover.js");
            const prover = new Prover();
            const texts = {};
            for (const kind of ["certificate", "svg", "tikz", "macaulay2", "julia"])
                texts[kind] = await prover.file(asked, kind);
            return { report: (await prover.problem(asked)).report, ...texts };
        }, spec);
        assert.deepEqual(answers.report, JSON.parse(run("problem", spec, "--json")), spec);
        assert.equal(answers.certificate, run("certify", spec), spec);
        assert.equal(answers.svg, run("show", spec, "--svg", "-"), spec);
        assert.equal(answers.tikz, run("show", spec, "--tikz", "-"), spec);
        assert.equal(answers.macaulay2, run("export", "--macaulay2", spec), spec);
        assert.equal(answers.julia, run("export", "--julia", spec), spec);
    }
});

test("a download has the bytes that the program writes", async () => {
    const page = await atlas.visit("problem.html?p=2394");
    await textOf(page, "#downloads");
    const [download] = await Promise.all([
        page.waitForEvent("download"),
        page.getByRole("button", { name: "certificate (.plc)" }).click(),
    ]);
    assert.equal(download.suggestedFilename(), "class-2394.plc");
    assert.equal(
        readFileSync(await download.path(), "utf8"),
        execFileSync(plprove, ["certify", "2394"], { encoding: "utf8" }),
    );
});
