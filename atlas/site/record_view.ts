// The certificate of a problem in general, to read and to check.
import { CheckView } from "./check_view.js";
import { make } from "./elements.js";

/** A certificate as a file of its own, and what it has to prove. */
export interface ProblemRecord {
    text: string;
    problem: string;
    minimal: boolean;
}

/** The file as it is, and a button that checks it; `id` names the file. */
export function recordView({ text, problem, minimal }: ProblemRecord, id: string): HTMLElement {
    const view = new CheckView();
    const verdict = minimal ? "minimal" : "not-minimal";
    const check = () =>
        void view.run({
            options: ["--expect", problem, "--verdict", verdict],
            files: [{ name: `${id}.plc`, bytes: new TextEncoder().encode(text).buffer }],
        });
    const label = `Certificate of problem ${id}`;
    return make(
        "div",
        {},
        make("pre", { class: "output record", tabindex: "0", "aria-label": label }, text),
        make(
            "p",
            { class: "buttons" },
            make("button", { type: "button", click: check }, "Check this certificate"),
            make("a", { href: "certs/FORMAT.md" }, "what its lines mean (section 13)"),
        ),
        view.element,
    );
}
