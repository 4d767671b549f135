// Problems that have a name, for the gallery of the start page. It does not load the prover: so each
// problem stands here with what views see of its features, and the tests compare with the prover.
import { make, withCommas } from "./elements.js";
import { photos } from "./photos.js";
import { problemAddress } from "./problem_links.js";
import type { Scene } from "./scene.js";

export interface Famous {
    name: string;
    /** As the prover reads it. */
    problem: string;
    words: string;
    degree: number;
}

export const famous: readonly Famous[] = [
    {
        name: "Five points",
        problem: "5*P/P",
        words: "The workhorse: how two calibrated photos lie to each other, from five points.",
        degree: 20,
    },
    {
        name: "Chicago",
        problem: "2*Pa/Pa/Pa + P/P/P",
        words: "Three points, two of them with a line, in three photos.",
        degree: 312,
    },
    {
        name: "Cleveland",
        problem: "3*P/P/P + a/a/a",
        words: "Three points and one free line in three photos.",
        degree: 216,
    },
    {
        name: "Seven points",
        problem: "projective: 7*P/P",
        words: "Two cameras of which nothing is known: the fundamental matrix.",
        degree: 3,
    },
    {
        name: "Nine lines",
        problem: "projective: 9*a/a/a",
        words: "Lines alone, seen by three cameras of which nothing is known.",
        degree: 36,
    },
    {
        name: "Five points and P3P",
        problem: "3*P/P/P + 2*-/P/P",
        words: "Two photos share five points. Three of them fix the third camera.",
        degree: 160,
    },
    {
        name: "One point and four lines",
        problem: "P/P/P + 4*a/a/a",
        words: "As few points as three photos can do with, if every photo sees everything.",
        degree: 360,
    },
    {
        name: "Six photos",
        problem: "Pa/Pa/Pa/Pa/Pa/Pa + 2*a/a/a/a/a/a",
        words: "The most photos that calibrated cameras allow if each sees everything.",
        degree: 186368,
    },
];

/** The scene of a sum of features without shared lines. */
export function sceneOf(problem: string): Scene {
    const scene: Scene = { views: 0, points: [], lines: [] };
    for (const summand of problem.replace(/^[\w-]+: /, "").split(" + ")) {
        const [, times = "1", feature = ""] = /^(?:(\d+)\*)?(.*)$/.exec(summand) ?? [];
        const views = feature.split("/");
        scene.views = views.length;
        const seenBy = (sign: string) =>
            views.reduce((set, view, v) => set + (view.includes(sign) ? 2 ** v : 0), 0);
        const letters = [...new Set(feature.replace(/[^a-z]/g, ""))].sort();
        for (let count = 0; count < Number(times); ++count) {
            const point = seenBy("P") > 0 ? [scene.points.length] : [];
            if (point.length > 0) scene.points.push(seenBy("P"));
            for (const letter of letters) scene.lines.push({ points: point, seen: seenBy(letter) });
        }
    }
    return scene;
}

/** A problem in the gallery. */
export function famousCard({ name, problem, words, degree }: Famous): HTMLElement {
    const solutions = `${withCommas(degree)} solutions`;
    return make(
        "li",
        { class: "card" },
        make(
            "a",
            { href: problemAddress(problem), class: "card-link" },
            photos(sceneOf(problem), name, "small"),
            make("span", { class: "famous-name" }, name),
        ),
        make("p", { class: "facts" }, words, " ", make("strong", {}, `${solutions}.`)),
    );
}
