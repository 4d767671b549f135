// What somebody needs who sees such problems for the first time: pictures that are photos of one
// scene, words that say what they mean, results in sight, and how to cite.
import { test } from "node:test";
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import path from "node:path";
import { openForTests, openProblem, outcomeOf, root, textOf, until } from "./browser.mjs";

const plprove = path.join(root, "build/bin/plprove");
const reportOf = (spec) =>
    JSON.parse(execFileSync(plprove, ["problem", spec, "--json"], { encoding: "utf8" }));

const atlas = openForTests();

const problemPage = async (spec, options) => {
    const page = await atlas.visit(`problem.html?p=${encodeURIComponent(spec)}`, options);
    await page.waitForSelector("[data-ready]");
    return page;
};

/** Of each photo of a page the shapes: what each is, and where. */
const shapesOf = (page) =>
    page.locator("main .photos.large .photo").evaluateAll((photos) =>
        photos.map((photo) =>
            [...photo.querySelectorAll("line, circle")].map((shape) => ({
                name: shape.localName,
                seen: shape.getAttribute("class"),
                index: Number(shape.dataset.point ?? shape.dataset.line),
                at: ["x1", "y1", "x2", "y2", "cx", "cy"].map((key) => Number(shape.getAttribute(key))),
            })),
        ),
    );

test("photos are taken from different places, and show what the views see", async () => {
    const shapes = await shapesOf(await problemPage("2*P/P/P + a/Pa/Pa + a/a/a"));
    assert.equal(shapes.length, 3);
    assert.equal(new Set(shapes.map((photo) => JSON.stringify(photo))).size, 3);
    const places = shapes.map((photo) => photo.map(({ at }) => at));
    assert.notDeepEqual(places[0], places[1]);
    assert.notDeepEqual(places[1], places[2]);
    const hidden = (photo) => photo.filter(({ seen }) => seen === "unseen");
    assert.deepEqual(
        hidden(shapes[0]).map(({ name, index }) => [name, index]),
        [["circle", 2]],
    );
    assert.deepEqual([...hidden(shapes[1]), ...hidden(shapes[2])], []);
});

test("points that share a line lie on it in every photo, inside the frame", async () => {
    for (const spec of ["projective: 4*PL/PL + 2*P/P", "3*PL/PL/PL + P/P/P", "1021_1"]) {
        const page = await problemPage(spec);
        const { features } = await page.evaluate(async (asked) => {
            const { Prover } = await import("./site/prover.js");
            return { features: (await new Prover().problem(asked)).scene };
        }, spec);
        const shapes = await shapesOf(page);
        assert.equal(shapes.length, reportOf(spec).views, spec);
        for (const photo of shapes) {
            for (const { at } of photo)
                assert.ok(at.every((x) => x >= 0 && x <= 160), `${spec}: ${at}`);
            const find = (name, index) =>
                photo.find((shape) => shape.name === name && shape.index === index).at;
            features.lines.forEach(({ points }, line) => {
                const [x1, y1, x2, y2] = find("line", line);
                for (const point of points) {
                    const [x, y] = find("circle", point).slice(4);
                    const off = (x2 - x1) * (y - y1) - (y2 - y1) * (x - x1);
                    assert.ok(Math.abs(off) / Math.hypot(x2 - x1, y2 - y1) < 0.05, spec);
                }
            });
        }
    }
});

test("the sketch in space turns by keys, buttons and dragging, and else rests", async () => {
    const page = await problemPage("Chicago");
    const frame = page.locator(".sketch-frame");
    const turn = () => frame.getAttribute("data-turn");
    const drawn = () => frame.locator("svg").evaluate((svg) => svg.outerHTML);
    const [start, first] = [await turn(), await drawn()];
    await page.waitForTimeout(300);
    assert.equal(await turn(), start); // readers of the tests want less motion
    await frame.focus();
    await page.keyboard.press("ArrowLeft");
    assert.notEqual(await turn(), start);
    assert.notEqual(await drawn(), first);
    await page.keyboard.press("ArrowRight");
    assert.equal(await turn(), start);
    assert.equal(await drawn(), first);
    await page.getByRole("button", { name: "Turn up" }).click();
    const up = await turn();
    assert.notEqual(up, start);
    const { x, y } = await frame.boundingBox();
    await page.mouse.move(x + 50, y + 50);
    await page.mouse.down();
    await page.mouse.move(x + 120, y + 60, { steps: 3 });
    await page.mouse.up();
    const dragged = await turn();
    assert.notEqual(dragged, up);
    await page.mouse.move(x + 20, y + 20);
    assert.equal(await turn(), dragged);
    assert.equal(await frame.locator(".camera-name").count(), 3);
});

