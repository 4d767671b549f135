// The degree of a problem: on what it rests, and the button that checks it.
import { CheckView } from "./check_view.js";
import { atlasFile } from "./checker.js";
import { make, withCommas } from "./elements.js";
import { degreeView } from "./verdict_view.js";
import type { Degree, Report } from "./prover.js";

/** The constraint classes whose solutions are on file, each in a file of its own. */
async function classesOnFile(): Promise<Set<number>> {
    const response = await fetch("certs/degrees/classes.json");
    return new Set((await response.json()) as number[]);
}

/** A button that has the checker certify the degree, and what it says. `file` has the solutions. */
function checkOf(report: Report, degree: Degree, file: string): HTMLElement {
    const view = new CheckView();
    const names = ["certs/classification.plc", file];
    const run = () =>
        view.run({
            options: [
                "--expect",
                report.class ?? report.problem,
                "--degree",
                String(degree.value),
            ],
            files: names.map(atlasFile),
        });
    const button = make(
        "button",
        { type: "button", id: "check-degree", click: () => void run() },
        "Check the degree",
    );
    const solutions = make("a", { href: file, download: "" }, "the solutions on file");
    return make("div", {}, make("p", { class: "buttons" }, button, solutions), view.element);
}

/** Fills the section on the degree. */
export async function degreeChecks(report: Report, section: HTMLElement): Promise<void> {
    const degree = report.degree;
    if (!degree) {
        const words = "A problem that does not fix the cameras has no degree.";
        section.append(make("p", {}, words));
        return;
    }
    const meaning =
        `. For generic photos there are ${withCommas(degree.value)} solutions, counted over the ` +
        "complex numbers. A solver finds all of them, and then the one that fits: so the degree " +
        "says how hard the problem is.";
    section.append(make("p", {}, degreeView(degree), meaning));
    const number = report.constraint_class;
    if (number === undefined) return;
    if ((await classesOnFile()).has(number)) {
        section.append(checkOf(report, degree, `certs/degrees/${number}.plc`));
        return;
    }
    const command = make("code", {}, `plprove degree ${report.number ?? ""} -o degree.plc`);
    const large =
        "A theorem gives this number, and plcheck computes it. The solutions themselves are large, " +
        "and not in the atlas: ";
    section.append(make("p", {}, large, command, " finds them again."));
}
