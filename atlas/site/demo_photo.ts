// A photo of the scene, whose points and lines the reader moves.
import { make } from "./elements.js";
import { HandleView, shape } from "./demo_handle.js";
import { photo, type Handle, type Pixel, type Scene } from "./demo_scene.js";

export class PhotoView {
    readonly element: HTMLElement;
    private readonly drawing = shape("svg", {
        class: "drawing photo",
        viewBox: `0 0 ${photo.width} ${photo.height}`,
        role: "group",
    });
    private readonly handles: { handle: Handle; view: HandleView; line?: SVGLineElement }[] = [];

    constructor(
        private readonly scene: Scene,
        view: number,
        changed: () => void,
    ) {
        const name = `Photo ${view + 1}`;
        this.drawing.setAttribute("aria-label", name);
        for (const handle of scene.handles(view)) {
            const isPoint = handle.line < 0;
            const what = isPoint ? "Point" : "Line through point";
            const shown = new HandleView(
                this.drawing,
                {
                    name: `${what} ${handle.feature + 1} in photo ${view + 1}`,
                    kind: isPoint ? "point" : "turn",
                    colour: handle.feature,
                    moveTo: (place) => {
                        scene.movePlace(handle, place);
                        changed();
                    },
                    moveBy: (step) => {
                        scene.movePlace(handle, this.stepped(handle, step));
                        changed();
                    },
                },
                isPoint ? String(handle.feature + 1) : "",
            );
            if (isPoint) {
                this.handles.push({ handle, view: shown });
            } else {
                const line = shape("line", { class: `seen-line colour-${handle.feature}` });
                this.handles.push({ handle, view: shown, line });
            }
        }
        this.drawing.append(
            ...this.handles.flatMap(({ line }) => (line ? [line] : [])),
            ...this.handles.map(({ view: shown }) => shown.element),
        );
        this.element = make("figure", {}, this.drawing, make("figcaption", {}, name));
        this.update();
    }

    update(): void {
        for (const { handle, view, line } of this.handles) {
            const place = this.scene.place(handle);
            view.update(place);
            if (!line) continue;
            const [x, y] = this.scene.place({ ...handle, line: -1 });
            const far = 12; // arms, to beyond the edge of the photo
            line.setAttribute("x1", (x - far * (place[0] - x)).toFixed(2));
            line.setAttribute("y1", (y - far * (place[1] - y)).toFixed(2));
            line.setAttribute("x2", (x + far * (place[0] - x)).toFixed(2));
            line.setAttribute("y2", (y + far * (place[1] - y)).toFixed(2));
        }
    }

    /** A point moves by the step; a line turns, whatever way it points. */
    private stepped(handle: Handle, step: Pixel): Pixel {
        const [x, y] = this.scene.place(handle);
        if (handle.line < 0) return [x + step[0], y + step[1]];
        const [a, b] = this.scene.place({ ...handle, line: -1 });
        const turn = (step[0] + step[1]) / 60;
        return [x - turn * (y - b), y + turn * (x - a)];
    }
}