test("without a wish for rest the sketch swings a little, and then rests", async () => {
    const page = await problemPage("Chicago", { reducedMotion: "no-preference" });
    const turn = () => page.getAttribute(".sketch-frame", "data-turn");
    const standard = await (await problemPage("Chicago")).getAttribute(".sketch-frame", "data-turn");
    await until(
        page,
        (wanted) => document.querySelector(".sketch-frame").dataset.turn === wanted,
        standard,
    );
    await page.waitForTimeout(200);
    assert.equal(await turn(), standard);
});

/** Waits until the page is that of this problem. */
const titled = (page, name) =>
    until(page, (title) => document.querySelector("#problem h1")?.textContent === title, name);

test("the gallery shows what the prover knows", async () => {
    const page = await atlas.visit("index.html");
    await page.waitForSelector("#famous-list li");
    const entries = await page.evaluate(async () => {
        const { famous, sceneOf } = await import("./site/famous.js");
        const { Prover } = await import("./site/prover.js");
        const prover = new Prover();
        const all = [];
        for (const entry of famous) {
            const { scene } = await prover.problem(entry.problem);
            all.push({ ...entry, drawn: sceneOf(entry.problem), scene });
        }
        return all;
    });
    assert.ok(entries.length >= 8);
    for (const { problem, degree, drawn, scene } of entries) {
        const report = reportOf(problem);
        assert.ok(report.minimal, problem);
        assert.equal(report.degree.value, degree, problem);
        assert.equal(report.degree.status, "certified", problem);
        assert.deepEqual(drawn, scene, problem);
    }
    assert.equal(await page.locator("#famous-list li").count(), entries.length);
    await page.getByRole("link", { name: "Chicago" }).click();
    await titled(page, "Chicago, #2394");
});

test("a problem without a verdict is shown as open, with what is seen", async () => {
    const page = await problemPage(openProblem);
    const text = await textOf(page, "#problem");
    assert.equal(await textOf(page, "#problem .verdict-word"), "No verdict: conjectured not minimal");
    assert.doesNotMatch(text, /No such problem/);
    const { evidence, reason } = reportOf(openProblem);
    assert.ok(text.toLowerCase().includes(reason.toLowerCase()));
    assert.ok(text.includes(`${evidence.ranks.join(", ")} at three random places`));
    assert.ok(text.includes(`cameras ${evidence.moving_cameras.join(", ")}`));
    assert.equal(await page.locator(".space circle.moving").count(), evidence.moving_points.length);
    assert.match(await textOf(page, "section:has(#certificate)"), /There is none/);
    await page.goto(`${atlas.address}search.html?p=${encodeURIComponent(openProblem)}`);
    assert.match(await textOf(page, "#answer .verdict-word"), /^No verdict/);
});

test("evidence for a degree is told in words, with what is certified", async () => {
    const page = await problemPage("2003_2");
    const facts = await textOf(page, "#problem .facts-list");
    const { value, certified_at_least } = reportOf("2003_2").degree;
    assert.match(facts, new RegExp(value.toLocaleString("en-US")));
    assert.equal(certified_at_least, value);
    assert.match(facts, /Certified is that there are at least so many; that there are no more is not/);
    assert.doesNotMatch(facts, /ways agree|seeds|trace test/);
    for (const spec of ["3*PL/PL/PL + P/P/P", "projective: 7*P/P", "projective: 6*P/P/P"])
        assert.doesNotMatch(
            await textOf(await problemPage(spec), "#problem .facts-list"),
            /ways agree|seeds/,
        );
});

