// Shows the pictures that the program draws. What it wrote is parsed, and only the shapes and
// attributes below are taken over: a picture can hold no script and load nothing.

const namespace = "http://www.w3.org/2000/svg";

const shapes: Readonly<Record<string, readonly string[]>> = {
    svg: ["viewBox", "width", "height"],
    title: [],
    desc: [],
    g: ["transform", "font-family", "font-size", "stroke-linecap"],
    rect: ["width", "height", "fill", "stroke", "stroke-width"],
    line: ["class", "x1", "y1", "x2", "y2", "stroke-width"],
    circle: ["class", "cx", "cy", "r"],
    text: ["class", "x", "y", "text-anchor", "font-size"],
};

function take(source: Element): SVGElement | null {
    const allowed = shapes[source.localName];
    if (!allowed) return null;
    const copy = document.createElementNS(namespace, source.localName);
    for (const name of allowed) {
        const value = source.getAttribute(name);
        if (value !== null) copy.setAttribute(name, value);
    }
    for (const child of source.childNodes) {
        if (child instanceof Element) {
            const taken = take(child);
            if (taken) copy.append(taken);
        } else if (child.nodeType === Node.TEXT_NODE && child.textContent?.trim()) {
            copy.append(child.textContent);
        }
    }
    return copy;
}

/** The picture, without its caption, which a page has as text. */
export function picture(svg: string): SVGElement {
    // The page's style is its own; a browser would complain of the background in the picture's.
    const plain = svg.replace(/ style="[^"]*"/, "");
    const parsed = new DOMParser().parseFromString(plain, "image/svg+xml");
    const copy = take(parsed.documentElement);
    if (!copy) throw new Error("this is no picture");
    const title = copy.querySelector("title")?.textContent ?? "";
    copy.setAttribute("class", "picture");
    copy.setAttribute("role", "img");
    copy.setAttribute("aria-label", `Picture of ${title}`);
    leaveCaptionOut(copy);
    return copy;
}

/** The caption is the last group; the picture ends below its panels. */
function leaveCaptionOut(copy: SVGElement): void {
    copy.querySelector("desc")?.remove();
    copy.querySelector("title")?.remove();
    copy.querySelector(":scope > g:last-of-type")?.remove();
    const frame = copy.querySelector("rect");
    const [x, y, width] = (copy.getAttribute("viewBox") ?? "").split(" ");
    const height = 22 + Number(frame?.getAttribute("height")) + 4;
    copy.setAttribute("viewBox", `${x} ${y} ${width} ${height}`);
    copy.setAttribute("height", String(height));
}

/** The panels of a picture, one for each view: the shapes in them, in the program's order. */
export function panelsOf(drawing: SVGElement): SVGElement[][] {
    const panels = drawing.querySelectorAll<SVGElement>(":scope > g > g > g");
    return [...panels].map((panel) => [...panel.querySelectorAll<SVGElement>("line, circle")]);
}
