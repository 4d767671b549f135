// On what a degree rests, in words for readers who know none of the programs' terms.
import { withCommas } from "./elements.js";
import type { GeneralDegree } from "./prover.js";

/** What certs/family-degrees.csv says in its column `source`, part by part. */
const parts: readonly [RegExp, (match: RegExpExecArray) => string][] = [
    [/^by theorem( and certificates)?$/, ([, more]) => `a theorem gives it${more ?? ""}`],
    [/^by its label class$/, () => "the theorem for three calibrated views gives it"],
    [/^by certificates$/, () => "certificates bound it from below and from above"],
    [/^that of (.*)$/, ([, problem]) => `it is that of ${problem}`],
    [
        /^two seeds gave (\d+)$/,
        ([, number]) => `two independent runs both found ${withCommas(Number(number))} solutions`,
    ],
    [
        /^(\d+) of (\d+) ways agree$/,
        ([, agree, all]) =>
            agree === "0"
                ? `the check that follows all solutions from some photos to others was tried ${all} ` +
                  "times, and each time lost some of them on the way"
                : `following all solutions from some photos to others kept every one of them, in ` +
                  `${agree} of ${all} tries`,
    ],
    [
        /^by Groebner bases for its constraint class$/,
        () => "Gröbner bases count so many for random photos modulo a prime",
    ],
    [
        /^by paths for its constraint class$/,
        () => "two independent runs that follow solutions from photos to photos both found so many",
    ],
    [/^a trace test$/, () => "another test, of a sum over all solutions, says that none is missing"],
];

function partInWords(part: string): string {
    for (const [pattern, words] of parts) {
        const match = pattern.exec(part);
        if (match) return words(match);
    }
    return part;
}

/** The source as a sentence; of a degree that is only evidence, also how much is certified. */
export function sourceInWords({ source, status, value, certified_at_least }: GeneralDegree): string {
    const words = source.split("; ").map(partInWords).join("; ");
    const sentence = `${words.charAt(0).toUpperCase()}${words.slice(1)}.`;
    if (status === "certified") return sentence;
    const least = certified_at_least ?? 0;
    if (least === 0) return `${sentence} Nobody has proved it yet.`;
    const proved =
        least === value
            ? "Certified is that there are at least so many; that there are no more is not proved."
            : `Certified are at least ${withCommas(least)}; that there are just ` +
              `${withCommas(value)} is not proved.`;
    return `${sentence} ${proved}`;
}
