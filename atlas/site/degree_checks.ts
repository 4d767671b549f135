// The degree of a problem: on what it rests, and the button that checks what is certified.
import { CheckView } from "./check_view.js";
import { atlasFile } from "./checker.js";
import { make } from "./elements.js";
import { degreeView } from "./verdict_view.js";
import type { Degree, Report } from "./prover.js";

/** The classes whose solutions are on file, each in a file of its own. */
async function classesOnFile(): Promise<Set<number>> {
    const response = await fetch("certs/degrees/classes.json");
    return new Set((await response.json()) as number[]);
}

function meaning(degree: Degree): string {
    if (degree.status === "certified")
        return degree.bound === "exact"
            ? "Certificates show so many solutions, and an upper bound meets them."
            : "Certificates show at least so many solutions.";
    if (degree.status === "evidence")
        return "A computation suggests that no solution is missing. It can be wrong.";
    return "The authors of the paper say so.";
}

function checkOf(report: Report, degree: Degree): HTMLElement {
    const view = new CheckView();
    const exact = degree.bound === "exact";
    const file = `certs/degrees/${degree.number}.plc`;
    const names = exact ? ["certs/classification.plc", "certs/bounds.plc", file] : [file];
    const run = () =>
        view.run({
            options: [
                "--expect",
                report.class ?? report.problem,
                "--degree",
                exact ? String(degree.value) : `>=${degree.value}`,
            ],
            files: names.map(atlasFile),
        });
    return make(
        "div",
        {},
        make(
            "p",
            { class: "buttons" },
            make(
                "button",
                { type: "button", id: "check-degree", click: () => void run() },
                exact ? "Check the degree" : "Check the lower bound",
            ),
            make("a", { href: file, download: "" }, "the solutions on file"),
        ),
        view.element,
    );
}

/** Fills the section on the degree. */
export async function degreeChecks(report: Report, section: HTMLElement): Promise<void> {
    const degrees = report.degrees ?? [];
    if (!report.camera_minimal || degrees.length === 0) {
        section.append(
            make(
                "p",
                {},
                report.camera_minimal
                    ? "No degree is on file."
                    : "A problem that does not fix the cameras has no degree.",
            ),
        );
        return;
    }
    const items = degrees.map((degree) =>
        make("li", {}, degreeView(degree), ". ", meaning(degree)),
    );
    section.append(make("ul", { class: "plain" }, ...items));
    const onFile = await classesOnFile();
    const certified = degrees.find(
        (degree) => degree.status === "certified" && onFile.has(degree.number),
    );
    if (certified) section.append(checkOf(report, certified));
    else if (degrees.some((degree) => degree.status === "certified"))
        section.append(
            make(
                "p",
                {},
                "The atlas does not carry the certificates of this bound: " + "they are large. ",
                make("code", {}, `plprove degree ${report.number ?? ""} -o degree.plc`),
                " computes them again.",
            ),
        );
}
