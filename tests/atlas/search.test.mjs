// Asking and searching: notation, drawing, neighbours, filters, and addresses that say it all.
import { test } from "node:test";
import assert from "node:assert/strict";
import { openForTests, textOf, until } from "./browser.mjs";

const atlas = openForTests();

test("what is typed is decided, with reason, number and degree", async () => {
    const page = await atlas.visit("search.html");
    await page.fill("#spec", "2*P/P/P + a/Pa/Pa + a/a/a");
    assert.equal(await textOf(page, "#answer .verdict-word"), "Minimal");
    const answer = await page.textContent("#answer");
    assert.match(answer, /#6736/);
    assert.match(answer, /240 certified/);
    assert.match(page.url(), /\?p=/);
});

test("neighbours of a class are one exchange of features away", async () => {
    const page = await atlas.visit("search.html?p=Chicago");
    await page.waitForSelector("#answer li a[href='problem.html?p=2395']");
    assert.match(await page.textContent("#answer"), /a\/Pa\/Pa instead of P\/P\/P: #2395/);
});

test("a problem that is not minimal comes with what makes it so", async () => {
    const page = await atlas.visit("search.html?p=3*P/P/P");
    assert.match(await textOf(page, "#answer .verdict-word"), /under-constrained/);
    assert.match(await page.textContent("#answer"), /What makes it minimal/);
});

test("problems of any number of views and of projective cameras are decided", async () => {
    const page = await atlas.visit("search.html");
    await page.fill("#spec", "projective: 6*P/P/P");
    await until(page, () => /projective cameras/.test(document.querySelector("#answer").textContent));
    const answer = await textOf(page, "#answer");
    assert.match(answer, /Minimal.*3 projective cameras.*scene 18 \+ cameras 18 = images 36.*certified/s);
    await page.fill("#spec", "4*PL/PL/PL/PL");
    await until(page, () => /4 calibrated/.test(document.querySelector("#answer").textContent));
    assert.match(await textOf(page, "#answer"), /Not minimal.*against images/s);
    assert.match(await textOf(page, "#board"), /The board changes/);
    await page.getByRole("link", { name: /Its page/ }).click();
    assert.equal(await textOf(page, "#problem .asked"), "4*PL/PL/PL/PL");
});

test("what is no problem is refused with the program's words", async () => {
    const page = await atlas.visit("search.html?p=2*Q/P/P");
    assert.match(await textOf(page, "#ask .complaint"), /column 3/);
    assert.equal(await page.getAttribute("#spec", "aria-invalid"), "true");
    assert.match(await textOf(page, "#board"), /Nothing is drawn yet/);
    const page2 = await atlas.visit("search.html?p=%3Cimg src=x onerror=alert(1)%3E");
    assert.ok(await textOf(page2, "#ask .complaint"));
    assert.equal(await page2.locator("main img").count(), 0);
});

test("a complaint stands just below the field, and the drawing stays", async () => {
    const page = await atlas.visit("search.html?p=Chicago");
    await page.waitForSelector(".board-views .photo");
    await page.fill("#spec", "2*Q/P/P");
    const complaint = await page.waitForSelector("#ask .complaint");
    const field = await page.locator("#spec").boundingBox();
    const words = await complaint.boundingBox();
    const below = words.y - (field.y + field.height);
    assert.ok(below >= 0 && below < 20, `${below} pixels below the field`);
    assert.ok(Math.abs(words.x - field.x) < 20);
    assert.equal(await page.locator(".board-views .photo").count(), 3);
});

test("features are drawn, hidden by a click in a view, and shown by a key", async () => {
    const page = await atlas.visit("search.html");
    await page.getByRole("button", { name: "Add a point", exact: true }).click();
    await page.waitForSelector(".board-views circle.seen");
    assert.equal(await page.inputValue("#spec"), "P/P/P");
    await page.locator(".board-views circle.target").nth(2).click();
    await page.waitForSelector(".board-views circle.unseen");
    assert.equal(await page.inputValue("#spec"), "P/P/-");
    const hide = page.getByRole("button", { name: "point of feature 1, view 1" });
    await hide.focus();
    await page.keyboard.press("Enter");
    await until(page, () => document.querySelector("#spec").value === "-/P/-");
    const label = () => document.activeElement.getAttribute("aria-label");
    await until(page, label);
    assert.equal(await page.evaluate(label), "point of feature 1, view 1");
});

test("a line in the drawing is hidden in the view that is clicked", async () => {
    const page = await atlas.visit("search.html?p=Pab/Pab/Pab+%2B+a/a/a");
    await page.waitForSelector(".board-views line.target");
    const lines = page.locator(".board-views .photo-frame:nth-of-type(2) line.target");
    assert.equal(await lines.count(), 3);
    await lines.nth(2).click();
    await until(page, () => document.querySelector("#spec").value.endsWith("a/-/a"));
    assert.equal(await page.inputValue("#spec"), "Pab/Pab/Pab + a/-/a");
});

test("filters find what plprove list finds", async () => {
    const page = await atlas.visit(
        "search.html?verdict=terminal&one-pin=on&points=..3&free-lines=0",
    );
    await page.waitForSelector(".card");
    assert.deepEqual(await page.locator(".card-number").allTextContents(), ["#2394", "#2395"]);
    assert.match(await page.textContent("#total"), /^2 of 143,494/);
    await page.getByRole("button", { name: "Clear the filters" }).click();
    await until(page, () => document.querySelector("#total").textContent.startsWith("143,494 of"));
});

test("a filter that makes no sense is refused with what was expected", async () => {
    const page = await atlas.visit("search.html?points=many");
    await until(page, () =>
        /expected N or N\.\.M/.test(document.querySelector("#total").textContent),
    );
    // Beside the field, too.
    assert.match(await textOf(page, "label:has([name=points]) .field-message"), /expected N or N\.\.M/);
    await page.fill("[name=points]", "3");
    await until(page, () => document.querySelector(".field-message") === null);
});

test("an address restores search and page; back leads to it", async () => {
    const page = await atlas.visit(
        "search.html?verdict=minimal&sort=degree&order=descending&first=24",
    );
    await page.waitForSelector(".card");
    assert.match(await page.textContent("#pager"), /25 to 48/);
    const first = await page.textContent(".card-number");
    await page.click(".card-link");
    await page.waitForSelector("#problem .verdict-word");
    await page.goBack();
    await page.waitForSelector(".card");
    assert.equal(await page.textContent(".card-number"), first);
    assert.equal(await page.inputValue("[name=sort]"), "degree");
});
