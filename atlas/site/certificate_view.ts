// A certificate for people: each number that stands in it, and the matrix that follows from them.
import { make, type Child } from "./elements.js";
import type { CertificateAnswer, Proof } from "./prover.js";

function vector(numbers: number[]): string {
    return `(${numbers.join(", ")})`;
}

function table(caption: string, heads: string[], rows: Child[][]): HTMLElement {
    const head = make("tr", {}, ...heads.map((text) => make("th", { scope: "col" }, text)));
    const body = rows.map((row) => make("tr", {}, ...row.map((cell) => make("td", {}, cell))));
    return make(
        "div",
        { class: "scroll" },
        make(
            "table",
            {},
            make("caption", {}, caption),
            make("thead", {}, head),
            make("tbody", {}, ...body),
        ),
    );
}

function cameras(answer: CertificateAnswer): HTMLElement {
    const rows = answer.cameras.map(({ quaternion, translation }, index) => [
        `camera ${index + 2}`,
        vector(quaternion),
        vector(translation),
    ]);
    return table(
        "The cameras: the first is [I | 0]. A quaternion stands for a rotation, up to a factor.",
        ["camera", "quaternion", "translation"],
        rows,
    );
}

function features(answer: CertificateAnswer): HTMLElement {
    const rows = answer.features.map(({ feature, point, directions }) => [
        make("span", { class: "notation" }, feature),
        vector(point),
        directions.map(vector).join(" "),
    ]);
    return table(
        "The features in space: a point, and the directions of its pins. Of a free line, a point " +
            "on it and its direction.",
        ["feature", "point", "directions"],
        rows,
    );
}

/** How large an entry is, as one of five shades. */
function shade(entry: string): string {
    if (entry === "0") return "zero";
    const digits = entry.replace("-", "").length;
    return `${entry.startsWith("-") ? "minus" : "plus"}-${Math.min(4, digits)}`;
}

/** The rows of the Jacobian: the unknowns of all features, block by block, then the cameras'. */
function rowsOf(answer: CertificateAnswer): { entries: string[]; first: boolean }[] {
    const own = answer.jacobian.reduce((sum, block) => sum + block.own, 0);
    const zeros = (count: number) => Array<string>(count).fill("0");
    let before = 0;
    return answer.jacobian.flatMap((block) => {
        const after = own - before - block.own;
        const rows = block.rows.map((row, index) => ({
            entries: [
                ...zeros(before),
                ...row.slice(0, block.own),
                ...zeros(after),
                ...row.slice(block.own),
            ],
            first: index === 0,
        }));
        before += block.own;
        return rows;
    });
}

/** Whether the certificate leaves out a row, or a column, both counted from 1. */
function deletions(proof: Proof, own: number): (row: number, column: number) => boolean {
    const rows = new Set(proof.deleted_rows ?? []);
    // Of an obstructed problem the columns are counted among those of the cameras.
    const offset = proof.kind === "deficient" ? own : 0;
    const columns = new Set((proof.deleted_columns ?? []).map((column) => column + offset));
    return (row, column) => rows.has(row) || columns.has(column);
}

/** The Jacobian as a coloured table. */
export function jacobian(answer: CertificateAnswer): HTMLElement {
    const own = answer.jacobian.reduce((sum, block) => sum + block.own, 0);
    const cameras = answer.jacobian[0]?.cameras ?? 0;
    const isDeleted = deletions(answer.proof, own);
    const rows = rowsOf(answer);
    const lines = rows.map(({ entries, first }, row) => {
        const cells = entries.map((entry, column) => {
            const classes = [shade(entry)];
            if (column === own) classes.push("first-camera");
            if (isDeleted(row + 1, column + 1)) classes.push("deleted");
            const title = `row ${row + 1}, column ${column + 1}`;
            return make("td", { class: classes.join(" "), title }, entry);
        });
        return make("tr", { class: first && row > 0 ? "first-row" : "" }, ...cells);
    });
    const matrix = make("table", { class: "matrix" }, make("tbody", {}, ...lines));
    const frame = { class: "scroll", tabindex: "0", role: "group", "aria-label": "The Jacobian" };
    const deleted = answer.proof.deleted_columns
        ? " The struck rows and columns are deleted."
        : "";
    return make(
        "figure",
        { class: "jacobian" },
        make("div", frame, matrix),
        make(
            "figcaption",
            {},
            `The Jacobian of the problem at this scene. It has ${rows.length} rows, one for each ` +
                `condition on an image. Of its ${own + cameras} columns, ${own} belong to the ` +
                `features and the last ${cameras} to the cameras (${columnsOf(cameras)}). ` +
                `Blue is positive, red negative, darker is larger.${deleted}`,
        ),
    );
}

/** What the columns of the cameras are: six for each but the first, less one for the scale. */
function columnsOf(cameras: number): string {
    const all = ["rotation of camera 2", "translation of camera 2"];
    if (cameras > 5) all.push("rotation of camera 3", "translation of camera 3");
    return `${all.join(", ")}, less one for the scale`;
}

function conclusion(proof: Proof, modulus: string): Child[] {
    const minor = make("code", {}, proof.minor ?? "");
    const prime = make("span", {}, "q = 2", make("sup", {}, "61"), ` − 1 = ${modulus}`);
    if (proof.kind === "minimal")
        return [
            "The determinant of this matrix is ",
            minor,
            " modulo the prime ",
            prime,
            ". So it is not 0. The images determine the cameras near this scene up to finitely " +
                "many choices. The same holds for generic images: the problem is minimal.",
        ];
    if (proof.kind === "camera-minimal")
        return [
            "Without the struck columns, all of them unknowns of the scene, the determinant is ",
            minor,
            " modulo the prime ",
            prime,
            ". So generic images fix the cameras up to finitely " +
                "many choices, and leave some of the scene open.",
        ];
    return [
        "Without the struck rows and columns the determinant is ",
        minor,
        " modulo the prime ",
        prime,
        ". So the rank is no smaller. It is no larger, either: these motions of the cameras " +
            "keep every image, to first order, if the features move along: ",
        ...(proof.kernel ?? []).map((entries) =>
            make("code", { class: "kernel" }, `(${entries.join(", ")})`),
        ),
        ". proofs/classification.md shows that this is so at every scene.",
    ];
}

/** The certificate with each number explained, and its text. */
export function certificateView(answer: CertificateAnswer): HTMLElement {
    const text = make(
        "details",
        {},
        make("summary", {}, "The certificate as text"),
        make(
            "pre",
            { class: "output", tabindex: "0", "aria-label": "The certificate" },
            answer.text,
        ),
    );
    if (answer.proof.kind === "dimension count")
        return make(
            "div",
            {},
            make(
                "p",
                {},
                "Counting is enough: the images put too few or too many constraints on the " +
                    "cameras. The certificate lists how the problem reduces, and the count.",
            ),
            text,
        );
    return make(
        "div",
        {},
        make("p", {}, "The certificate names one scene and its cameras, in small integers:"),
        cameras(answer),
        features(answer),
        jacobian(answer),
        make("p", {}, ...conclusion(answer.proof, answer.modulus)),
        text,
    );
}
