// The families of problems that all views see whole: their counts, beside those of papers, and a list
// of all problems. The address has the filters, and after its # the problem whose certificate is
// open.
import { checkOnClick } from "./check_view.js";
import { atlasFile } from "./checker.js";
import { builtCaption, countsTable, ownCaption, type Claim } from "./claims.js";
import { byId, openItem, withCommas } from "./elements.js";
import { families, type Family, isFamily, type Member, membersOf } from "./family.js";
import { memberView } from "./member_view.js";

interface FamilyClaims {
    family: Family;
    claims: Claim[];
}

const form = byId("filters", HTMLFormElement);
const list = byId("problems", HTMLElement);
const total = byId("total", HTMLElement);

/** The part of a section with this class; it has to be there. */
function partOf<Kind extends HTMLElement>(section: HTMLElement, name: string, kind: new () => Kind) {
    const part = section.querySelector(`.${name}`);
    if (!(part instanceof kind)) throw new Error(`${section.id} has no ${kind.name} '${name}'`);
    return part;
}

function showClaims({ family, claims }: FamilyClaims, caption: string): void {
    const place = partOf(byId(family, HTMLElement), "counts", HTMLElement);
    place.replaceChildren(countsTable(claims, caption));
}

/** The button of a section replays the archive of its family. */
function connectCheck(family: Family): void {
    const section = byId(family, HTMLElement);
    checkOnClick(
        partOf(section, "check-now", HTMLButtonElement),
        partOf(section, "check-place", HTMLElement),
        { options: ["--family", family], files: [atlasFile(`certs/${family}.plc`)] },
        (report: { families: FamilyClaims[] }) => {
            for (const claims of report.families) showClaims(claims, ownCaption);
        },
    );
}

interface Filters {
    family: Family;
    views: string;
    verdict: string;
}

function filters(): Filters {
    const data = new FormData(form);
    const family = String(data.get("family"));
    return {
        family: isFamily(family) ? family : "plmp",
        views: String(data.get("views")),
        verdict: String(data.get("verdict")),
    };
}

function passes(member: Member, { views, verdict }: Filters): boolean {
    if (views !== "" && member.views !== Number(views)) return false;
    return verdict === "" || (verdict === "minimal") === member.minimal;
}

// What the reader asks now; files that come for earlier questions are dropped.
let current = 0;

async function showList(): Promise<void> {
    const question = ++current;
    const wanted = filters();
    try {
        const members = await membersOf(wanted.family);
        if (question !== current) return;
        const items = members.flatMap((member, index) =>
            passes(member, wanted) ? [memberView(wanted.family, member, index)] : [],
        );
        list.replaceChildren(...items);
        total.textContent = `${withCommas(items.length)} of ${withCommas(members.length)} problems`;
    } catch (error) {
        list.replaceChildren();
        total.textContent = `${String(error)}. Load the page again.`;
    }
}

function setFilters(value: (name: string, standard: string) => string): void {
    for (const control of form.elements)
        if (control instanceof HTMLSelectElement) {
            control.value = value(control.name, control.dataset.default ?? "");
            if (control.selectedIndex < 0) control.value = control.dataset.default ?? "";
        }
}

function keepInAddress(): void {
    const address = new URLSearchParams();
    for (const control of form.elements)
        if (control instanceof HTMLSelectElement && control.value !== control.dataset.default)
            address.set(control.name, control.value);
    const query = address.toString();
    history.replaceState(null, "", query === "" ? location.pathname : `?${query}`);
}

/** Opens the certificate of the problem that the address names. If the filters hide the problem,
 * they go. */
async function openNamed(): Promise<void> {
    const id = location.hash.slice(1);
    const family = id.replace(/-\d+$/, "");
    if (!isFamily(family) || id === family) return;
    if (!document.getElementById(id)) {
        setFilters((name, standard) => (name === "family" ? family : standard));
        await showList();
    }
    if (!openItem(id)) total.textContent += `; none of them is ${id}`;
}

for (const family of families) connectCheck(family);
form.addEventListener("submit", (event) => event.preventDefault());
form.addEventListener("input", () => {
    keepInAddress();
    void showList();
});
window.addEventListener("hashchange", () => void openNamed());

const address = new URLSearchParams(location.search);
setFilters((name, standard) => address.get(name) ?? standard);
const built = (await (await fetch("data/families.json")).json()) as FamilyClaims[];
for (const claims of built) showClaims(claims, builtCaption);
await showList();
await openNamed();
