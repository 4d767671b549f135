// The start page: a problem in space, famous problems, the main counts of the paper, and the button that
// derives them anew.
import { checkOnClick } from "./check_view.js";
import { atlasFile } from "./checker.js";
import { builtCaption, builtReport, countsTable, ownCaption, type ReportOfChecker } from "./claims.js";
import { byId } from "./elements.js";
import { famous, famousCard, sceneOf } from "./famous.js";
import { photos } from "./photos.js";
import { sketch } from "./sketch.js";

const question = "2*P/P/P + a/Pa/Pa + a/a/a";
byId("question", HTMLElement).replaceChildren(photos(sceneOf(question), question));
byId("space", HTMLElement).replaceChildren(sketch(sceneOf(question)));
byId("famous-list", HTMLElement).replaceChildren(...famous.map(famousCard));

const main = new Set([
    "label classes",
    "label classes, minimal",
    "label classes, not minimal",
    "terminal camera-minimal",
    "reduced minimal PL0Ps (no pins)",
    "five-point extensions, minimal",
]);

function showCounts(report: ReportOfChecker, caption: string): void {
    const claims = report.claims.filter(({ claim }) => main.has(claim));
    byId("counts", HTMLElement).replaceChildren(countsTable(claims, caption));
}

checkOnClick(
    byId("check-now", HTMLButtonElement),
    byId("check", HTMLElement),
    { options: ["--classification"], files: [atlasFile("certs/classification.plc")] },
    (report: ReportOfChecker) => showCounts(report, ownCaption),
);

showCounts(await builtReport(), builtCaption);
