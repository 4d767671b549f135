// A table of contents for long pages, made of their headings.
import { make } from "./elements.js";

/** Links to the headings of the page's sections, at the place that the page has for them. */
export function showContents(): void {
    const place = document.querySelector<HTMLElement>("nav.contents");
    if (!place) return;
    const links = [...document.querySelectorAll<HTMLHeadingElement>("main h2[id]")].map((heading) =>
        make("li", {}, make("a", { href: `#${heading.id}` }, heading.textContent ?? "")),
    );
    place.replaceChildren(make("p", { class: "contents-title" }, "On this page"), make("ul", {}, ...links));
    place.hidden = links.length < 2;
}
