// The page of families: all problems of each, their filters and addresses, and their certificates,
// replayed in the browser.
import { test } from "node:test";
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { openForTests, outcomeOf, root, textOf, until, violationsOf } from "./browser.mjs";

const plcheck = path.join(root, "build/bin/plcheck");
const plprove = path.join(root, "build/bin/plprove");
const sizes = { plmp: 39, projective: 660, "upright-shared-focal": 15 };
const minimal = { plmp: 30, projective: 293, "upright-shared-focal": 8 };

const atlas = openForTests();

const lists = (...words) =>
    execFileSync(plprove, ["list", "--format", "notation", ...words], { encoding: "utf8" })
        .trim()
        .split("\n");

/** The page at an address, once its list is there. */
async function visit(query = "", options = {}) {
    const page = await atlas.visit(`families.html${query}`, options);
    await page.waitForSelector("#problems li");
    return page;
}

const notations = (page) => page.locator("#problems .notation").allTextContents();

for (const [family, size] of Object.entries(sizes)) {
    test(`all ${size} problems of ${family} are listed, as the program lists them`, async () => {
        const page = await visit(`?family=${family}`);
        const listed = await notations(page);
        assert.equal(listed.length, size);
        assert.deepEqual(listed, lists("--family", family));
        assert.equal(await page.textContent("#total"), `${size} of ${size} problems`);
    });

    test(`the archive of ${family} is replayed, in the program's words, and fills the table`, async () => {
        const page = await visit();
        await page.click(`#${family} .check-now`);
        const { state, output } = await outcomeOf(page, `#${family}`);
        assert.match(state, /^VERIFIED/);
        const words = ["--family", family, `certs/${family}.plc`];
        const folder = { cwd: path.join(root, "build/atlas"), encoding: "utf8" };
        assert.equal(output, execFileSync(plcheck, words, folder));
        assert.match(output, new RegExp(`all ${size} problems are certified, ${minimal[family]} `));
        assert.match(await page.textContent(`#${family} caption`), /your browser just derived/);
        const rows = await page.locator(`#${family} tbody tr`).allTextContents();
        const { families } = JSON.parse(execFileSync(plcheck, ["--json", ...words], folder));
        assert.deepEqual(
            rows,
            families[0].claims.map(
                ({ claim, paper, certified, verdict }) =>
                    claim.replace(/^- /, "") + (paper ?? "-") + certified + verdict,
            ),
        );
    });

    test(`an archive of ${family} that was tampered with is refused, with its reason`, async () => {
        const text = readFileSync(path.join(root, `build/atlas/certs/${family}.plc`), "utf8");
        const tampered = text.replace(/^scene -?\d+/m, "scene 99");
        assert.notEqual(tampered, text);
        const folder = mkdtempSync(path.join(tmpdir(), "atlas-"));
        mkdirSync(path.join(folder, "certs"));
        writeFileSync(path.join(folder, `certs/${family}.plc`), tampered);
        const page = await visit();
        await page.route(`**/certs/${family}.plc`, (route) => route.fulfill({ body: tampered }));
        await page.click(`#${family} .check-now`);
        const { state, output } = await outcomeOf(page, `#${family}`);
        assert.match(state, /^NOT VERIFIED .* status 1/);
        const native = spawnSync(plcheck, ["--family", family, `certs/${family}.plc`], {
            cwd: folder,
            encoding: "utf8",
        });
        assert.equal(output, native.stderr + native.stdout);
        assert.match(output, /plc:\d+: .*minor/);
    });
}

test("each family has its counts and its list", async () => {
    const page = await visit();
    const families = await page
        .locator("[name=family] option")
        .evaluateAll((all) => all.map((option) => option.value));
    assert.equal(families.length, 9);
    for (const family of families) {
        await page.selectOption("[name=family]", family);
        const listed = lists("--family", family);
        const total = `${listed.length} of ${listed.length} problems`;
        await until(page, (text) => document.querySelector("#total").textContent === text, total);
        assert.deepEqual(await notations(page), listed);
        if (["plmp", "projective"].includes(family)) continue; // their tables are those of papers
        const counts = await page.locator(`#${family} tbody tr`).allTextContents();
        const found = lists("--family", family, "--minimal").length;
        assert.ok(counts.includes(`minimal-${found}no claim`), `${family}: ${counts}`);
    }
    const hyphens = await visit("#upright-shared-focal-1");
    const record = await textOf(hyphens, "#upright-shared-focal-1 .record");
    assert.match(record, /^problem upright-shared-focal: /m);
});

