// A button that runs plcheck, and what plcheck says, in its own words.
import { check, commandLine, type CheckRequest, type Outcome } from "./checker.js";
import { make } from "./elements.js";

export class CheckView {
    readonly element: HTMLElement;
    private readonly command = make("code", { class: "command" });
    private readonly state = make("p", { class: "state", role: "status" });
    private readonly bar = make("progress", { hidden: true, "aria-label": "Replaying" });
    private readonly output = make("pre", { class: "output", hidden: true, tabindex: "0" });

    constructor() {
        this.output.setAttribute("aria-label", "What plcheck prints");
        this.element = make(
            "div",
            { class: "check" },
            make("p", {}, this.command),
            this.bar,
            this.state,
            this.output,
        );
    }

    /** Runs the checker on the files, shows what it says, and returns it; null if it cannot run. */
    async run(request: CheckRequest): Promise<Outcome | null> {
        const start = performance.now();
        const seconds = () => ((performance.now() - start) / 1000).toFixed(1);
        this.command.textContent = `$ ${commandLine(request)}`;
        this.output.hidden = true;
        this.bar.hidden = false;
        this.state.className = "state";
        try {
            const outcome = await check(request, (words) => {
                this.state.textContent = `${words} …`;
            });
            this.show(outcome, seconds());
            return outcome;
        } catch (error) {
            this.state.className = "state refused";
            this.state.textContent =
                `The checker could not run: ${String(error)}. ` + "Load the page again.";
            return null;
        } finally {
            this.bar.hidden = true;
        }
    }

    private show(outcome: Outcome, seconds: string): void {
        const verified = outcome.status === 0;
        const word = verified ? "VERIFIED" : "NOT VERIFIED";
        this.state.className = verified ? "state verified" : "state refused";
        this.state.textContent =
            `${word} in this browser, in ${seconds} s ` + `(exit status ${outcome.status})`;
        this.output.textContent = outcome.errors + outcome.output;
        this.output.hidden = false;
    }
}
