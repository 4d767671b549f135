// Runs of plcheck on a page, and what plcheck says, in its own words.
import { check, commandLine, type CheckRequest, type Outcome } from "./checker.js";
import { make } from "./elements.js";

/**
 * Lets a button check the files of a request: the view of that run appears in `place`. If they
 * hold, `show` gets the report. While the checker runs, the button is off.
 */
export function checkOnClick<Report>(
    button: HTMLButtonElement,
    place: HTMLElement,
    request: CheckRequest,
    show: (report: Report) => void,
): void {
    const view = new CheckView();
    place.append(view.element);
    button.addEventListener("click", async () => {
        button.disabled = true;
        const outcome = await view.run(request);
        if (outcome?.status === 0) show(JSON.parse(outcome.report) as Report);
        button.disabled = false;
    });
}

/** What plcheck is asked, how far it is, and what it says. */
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
        this.state.textContent = "Starting …";
        this.comeIntoSight();
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

    /** What the checker says is read where the reader is: the page moves no further than needed. */
    private comeIntoSight(): void {
        this.element.scrollIntoView({ block: "nearest" });
    }

    private show(outcome: Outcome, seconds: string): void {
        const verified = outcome.status === 0;
        const word = verified ? "VERIFIED" : "NOT VERIFIED";
        this.state.className = verified ? "state verified" : "state refused";
        this.state.textContent =
            `${word} in this browser, in ${seconds} s ` + `(exit status ${outcome.status})`;
        this.output.textContent = outcome.errors + outcome.output;
        this.output.hidden = false;
        this.bar.hidden = true;
        this.comeIntoSight();
    }
}
