// The drawing board: three photos in which features are added, and hidden by clicking. The board keeps
// only what each view sees of each feature.
import { make } from "./elements.js";
import { photos } from "./photos.js";
import type { FeatureSights } from "./prover.js";
import type { Scene } from "./scene.js";

const viewCount = 3;
const mostPins = 26;

function letter(line: number): string {
    return String.fromCharCode("a".charCodeAt(0) + line);
}

/** `Pa/Pa/a`: what the views see, as the program reads it. */
export function notationOf(feature: FeatureSights): string {
    const symbols = feature.views.map(({ point, lines }) => {
        let symbol = point ? "P" : "";
        for (let line = 0; line < feature.lines; ++line)
            if (lines & (1 << line)) symbol += letter(line);
        return symbol === "" ? "-" : symbol;
    });
    const unseenPoint = feature.point && !feature.views.some((view) => view.point);
    const seen = feature.views.reduce((lines, view) => lines | view.lines, 0);
    let unseen = unseenPoint ? "P" : "";
    for (let line = 0; line < feature.lines; ++line)
        if (!(seen & (1 << line))) unseen += letter(line);
    return symbols.join("/") + (unseen === "" ? "" : `(${unseen})`);
}

function everywhere(point: boolean, lines: number): FeatureSights {
    const seen = { point, lines: (1 << lines) - 1 };
    return {
        point,
        lines,
        views: Array.from({ length: viewCount }, () => ({ ...seen })),
    };
}

export class Board {
    readonly element: HTMLElement;
    private features: FeatureSights[] = [];
    private readonly views = make("div", { class: "board-views" });
    private readonly table = make("table", { class: "board-table" });

    /** `changed` hears of each change, with the problem in notation. */
    constructor(private readonly changed: (notation: string) => void) {
        const add = (label: string, feature: () => FeatureSights) =>
            make("button", { type: "button", click: () => this.add(feature()) }, label);
        this.showNothing();
        this.element = make(
            "div",
            { class: "board" },
            this.views,
            make(
                "p",
                { class: "buttons" },
                add("Add a point", () => everywhere(true, 0)),
                add("Add a point with a pin", () => everywhere(true, 1)),
                add("Add a free line", () => everywhere(false, 1)),
                make("button", { type: "button", click: () => this.clear() }, "Clear"),
            ),
            make("div", { class: "scroll" }, this.table),
        );
    }

    /** Shows a problem that was decided elsewhere: its features, and its scene. */
    show(features: FeatureSights[], scene: Scene, problem: string): void {
        this.features = structuredClone(features);
        this.fillTable();
        const drawing = photos(scene, problem);
        this.views.replaceChildren(drawing);
        drawing.querySelectorAll("svg").forEach((photo, view) => this.makeClickable(photo, view));
    }

    showNothing(words = "Nothing is drawn yet. Add a point or a line."): void {
        this.features = [];
        this.fillTable();
        this.views.replaceChildren(make("p", { class: "empty" }, words));
    }

    /** Shows photos that cannot be changed here, and says why. */
    showOnly(drawing: HTMLElement, words: string): void {
        this.features = [];
        this.fillTable();
        this.views.replaceChildren(drawing, make("p", { class: "quiet" }, words));
    }

    private add(feature: FeatureSights): void {
        this.features.push(feature);
        this.tell();
    }

    private clear(): void {
        this.showNothing();
        this.tell();
    }

    private tell(): void {
        this.changed(this.features.map(notationOf).join(" + "));
    }

    /** Points and lines of a scene are in the order of the features. */
    private makeClickable(photo: SVGElement, view: number): void {
        let points = 0;
        let lines = 0;
        for (const feature of this.features) {
            for (let line = 0; line < feature.lines; ++line)
                this.listen(photo, `line[data-line="${lines++}"]`, () =>
                    this.toggleLine(feature, view, line),
                );
            if (feature.point)
                this.listen(photo, `circle[data-point="${points++}"]`, () =>
                    this.togglePoint(feature, view),
                );
        }
    }

    private listen(photo: SVGElement, selector: string, action: () => void): void {
        const shape = photo.querySelector<SVGElement>(selector);
        if (!shape) return;
        const target = shape.cloneNode() as SVGElement;
        target.setAttribute("class", "target");
        if (target.localName === "circle") target.setAttribute("r", "9");
        target.addEventListener("click", action);
        // Points over lines: who wants the point must not hit a line.
        if (target.localName === "circle") shape.parentElement?.append(target);
        else shape.parentElement?.querySelector("circle")?.before(target) ?? shape.after(target);
    }

    private togglePoint(feature: FeatureSights, view: number): void {
        const sight = feature.views[view];
        if (sight) sight.point = !sight.point;
        this.tell();
    }

    private toggleLine(feature: FeatureSights, view: number, line: number): void {
        const sight = feature.views[view];
        if (sight) sight.lines ^= 1 << line;
        this.tell();
    }

    private addPin(feature: FeatureSights): void {
        for (const sight of feature.views) sight.lines |= 1 << feature.lines;
        ++feature.lines;
        this.tell();
    }

    private remove(feature: FeatureSights): void {
        this.features = this.features.filter((other) => other !== feature);
        this.tell();
    }

    private fillTable(): void {
        const views = this.features[0]?.views.map((_, view) => `view ${view + 1}`) ?? [];
        const heads = ["feature", ...views].map((text) => make("th", { scope: "col" }, text));
        const focused = document.activeElement?.getAttribute("aria-label");
        const rows = this.features.map((feature, index) => this.row(feature, index));
        this.table.hidden = rows.length === 0;
        this.table.replaceChildren(
            make("caption", {}, "What each view sees. Press to hide or show."),
            make("thead", {}, make("tr", {}, ...heads, make("td"))),
            make("tbody", {}, ...rows),
        );
        if (focused) this.focus(focused);
    }

    /** Gives the focus back to the button that had it before the table was made anew. */
    private focus(label: string): void {
        for (const button of this.table.querySelectorAll("button"))
            if (button.getAttribute("aria-label") === label) button.focus();
    }

    private row(feature: FeatureSights, index: number): HTMLElement {
        const name = `feature ${index + 1}`;
        const cells = feature.views.map((sight, view) => {
            const cell = make("td");
            if (feature.point)
                cell.append(
                    this.toggle("P", sight.point, `point of ${name}, view ${view + 1}`, () =>
                        this.togglePoint(feature, view),
                    ),
                );
            for (let line = 0; line < feature.lines; ++line)
                cell.append(
                    this.toggle(
                        letter(line),
                        ((sight.lines >> line) & 1) === 1,
                        `line ${letter(line)} of ${name}, view ${view + 1}`,
                        () => this.toggleLine(feature, view, line),
                    ),
                );
            return cell;
        });
        const actions = make("td");
        if (feature.point && feature.lines < mostPins)
            actions.append(
                make(
                    "button",
                    {
                        type: "button",
                        click: () => this.addPin(feature),
                        "aria-label": `Add a pin to ${name}`,
                    },
                    "+ pin",
                ),
            );
        actions.append(
            make(
                "button",
                {
                    type: "button",
                    click: () => this.remove(feature),
                    "aria-label": `Remove ${name}`,
                },
                "remove",
            ),
        );
        return make(
            "tr",
            {},
            make("th", { scope: "row", class: "notation" }, notationOf(feature)),
            ...cells,
            actions,
        );
    }

    private toggle(text: string, on: boolean, label: string, action: () => void): HTMLElement {
        return make(
            "button",
            {
                type: "button",
                class: "toggle",
                "aria-pressed": String(on),
                "aria-label": label,
                click: action,
            },
            text,
        );
    }
}
