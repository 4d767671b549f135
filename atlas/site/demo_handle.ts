// Things in a drawing that the reader moves, by mouse, finger or keyboard.
import type { Pixel } from "./demo_scene.js";

/** A shape of a drawing. */
export function shape<Tag extends keyof SVGElementTagNameMap>(
    tag: Tag,
    attributes: Readonly<Record<string, string | number>> = {},
    ...children: (Node | string)[]
): SVGElementTagNameMap[Tag] {
    const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes))
        element.setAttribute(name, String(value));
    element.append(...children);
    return element;
}

/** Where a pointer is, in the units of the drawing. */
export function placeIn(drawing: SVGSVGElement, event: PointerEvent): Pixel {
    const box = drawing.getBoundingClientRect();
    const { width, height } = drawing.viewBox.baseVal;
    return [
        ((event.clientX - box.left) * width) / box.width,
        ((event.clientY - box.top) * height) / box.height,
    ];
}

/** The step that an arrow key asks for, larger with Shift; nothing for other keys. */
export function stepOf(event: KeyboardEvent): Pixel | null {
    const size = event.shiftKey ? 10 : 2;
    switch (event.key) {
        case "ArrowLeft":
            return [-size, 0];
        case "ArrowRight":
            return [size, 0];
        case "ArrowUp":
            return [0, -size];
        case "ArrowDown":
            return [0, size];
    }
    return null;
}

export interface Movable {
    name: string;
    kind: "point" | "turn" | "camera";
    /** Which colour it has, and what its features have. */
    colour: number;
    /** To a place in the drawing. */
    moveTo: (place: Pixel) => void;
    moveBy: (step: Pixel) => void;
}

/** A handle in a drawing, which is in a place that update() says. */
export class HandleView {
    readonly element: SVGGElement;

    constructor(
        private readonly drawing: SVGSVGElement,
        private readonly movable: Movable,
        label: string,
    ) {
        const { name, kind, colour } = movable;
        const mark =
            kind === "turn"
                ? shape("rect", { x: -6, y: -6, width: 12, height: 12 })
                : shape("circle", { r: kind === "camera" ? 9 : 7 });
        this.element = shape(
            "g",
            {
                class: `handle ${kind} colour-${colour}`,
                tabindex: 0,
                role: "slider",
                "aria-label": name,
                "aria-valuenow": 0,
            },
            shape("circle", { class: "target", r: 26 }),
            mark,
            shape("text", { x: 11, y: -9 }, label),
        );
        this.element.addEventListener("pointerdown", (event) => this.grasp(event));
        this.element.addEventListener("keydown", (event) => {
            const step = stepOf(event);
            if (!step) return;
            event.preventDefault();
            event.stopPropagation();
            movable.moveBy(step);
        });
    }

    update([x, y]: Pixel, says = `${Math.round(x)} across, ${Math.round(y)} down`): void {
        this.element.setAttribute("transform", `translate(${x.toFixed(2)} ${y.toFixed(2)})`);
        this.element.setAttribute("aria-valuenow", String(Math.round(x)));
        this.element.setAttribute("aria-valuetext", says);
    }

    private grasp(event: PointerEvent): void {
        event.stopPropagation();
        event.preventDefault();
        this.element.focus({ preventScroll: true });
        this.element.setPointerCapture(event.pointerId);
        const move = (moved: PointerEvent) => this.movable.moveTo(placeIn(this.drawing, moved));
        const release = () => {
            this.element.removeEventListener("pointermove", move);
            this.element.removeEventListener("lostpointercapture", release);
        };
        this.element.addEventListener("pointermove", move);
        this.element.addEventListener("lostpointercapture", release);
    }
}
