// The page Play: libpointline solves photos in the browser, and the reader moves them.
import { test } from "node:test";
import assert from "node:assert/strict";
import { openForTests, until, violationsOf } from "./browser.mjs";

const atlas = openForTests();

const degrees = { "five-points": 20, chicago: 312 };

/** The page of a problem, with its solutions. */
async function visit(problem, options = {}) {
    const page = await atlas.visit(`demo.html?problem=${problem}`, options);
    await page.waitForSelector("#demo[data-settled]");
    return page;
}

const dataOf = (page) => page.evaluate(() => ({ ...document.querySelector("#demo").dataset }));
const pathsOf = (page) =>
    page
        .locator(".play-space .solution")
        .evaluateAll((paths) => paths.map((path) => path.getAttribute("d")));

/** Waits for more pictures, and until the page rests. */
async function pictureAfter(page, before) {
    await until(
        page,
        (was) => {
            const { pictures, settled } = document.querySelector("#demo").dataset;
            return Number(pictures) > Number(was) && settled !== undefined;
        },
        before.pictures,
    );
}

/** What the page's own scripts find for a scene, while `steps` steps move it: of each answer how
 * many solutions were found, the cameras of the real ones, and the true cameras. */
const solveSteps = (page, problem, seed, steps) =>
    page.evaluate(
        async ([id, seed, steps]) => {
            const { problems, Scene } = await import("./site/demo_scene.js");
            const { ImageSolver } = await import("./site/demo_solver.js");
            const scene = new Scene(
                problems.find((one) => one.id === id),
                seed,
            );
            const solver = new ImageSolver(scene.problem);
            await solver.open();
            const numbers = (cameras) => cameras.flatMap(({ rows, t }) => [...rows.flat(), ...t]);
            const answers = [];
            for (let step = 0; step <= steps; ++step) {
                const answer = await solver.solve(scene.images(), false);
                answers.push({
                    found: answer.found,
                    degree: answer.degree,
                    certified: answer.certified,
                    truth: numbers(scene.normalisedCameras()),
                    cameras: answer.solutions.map((solution) => numbers(solution.cameras)),
                    inFront: answer.solutions.map((solution) => solution.inFront),
                    residual: Math.max(...answer.solutions.map((one) => one.residual)),
                });
                const handle = { view: 1, feature: 0, line: -1 };
                const [x, y] = scene.place(handle);
                scene.movePlace(handle, [x + 0.02, y + 0.01]);
            }
            solver.close();
            return answers;
        },
        [problem, seed, steps],
    );

const distance = (a, b) => Math.max(...a.map((x, k) => Math.abs(x - b[k])));
const nearest = (list, cameras) => Math.min(...list.map((one) => distance(one, cameras)));

for (const [problem, degree] of Object.entries(degrees)) {
    test(`${problem} has ${degree} solutions, and the true cameras are one`, async () => {
        const page = await atlas.visit("demo.html");
        for (const seed of problem === "chicago" ? [1, 2] : [1, 2, 3, 4, 5, 6]) {
            const [answer] = await solveSteps(page, problem, seed, 0);
            assert.equal(answer.degree, degree);
            assert.equal(answer.found, degree, `scene ${seed}`);
            assert.ok(answer.certified);
            assert.ok(nearest(answer.cameras, answer.truth) < 1e-7, `scene ${seed}`);
            // In front of all cameras, as the scene is made so.
            const index = answer.cameras.findIndex((one) => distance(one, answer.truth) < 1e-7);
            assert.equal(answer.inFront[index], problem === "chicago" ? 3 : 5);
            assert.ok(answer.residual < 1e-6, `${answer.residual} pixels`);
            assert.equal((degree - answer.cameras.length) % 2, 0, "others come in pairs");
        }
    });
}

test("while a point moves, the solutions move continuously", async () => {
    const page = await atlas.visit("demo.html");
    const answers = await solveSteps(page, "five-points", 1, 40);
    let same = 0;
    for (const [k, after] of answers.entries()) {
        if (k === 0) continue;
        const before = answers[k - 1];
        // Two solutions that meet leave as a pair, with those that are turned by half a turn.
        assert.equal((after.cameras.length - before.cameras.length) % 4, 0);
        assert.notDeepEqual(after.cameras, before.cameras);
        if (after.cameras.length !== before.cameras.length) continue;
        ++same;
        for (const cameras of after.cameras) assert.ok(nearest(before.cameras, cameras) < 0.1);
    }
    assert.ok(same > 30);
    // What was true is no more.
    assert.ok(nearest(answers.at(-1).cameras, answers[0].truth) > 1e-5);
});

