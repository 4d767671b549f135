// The problems of a family (docs/notation.md, Families): what the program lists, and the records of
// the archive.
import type { GeneralDegree, Group } from "./prover.js";
import { textAt } from "./texts.js";

export const families = [
    "plmp",
    "projective",
    "shared-focal",
    "focal",
    "shared-focal-center",
    "shared-k",
    "upright",
    "upright-shared-focal",
    "upright-focal",
] as const;

export type Family = (typeof families)[number];

export function isFamily(name: string | undefined): name is Family {
    return families.some((family) => family === name);
}

/** A problem of the family, as atlas/families.py has it from the program. */
export interface Member {
    name: string;
    notation: string;
    views: number;
    minimal: boolean;
    /** Why it is not minimal. */
    reason: string;
    degree: Pick<GeneralDegree, "value" | "bound" | "status"> | null;
    group: Pick<Group, "name" | "status"> | null;
}

/** All balanced problems of the family, in the order of the archive. */
export async function membersOf(family: Family): Promise<Member[]> {
    return JSON.parse(await textAt(`data/${family}.json`)) as Member[];
}

/** The archive's record of a problem, after the lines that each file begins with: a file of its own
 * (certs/FORMAT.md, section 13). */
export async function certificateOf(family: Family, notation: string): Promise<string> {
    const archive = await textAt(`certs/${family}.plc`);
    const [head = "", ...records] = archive.split(/^(?=problem )/m);
    const record = records.find((text) => text.startsWith(`problem ${notation}\n`));
    if (record === undefined) throw new Error(`the archive has no record of ${notation}`);
    return head.replace(/^family .*\n/m, "") + record;
}