test("a picture of a problem in six views is downloaded", async () => {
    const page = await problemPage("1021_1");
    const [download] = await Promise.all([
        page.waitForEvent("download"),
        page.getByRole("button", { name: "picture (SVG)" }).click(),
    ]);
    const svg = readFileSync(await download.path(), "utf8");
    assert.match(svg, /^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
    assert.equal(svg.match(/<rect/g).length, 6);
    assert.equal(svg.match(/<circle/g).length, 6);
    assert.doesNotMatch(svg, /NaN/);
});

test("words say what they mean, to a pointer and to the keyboard", async () => {
    const page = await problemPage("Chicago");
    const tip = page.locator("#tip");
    const word = page.locator("dt .term[data-term=degree]");
    await word.hover();
    assert.match(await tip.textContent(), /How many solutions/);
    assert.ok(await tip.isVisible());
    await page.keyboard.press("Escape");
    assert.ok(!(await tip.isVisible()));
    await page.mouse.move(0, 0);
    await page.locator("dt .term[data-term='label class']").focus();
    assert.match(await tip.textContent(), /143,494/);
    assert.ok(await tip.isVisible());
    const described = page.locator("[aria-describedby=tip]");
    assert.equal(await described.getAttribute("data-term"), "label class");
    await page.keyboard.press("Enter");
    await page.waitForSelector(".glossary");
    assert.match(page.url(), /how\.html#word-label-class$/);
});

test("every word that is explained stands in the glossary", async () => {
    const how = await atlas.visit("how.html");
    await how.waitForSelector(".glossary dt");
    const listed = await how.locator(".glossary dt").allTextContents();
    for (const word of ["pin", "terminal", "camera-minimal", "degree", "label class"])
        assert.ok(listed.includes(word), word);
    for (const where of ["index.html", "search.html?p=Chicago", "problem.html?p=7024", "paper.html"]) {
        const page = await atlas.visit(where);
        await page.waitForSelector(".term");
        const words = await page.locator(".term").evaluateAll((all) =>
            all.map((term) => [term.dataset.term, new URL(term.href).hash]),
        );
        for (const [word, hash] of words) {
            assert.ok(listed.includes(word), `${where}: ${word}`);
            assert.equal(await how.locator(hash).textContent(), word);
        }
    }
});

test("the result of a check comes into sight", async () => {
    const viewport = { width: 1280, height: 700 };
    const page = await atlas.visit("check.html", { viewport });
    const { file } = { file: path.join(root, "certs/models/registrations/s_l0_i0_r111111.plc") };
    await page.setInputFiles("#files", file);
    await outcomeOf(page);
    const inSight = (selector) =>
        page.locator(selector).evaluate((element) => {
            const { top, bottom } = element.getBoundingClientRect();
            return top >= 0 && bottom <= window.innerHeight;
        });
    await until(page, () => {
        const { top, bottom } = document.querySelector(".state").getBoundingClientRect();
        return top >= 0 && bottom <= window.innerHeight;
    });
    assert.ok(await inSight(".state"));
    assert.match(await textOf(page, "#chosen"), /, [\d,]+ kB$/);
});

test("classes with the fewest points and lines come first", async () => {
    const page = await atlas.visit("search.html");
    await page.waitForSelector(".card");
    const numbers = await page.locator(".card-number").allTextContents();
    const sizes = numbers.map((number) => {
        const { features } = reportOf(number);
        return features.reduce((sum, { feature, count }) => {
            const letters = new Set(feature.replace(/[^a-zP]/g, ""));
            return sum + count * letters.size;
        }, 0);
    });
    assert.deepEqual(sizes, [...sizes].sort((a, b) => a - b));
    assert.equal(numbers[0], "#6722"); // Cleveland: no other has four
});

test("extensions name the class that decides them, and the degree", async () => {
    const page = await problemPage("2394");
    const item = page.locator("li", { has: page.getByRole("link", { name: "add a/a/-" }) });
    assert.match(await item.textContent(), /decided by class #2394, degree 312$/);
});

test("every count and degree on the page of counts is certified", async () => {
    const page = await atlas.visit("paper.html");
    await page.waitForSelector("#degrees tbody tr");
    const rows = await page.locator("#degrees tbody tr").allTextContents();
    assert.ok(rows.length > 100);
    for (const row of rows) assert.doesNotMatch(row, /open|undecided/);
    const certified = await page.locator("#degrees tbody td:nth-of-type(2)").allTextContents();
    assert.ok(certified.every((text) => /\d/.test(text)));
    assert.match(await textOf(page, "#degrees-sum"), new RegExp(`^Each of the ${rows.length} rows`));
    const links = await page.locator("nav.contents a").allTextContents();
    assert.deepEqual(links, ["Where they differ", "All counts", "Degrees"]);
});

test("the page of a problem has a citation with problem, version and commit", async () => {
    const page = await problemPage("Chicago");
    const meta = (name) => page.getAttribute(`meta[name=atlas-${name}]`, "content");
    const [version, commit] = [await meta("version"), await meta("commit")];
    const address = `${atlas.address}problem.html?p=2394`;
    const line = await textOf(page, ".citation-line");
    const bibtex = await textOf(page, ".citation pre");
    for (const text of [line, bibtex])
        for (const part of [version, commit, address, "2394", "Chicago", "2*Pa/Pa/Pa + P/P/P"])
            assert.ok(text.includes(part), `${part}: ${text}`);
    assert.match(bibtex, /^@software\{pointline-2394,/);
    await page.goto(address);
    await titled(page, "Chicago, #2394");
    const six = await problemPage("1021_1");
    const there = /url\s+= \{(.*)\}/.exec(await textOf(six, ".citation pre"))[1];
    await six.goto(there);
    await titled(six, "1021_1");
});

test("long pages fit 1280 pixels, and every page is led to from the others", async () => {
    const page = await atlas.visit("index.html", { viewport: { width: 1280, height: 900 } });
    await page.waitForSelector("#famous-list li");
    const right = await page
        .locator("#space, #famous-list")
        .evaluateAll((all) => all.map((element) => element.getBoundingClientRect().right));
    for (const edge of right) assert.ok(edge > 1200, `${edge}`);
    const links = await page.locator("header a, footer a").allTextContents();
    for (const word of ["Counts", "Families", "Glossary", "Cite"]) assert.ok(links.includes(word));
});

test("names in photos differ, and are legible on a phone, too", async () => {
    for (const spec of ["Chicago", "projective: 7*P/P", "1021_1"]) {
        const page = await problemPage(spec);
        for (const width of [360, 1280]) {
            await page.setViewportSize({ width, height: 740 });
            const photos = await page.locator("main .photos.large .photo").evaluateAll((all) =>
                all.map((photo) =>
                    [...photo.querySelectorAll("text")].map((text) => ({
                        name: text.textContent,
                        size: parseFloat(getComputedStyle(text).fontSize) * photo.getScreenCTM().a,
                    })),
                ),
            );
            assert.ok(photos.length > 1);
            for (const names of photos) {
                assert.ok(names.length > 2);
                assert.equal(new Set(names.map(({ name }) => name)).size, names.length, spec);
                for (const { name, size } of names)
                    assert.ok(size >= 10, `${spec}, ${width} pixels wide: ${name} has ${size}`);
            }
        }
    }
});

test("headings, text and navigation have one font", async () => {
    const page = await atlas.visit("how.html");
    const session = await page.context().newCDPSession(page);
    await session.send("DOM.enable");
    await session.send("CSS.enable");
    const { root: document } = await session.send("DOM.getDocument");
    const families = new Set();
    for (const selector of ["h1", "h2", ".reading p", "header a"]) {
        const { nodeId } = await session.send("DOM.querySelector", {
            nodeId: document.nodeId,
            selector,
        });
        const { fonts } = await session.send("CSS.getPlatformFontsForNode", { nodeId });
        for (const { familyName } of fonts) families.add(familyName);
    }
    assert.equal(families.size, 1, [...families].join(", "));
});

test("on a phone the matrix scrolls, and its edge shows that there is more", async () => {
    const page = await problemPage("Chicago", { viewport: { width: 360, height: 740 } });
    const frame = page.locator(".jacobian .scroll");
    await frame.focus();
    const { more, shadows } = await frame.evaluate((element) => ({
        more: element.scrollWidth - element.clientWidth,
        shadows: getComputedStyle(element).backgroundImage.match(/linear-gradient/g)?.length,
    }));
    assert.ok(more > 50);
    assert.equal(shadows, 4);
    await page.keyboard.press("ArrowRight");
    await until(page, () => document.querySelector(".jacobian .scroll").scrollLeft > 0);
});

test("of long lists the first are in sight, and the rest is folded", async () => {
    const page = await problemPage("Chicago");
    const extensions = page.locator("#related ~ h3", { hasText: "Extensions" });
    assert.match(await extensions.textContent(), /\(15\)/);
    assert.match(await page.locator("#related ~ details summary").first().textContent(), /^9 more$/);
});

test("the tour leads to what it names", async () => {
    const page = await atlas.visit("how.html");
    const links = await page
        .locator("#tour + ol a")
        .evaluateAll((all) => all.map((link) => [link.textContent, link.getAttribute("href")]));
    assert.equal(links.length, 5);
    const [chicago, play, board, open, counts] = links.map(([, address]) => address);
    const word = async (address, place) =>
        textOf(await atlas.visit(address), `${place} .verdict-word`);
    assert.equal(await word(chicago, "#problem"), "Minimal");
    assert.equal(await word(board, "#answer"), "Minimal");
    assert.match(await word(open, "#problem"), /^Neither minimal/);
    const demo = await atlas.visit(play);
    await demo.waitForSelector("#demo[data-settled]");
    const differences = await atlas.visit(counts);
    await differences.waitForSelector("#differences dt");
    assert.equal(await differences.locator("#differences dt").count(), 3);
});

test("the page of a problem says what its degree is good for", async () => {
    const page = await problemPage("Chicago");
    assert.match(await textOf(page, "section:has(#degree)"), /says how hard the problem is/);
});
