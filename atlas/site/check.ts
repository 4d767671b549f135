// The reader's own files, checked in the browser. They do not leave it.
import { CheckView } from "./check_view.js";
import { atlasFile, type CheckFile } from "./checker.js";
import { byId, inKilobytes, make } from "./elements.js";

const view = new CheckView();
byId("check", HTMLElement).append(view.element);
const input = byId("files", HTMLInputElement);
const form = byId("options", HTMLFormElement);
const drop = byId("drop", HTMLElement);
const chosen = byId("chosen", HTMLElement);
let files: File[] = [];

function choose(list: FileList | null | undefined): void {
    files = [...(list ?? [])];
    chosen.replaceChildren(
        ...files.map((file) => make("li", {}, `${file.name}, ${inKilobytes(file.size)}`)),
    );
    if (files.length > 0) form.requestSubmit();
}

function options(): string[] {
    const data = new FormData(form);
    const words: string[] = [];
    for (const name of ["expect", "verdict", "degree"]) {
        const value = String(data.get(name) ?? "").trim();
        if (value !== "") words.push(`--${name}`, value);
    }
    if (data.has("why")) words.push("--why");
    if (data.has("table")) words.push("--table");
    return words;
}

form.addEventListener("submit", async (event) => {
    event.preventDefault();
    if (files.length === 0) {
        chosen.replaceChildren(make("li", { class: "complaint", role: "alert" }, "Choose a file first."));
        return;
    }
    const own: CheckFile[] = [];
    for (const file of files) own.push({ name: file.name, bytes: await file.arrayBuffer() });
    const helped = new FormData(form).has("archive")
        ? [atlasFile("certs/classification.plc")]
        : [];
    await view.run({ options: options(), files: [...helped, ...own] });
});

input.addEventListener("change", () => choose(input.files));
drop.addEventListener("dragover", (event) => {
    event.preventDefault();
    drop.classList.add("over");
});
drop.addEventListener("dragleave", () => drop.classList.remove("over"));
drop.addEventListener("drop", (event) => {
    event.preventDefault();
    drop.classList.remove("over");
    choose(event.dataTransfer?.files);
});