test("the problems are filtered by views and verdict, and the address keeps the filters", async () => {
    const page = await visit();
    await page.selectOption("[name=family]", "projective");
    await page.selectOption("[name=verdict]", "minimal");
    await until(page, () => document.querySelectorAll("#problems li").length === 293);
    assert.deepEqual(await notations(page), lists("--family", "projective", "--minimal"));
    await page.selectOption("[name=views]", "9");
    await until(page, () => document.querySelectorAll("#problems li").length === 1);
    assert.deepEqual(await notations(page), ["projective: 6*a/a/a/a/a/a/a/a/a"]);
    const query = new URL(page.url()).search;
    const again = await visit(query);
    assert.deepEqual(await notations(again), await notations(page));
});

test("a problem says its verdict with the reason, its degree with its status", async () => {
    const page = await visit();
    const facts = await page.locator("#problems .facts").allTextContents();
    assert.equal(
        facts[0],
        "2 views · minimal · degree 20 certified · group <S2 wr S10 certified · page of 5000_2",
    );
    assert.equal(
        facts[1],
        "2 views · minimal · degree 16 certified · group <S2 wr S8 evidence · page of 4100_3",
    );
    assert.match(facts[2], /^2 views · not minimal: points 1, 2, 3 and 4 lie on a line: their cross-/);
    assert.equal(facts.filter((text) => text.includes(" · minimal")).length, minimal.plmp);
});

test("a deep link opens the certificate's record, and the record is checked", async () => {
    const page = await visit("#projective-15");
    const record = await textOf(page, "#projective-15 .record");
    const archive = readFileSync(path.join(root, "certs/projective.plc"), "utf8");
    const problem = lists("--family", "projective")[14];
    assert.match(record, /^plcert 2 problems\nmodulus \d+\nproblem /);
    const own = record.slice(record.indexOf("problem projective"));
    assert.ok(own.startsWith(`problem ${problem}\n`));
    assert.ok(archive.includes(`${own}problem `), "the record is the archive's, to its end");
    await page.click("#projective-15 button");
    const { output } = await outcomeOf(page, "#projective-15");
    assert.ok(output.includes(`VERIFIED: ${problem} is not-minimal`), output);
});

test("a deep link wins over filters that hide its problem, and works within the page", async () => {
    const page = await visit("?views=6&verdict=minimal#plmp-1");
    assert.match(await textOf(page, "#plmp-1 .record"), /^problem 5\*P\/P\nminimal /m);
    await page.click("#plmp-3 a.card-number");
    assert.match(await textOf(page, "#plmp-3 .record"), /^collinear 1 2 3 4 views 1 2$/m);
    const nowhere = await visit("#plmp-40");
    await until(nowhere, () => /none of them is plmp-40/.test(document.body.textContent));
});

/** What the list says of the degree of a problem, from what the program says. */
function degreeInWords({ degree }) {
    if (!degree) return "no degree on file";
    const words = { exact: "", "at-least": "at least " };
    const least = words[degree.bound ?? "exact"]; // that of a class is exact
    return `degree ${least}${degree.value.toLocaleString("en-US")} ${degree.status}`;
}

test("each problem leads to its page, and has the degree there", async () => {
    const page = await visit();
    const leading = await page.locator("#problems .facts:has(a)").evaluateAll((all) =>
        all.map((facts) => ({ text: facts.textContent, link: facts.querySelector("a").href })),
    );
    assert.equal(leading.length, sizes.plmp);
    for (const { text, link } of leading) {
        const spec = new URL(link).searchParams.get("p");
        const report = JSON.parse(
            execFileSync(plprove, ["problem", spec, "--json"], { encoding: "utf8" }),
        );
        assert.equal(text.includes(" · minimal"), report.minimal, spec);
        assert.ok(!report.minimal || text.includes(degreeInWords(report)), `${spec}: ${text}`);
    }
    const verdicts = {
        "3002_1": "Minimal",
        "1008_8": "Neither minimal nor camera-minimal: obstructed",
        "1021_1": "Minimal",
        "3200_4": "Not minimal",
    };
    for (const [name, verdict] of Object.entries(verdicts)) {
        const there = await visit();
        await there.getByRole("link", { name: `page of ${name}` }).click();
        assert.equal(await textOf(there, "#problem .verdict-word"), verdict);
    }
});

test("axe finds nothing on an open certificate and a long list", async () => {
    const page = await visit("#projective-1");
    await page.waitForSelector("#projective-1 .record");
    await page.click("#projective-1 button");
    await outcomeOf(page, "#projective-1");
    assert.deepEqual(await violationsOf(page), []);
});

test("an open certificate is no wider than a phone", async () => {
    const page = await visit("#projective-100", { viewport: { width: 360, height: 740 } });
    await page.waitForSelector("#projective-100 .record");
    await page.click("#projective-100 button");
    await outcomeOf(page, "#projective-100");
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 360, `${width} pixels wide`);
});
