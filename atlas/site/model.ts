// The models: problems that are given by equations (docs/models.md).
import { textAt } from "./texts.js";

/** A model, and what plcheck certified of it when the atlas was built (atlas/models.py). */
export interface Model {
    name: string;
    /** The first line of its comment. */
    title: string;
    /** The other lines: where the problem is from. */
    source: string;
    text: string;
    claimed: number | null;
    at_least: number | null;
    at_most: number | null;
}

/** All models, in the order of their names. */
export async function allModels(): Promise<Model[]> {
    return JSON.parse(await textAt("data/models.json")) as Model[];
}

/** Those that have all the words in their name, title or source. */
export function withWords(models: Model[], text: string): Model[] {
    const words = text.toLowerCase().split(/\s+/).filter(Boolean);
    return models.filter(({ name, title, source }) => {
        const all = `${name} ${title} ${source}`.toLowerCase();
        return words.every((word) => all.includes(word));
    });
}

/** `exactly 8 solutions`, `at least 28 solutions`. */
export function solutionsOf({ at_least, at_most }: Model): string {
    const count = at_least === at_most ? `exactly ${at_least}` : `at least ${at_least}`;
    return `${count} solution${at_least === 1 ? "" : "s"}`;
}