test("a mouse, a finger and the keyboard move points and cameras", async () => {
    const page = await visit("five-points", { hasTouch: true });
    const move = async (action) => {
        const [before, paths] = [await dataOf(page), await pathsOf(page)];
        await action();
        await pictureAfter(page, before);
        assert.notDeepEqual(await pathsOf(page), paths);
        return dataOf(page);
    };
    assert.ok(Number((await dataOf(page)).off) < 1e-7);
    const handle = (name) => page.locator(`[role=slider][aria-label="${name}"]`);

    // In space: the photos change, and the truth is found again.
    const byKey = async (name) => {
        await handle(name).focus();
        await page.keyboard.press("ArrowRight");
    };
    assert.ok(Number((await move(() => byKey("Camera 2"))).off) < 1e-7);
    assert.ok(Number((await move(() => byKey("Point 3 in space"))).off) < 1e-7);

    // In a photo: the truth is gone until the change is undone.
    const dragged = async () => {
        const target = handle("Point 1 in photo 2").locator(".target");
        await target.scrollIntoViewIfNeeded();
        const box = await target.boundingBox();
        const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.mouse.move(x + 12, y + 7, { steps: 4 });
        await page.mouse.up();
    };
    assert.ok(Number((await move(dragged)).off) > 1e-6);
    assert.ok(Number((await move(() => page.click("#reset"))).off) < 1e-7);
    assert.ok(Number((await move(() => byKey("Point 2 in photo 1"))).off) > 1e-6);
    assert.ok(Number((await move(() => page.click("#reset"))).off) < 1e-7);

    const touched = () =>
        handle("Point 4 in photo 1").evaluate((element) => {
            const { left, top, width, height } = element.getBoundingClientRect();
            const at = { pointerId: 7, pointerType: "touch", bubbles: true, isPrimary: true };
            const place = (by) => ({
                ...at,
                clientX: left + width / 2 + by,
                clientY: top + height / 2 + by,
            });
            element.setPointerCapture = () => {}; // no finger is there to be captured
            element.dispatchEvent(new PointerEvent("pointerdown", place(0)));
            element.dispatchEvent(new PointerEvent("pointermove", place(9)));
            element.dispatchEvent(new PointerEvent("lostpointercapture", at));
        });
    assert.ok(Number((await move(touched)).off) > 1e-6);
    assert.ok(Number((await move(() => page.click("#reset"))).off) < 1e-7);

    // Noise moves all photos.
    assert.ok(Number((await move(() => page.fill("#noise", "2"))).off) > 1e-6);
});

test("Chicago is solved on its page, and a line turns", async () => {
    const page = await visit("chicago");
    const before = await dataOf(page);
    assert.equal(before.found, "312");
    assert.ok(Number(before.off) < 1e-7);
    assert.match(await page.textContent("#complex"), /^312 of 312; that there are no more is cert/);
    assert.equal(Number(await page.textContent("#real")), (await pathsOf(page)).length);
    await page.locator('[aria-label="Line through point 1 in photo 3"]').focus();
    await page.keyboard.press("ArrowRight");
    await pictureAfter(page, before);
    assert.ok(Number((await dataOf(page)).off) > 1e-6);
});

test("a camera moves by itself, and the marked solution follows the truth", async () => {
    const page = await visit("five-points");
    const before = await dataOf(page);
    await page.check("#moving");
    await until(
        page,
        (was) => Number(document.querySelector("#demo").dataset.pictures) > Number(was) + 5,
        before.pictures,
    );
    await page.uncheck("#moving");
    await page.waitForSelector("#demo[data-settled]");
    assert.ok(Number((await dataOf(page)).off) < 1e-7);
    assert.match(await page.textContent("#truth"), /^found: solution \d+, off by/);
    assert.match(await page.textContent("#summary"), /real solutions/);
    assert.match(await page.textContent("#rate"), /^\d+(\.\d)? a second$/);
});

for (const colorScheme of ["light", "dark"])
    test(`axe finds nothing on the page (${colorScheme}), and a phone is wide enough`, async () => {
        const page = await visit("chicago", {
            colorScheme,
            viewport: { width: 375, height: 740 },
        });
        assert.deepEqual(await violationsOf(page), []);
        const width = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(width <= 375, `${width} pixels`);
    });
