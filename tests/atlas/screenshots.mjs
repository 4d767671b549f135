// Makes the pictures of docs/atlas anew, from the built atlas:    node tests/atlas/screenshots.mjs
import path from "node:path";
import { open, root } from "./browser.mjs";

const viewport = { width: 1280, height: 900 };
const pictures = {
    problem: ["problem.html?p=Chicago", "[data-ready]"],
    search: ["search.html?p=2*P/P/P+%2B+a/Pa/Pa+%2B+a/a/a", "#answer li a"],
    families: ["families.html#plmp-19", "#plmp-19 .record"],
    general: ["problem.html?p=1021_1", "[data-ready]"],
};

const atlas = await open();
for (const [name, [address, ready]] of Object.entries(pictures)) {
    const page = await atlas.visit(address, { viewport });
    await page.waitForSelector(ready);
    await page.screenshot({ path: path.join(root, `docs/atlas/${name}.png`) });
}
await atlas.close();
