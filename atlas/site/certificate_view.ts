// A certificate for people: each number that stands in it, and the matrix that follows from them.
import { make, type Child } from "./elements.js";
import type { CertificateAnswer, Evidence } from "./prover.js";

const cameraColumns = ["rotation of camera 2", "translation of camera 2", "rotation of camera 3",
    "translation of camera 3"];

function vector(numbers: number[]): string {
    return `(${numbers.join(", ")})`;
}

function table(caption: string, heads: string[], rows: Child[][]): HTMLElement {
    const head = make("tr", {}, ...heads.map((text) => make("th", { scope: "col" }, text)));
    const body = rows.map((row) => make("tr", {}, ...row.map((cell) => make("td", {}, cell))));
    return make("div", { class: "scroll" },
        make("table", {}, make("caption", {}, caption), make("thead", {}, head),
            make("tbody", {}, ...body)));
}

function cameras(answer: CertificateAnswer): HTMLElement {
    const rows = answer.cameras.map(({ quaternion, translation }, index) =>
        [`camera ${index + 2}`, vector(quaternion), vector(translation)]);
    return table("The cameras: the first is [I | 0]. A quaternion stands for a rotation, up to a factor.",
        ["camera", "quaternion", "translation"], rows);
}

function features(answer: CertificateAnswer): HTMLElement {
    const rows = answer.features.map(({ feature, point, directions }) => [
        make("span", { class: "notation" }, feature),
        vector(point),
        directions.map(vector).join(" "),
    ]);
    return table("The features in space: a point, and the directions of its pins. Of a free line, a point on it and its direction.",
        ["feature", "point", "directions"], rows);
}

/** How large an entry is, as one of five shades. */
function shade(entry: string): string {
    if (entry === "0") return "zero";
    const digits = entry.replace("-", "").length;
    return `${entry.startsWith("-") ? "minus" : "plus"}-${Math.min(4, digits)}`;
}

/** The Jacobian: unknowns of the features on the left, block by block, of the cameras right. */
export function jacobian(answer: CertificateAnswer): HTMLElement {
    const own = answer.jacobian.reduce((sum, block) => sum + block.own, 0);
    const cameraCount = answer.jacobian[0]?.cameras ?? 0;
    const deletedColumns = new Set(answer.evidence.deleted_columns ?? []);
    const deletedRows = new Set(answer.evidence.deleted_rows ?? []);
    const ofCameras = answer.evidence.kind === "deficient" ? own : 0;
    const matrix = make("table", { class: "matrix" });
    let before = 0;
    let number = 0;
    answer.jacobian.forEach((block, index) => {
        for (const row of block.rows) {
            ++number;
            const cells = [
                ...Array<string>(before).fill("0"),
                ...row.slice(0, block.own),
                ...Array<string>(own - before - block.own).fill("0"),
                ...row.slice(block.own),
            ];
            const line = make("tr", {}, ...cells.map((entry, column) => make("td", {
                class: [shade(entry),
                    column === own ? "first-camera" : "",
                    deletedRows.has(number) || deletedColumns.has(column + 1 - ofCameras) ? "deleted" : "",
                ].join(" ").trim(),
                title: `row ${number}, column ${column + 1}`,
            }, entry)));
            if (row === block.rows[0] && index > 0) line.classList.add("first-row");
            matrix.append(line);
        }
        before += block.own;
    });
    const rows = number;
    return make("figure", { class: "jacobian" },
        make("div", { class: "scroll", tabindex: "0", role: "group", "aria-label": "The Jacobian" }, matrix),
        make("figcaption", {},
            `The Jacobian of the problem at this scene: ${rows} rows, one for each condition on an ` +
            `image, and ${own + cameraCount} columns: ${own} unknowns of the features, then ` +
            `${cameraCount} of the cameras (${cameraColumns.slice(0, cameraCount > 5 ? 4 : 2).join(", ")}; ` +
            "the scale is fixed). Blue is positive, red negative, darker is larger" +
            (deletedColumns.size + deletedRows.size > 0 ? "; struck rows and columns are deleted." : ".")));
}

function conclusion(evidence: Evidence, modulus: string): Child[] {
    const minor = make("code", {}, evidence.minor ?? "");
    const prime = make("span", {}, "q = 2", make("sup", {}, "61"), ` − 1 = ${modulus}`);
    if (evidence.kind === "minimal")
        return ["The determinant of this matrix is ", minor, " modulo the prime ", prime,
            ". So it is not 0, the images determine the cameras near this scene up to finitely many " +
            "choices, and the same holds for generic images: the problem is minimal."];
    if (evidence.kind === "camera-minimal")
        return ["Without the struck columns, all of them unknowns of the scene, the determinant is ",
            minor, " modulo the prime ", prime, ". So generic images fix the cameras up to finitely " +
            "many choices, and leave some of the scene open."];
    return ["Without the struck rows and columns the determinant is ", minor, " modulo the prime ",
        prime, ". So the rank is no smaller. It is no larger, either: these motions of the cameras " +
        "keep every image, to first order, if the features move along: ",
        ...(evidence.kernel ?? []).map((entries) => make("code", { class: "kernel" }, `(${entries.join(", ")})`)),
        ". proofs/classification.md shows that this is so at every scene."];
}

/** The certificate with each number explained, and its text. */
export function certificateView(answer: CertificateAnswer): HTMLElement {
    const text = make("details", {},
        make("summary", {}, "The certificate as text"),
        make("pre", { class: "output", tabindex: "0", "aria-label": "The certificate" }, answer.text));
    if (answer.evidence.kind === "dimension count")
        return make("div", {},
            make("p", {}, "Counting is enough: the images put too few or too many constraints on the " +
                "cameras. The certificate lists how the problem reduces, and the count."), text);
    return make("div", {},
        make("p", {}, "The certificate names one scene and its cameras, in small integers:"),
        cameras(answer),
        features(answer),
        jacobian(answer),
        make("p", {}, ...conclusion(answer.evidence, answer.modulus)),
        text);
}
