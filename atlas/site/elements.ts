// Making elements of a page. Text becomes text nodes and never HTML.

export type Child = Node | string;

type Attributes = Readonly<Record<string, string | boolean | (() => void)>>;

/** An element with attributes and children. A function is a listener of that event. */
export function make<Tag extends keyof HTMLElementTagNameMap>(
    tag: Tag,
    attributes: Attributes = {},
    ...children: Child[]
): HTMLElementTagNameMap[Tag] {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (typeof value === "function") element.addEventListener(name, value);
        else if (typeof value === "string") element.setAttribute(name, value);
        else if (value) element.setAttribute(name, "");
    }
    element.append(...children);
    return element;
}

/** The element with this id; it has to be there. */
export function byId<Kind extends HTMLElement>(id: string, kind: new () => Kind): Kind {
    const element = document.getElementById(id);
    if (!(element instanceof kind)) throw new Error(`the page has no ${kind.name} '${id}'`);
    return element;
}

/** Opens what the item with this id folds away, and shows it; false if there is no such item. */
export function openItem(id: string): boolean {
    const item = document.getElementById(id);
    item?.querySelector("details")?.setAttribute("open", "");
    item?.scrollIntoView();
    return item !== null;
}

/** 143494 as 143,494. */
export function withCommas(value: number): string {
    return value.toLocaleString("en-US");
}

/** 73479 as 73 kB. */
export function inKilobytes(bytes: number): string {
    return `${withCommas(Math.max(1, Math.round(bytes / 1000)))} kB`;
}

/** Waits until nothing was asked for a while: what is typed is answered once. */
export function afterPause(action: () => void, milliseconds = 150): () => void {
    let timer = 0;
    return () => {
        clearTimeout(timer);
        timer = setTimeout(action, milliseconds);
    };
}

/** Hands the reader a file. */
export function download(name: string, text: string): void {
    const address = URL.createObjectURL(new Blob([text], { type: "application/octet-stream" }));
    make("a", { href: address, download: name }).click();
    URL.revokeObjectURL(address);
}
