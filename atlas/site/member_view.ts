// A problem of a family in a list: name, notation, verdict, degree, and its certificate.
import { make, type Child } from "./elements.js";
import { certificateOf, type Family, type Member } from "./family.js";
import { degreeInWords, problemLink, statusMark } from "./problem_links.js";
import { recordView } from "./record_view.js";

/** What the address of a problem has after its `#`: the family, and its place in the list from 1. */
export function memberId(family: Family, index: number): string {
    return `${family}-${index + 1}`;
}

function degreeOf(member: Member): Child[] {
    if (member.degree === null) return [" · no degree on file"];
    return [` · degree ${degreeInWords(member.degree)} `, statusMark(member.degree.status)];
}

function groupOf({ group }: Member): Child[] {
    return group === null ? [] : [` · group ${group.name} `, statusMark(group.status)];
}

function factsOf(member: Member): HTMLElement {
    const facts = make("p", { class: "facts" }, `${member.views} views · `);
    if (member.minimal) facts.append("minimal", ...degreeOf(member), ...groupOf(member));
    else facts.append(`not minimal: ${member.reason}`);
    facts.append(" · ", problemLink(member.notation, `page of ${member.name}`));
    return facts;
}

/** Opens with the certificate, which is loaded when it is first wanted. */
function certificateDetails(family: Family, member: Member, id: string): HTMLElement {
    const details = make("details", {}, make("summary", {}, "certificate"));
    let asked = false;
    details.addEventListener("toggle", async () => {
        if (!details.open || asked) return;
        asked = true;
        try {
            const text = await certificateOf(family, member.notation);
            details.append(recordView({ text, problem: member.notation, minimal: member.minimal }, id));
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
