// The start page: the main counts of the paper, and the button that derives them anew.
import { CheckView } from "./check_view.js";
import {
    builtCaption,
    builtReport,
    type Claim,
    ownCaption,
    type ReportOfChecker,
    showCounts,
} from "./claims.js";
import { byId } from "./elements.js";

const main = new Set([
    "label classes",
    "label classes, minimal",
    "label classes, not minimal",
    "terminal camera-minimal",
    "reduced minimal PL0Ps (no pins)",
    "five-point extensions, minimal",
]);
const isMain = (claim: Claim) => main.has(claim.claim);

const view = new CheckView();
byId("check", HTMLElement).append(view.element);
const button = byId("check-now", HTMLButtonElement);
button.addEventListener("click", async () => {
    button.disabled = true;
    const outcome = await view.run({
        options: ["--classification"],
        files: [{ name: "certs/classification.plc", address: "../certs/classification.plc" }],
    });
    if (outcome?.status === 0)
        showCounts(JSON.parse(outcome.report) as ReportOfChecker, ownCaption, isMain);
    button.disabled = false;
});

showCounts(await builtReport(), builtCaption, isMain);
