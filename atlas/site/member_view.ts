// A problem of a family in a list: name, notation, verdict, degree, and its certificate.
import { CheckView } from "./check_view.js";
import { make, type Child } from "./elements.js";
import { certificateOf, type Family, type Member } from "./family.js";
import { degreeInWords, problemLink, statusMark } from "./problem_links.js";

/** What the address of a problem has after its `#`: the family, and its place in the list from 1. */
export function memberId(family: Family, index: number): string {
    return `${family}-${index + 1}`;
}

function degreeOf(member: Member): Child[] {
    if (member.degree === null) return [" · no degree on file"];
    return [` · degree ${degreeInWords(member.degree)} `, statusMark(member.degree.status)];
}

function factsOf(member: Member): HTMLElement {
    const facts = make("p", { class: "facts" }, `${member.views} views · `);
    if (member.minimal) facts.append("minimal", ...degreeOf(member));
    else facts.append(`not minimal: ${member.reason}`);
    if (member.page) facts.append(" · ", problemLink(member.notation, `page of ${member.name}`));
    return facts;
}

/** The certificate as a file of its own, and a button that checks it. */
async function certificateView(family: Family, member: Member, id: string): Promise<HTMLElement> {
    const text = await certificateOf(family, member.notation);
    const view = new CheckView();
    const verdict = member.minimal ? "minimal" : "not-minimal";
    const check = () =>
        void view.run({
            options: ["--expect", member.notation, "--verdict", verdict],
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

/** Opens with the certificate, which is loaded when it is first wanted. */
function certificateDetails(family: Family, member: Member, id: string): HTMLElement {
    const details = make("details", {}, make("summary", {}, "certificate"));
    let asked = false;
    details.addEventListener("toggle", async () => {
        if (!details.open || asked) return;
        asked = true;
        try {
            details.append(await certificateView(family, member, id));
        } catch (error) {
            const words = `${String(error)}. Load the page again.`;
            details.append(make("p", { class: "complaint" }, words));
        }
    });
    return details;
}

/** The problem with its place in the list, from 0. */
export function memberView(family: Family, member: Member, index: number): HTMLElement {
    const id = memberId(family, index);
    const link = make("a", { href: `#${id}`, class: "card-number" }, `${index + 1} · ${member.name}`);
    return make(
        "li",
        { id, class: "card" },
        make("p", { class: "member" }, link, make("span", { class: "notation" }, member.notation)),
        factsOf(member),
        certificateDetails(family, member, id),
    );
}
