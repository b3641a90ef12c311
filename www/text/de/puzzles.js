// The German words for en/puzzles.js.

import { number } from "./format.js";
import { upper } from "../sentence.js";

/** @typedef {import("../en/puzzles.js").NamedBody} NamedBody */
/** @typedef {import("../en/puzzles.js").Body} Body */
/** @typedef {"nominative" | "accusative" | "dative"} Case */

const COLOURS = { green: "grün", blue: "blau", purple: "violett", gray: "grau", black: "schwarz" };

const SHAPES = /** @type {const} */ ({
  ball: ["f", "Kugel"],
  bar: ["m", "Balken"],
  jar: ["n", "Glas"],
  standing_sticks: ["pl", "Stäbe"],
});

/** The article of each gender, and the ending of an adjective after it. */
const ARTICLES = {
  nominative: { f: ["die", "e"], m: ["der", "e"], n: ["das", "e"], pl: ["die", "en"] },
  accusative: { f: ["die", "e"], m: ["den", "en"], n: ["das", "e"], pl: ["die", "en"] },
  dative: { f: ["der", "en"], m: ["dem", "en"], n: ["dem", "en"], pl: ["den", "en"] },
};

/**
 * „die grüne Kugel“, „dem schwarzen Balken“.
 * @param {NamedBody} body
 * @param {Case} [form]
 */
export function theBody({ role, shape }, form = "nominative") {
  const [gender, noun] = SHAPES[shape];
  const [article, ending] = ARTICLES[form][gender];
  const plural = gender === "pl" && form === "dative" ? "n" : "";
  return `${article} ${COLOURS[role]}${ending} ${noun}${plural}`;
}

/** The ending of an adjective without an article. */
const ENDINGS = { f: "e", m: "er", n: "es", pl: "e" };

/**
 * „grüne Kugel“, „schwarzer Balken“.
 * @param {NamedBody} body
 */
export function aBody({ role, shape }) {
  const [gender, noun] = SHAPES[shape];
  return `${COLOURS[role]}${ENDINGS[gender]} ${noun}`;
}

const at = (/** @type {Body} */ body) => `bei x ${number(body.x)}, y ${number(body.y)}`;
const placed = (/** @type {Body} */ body) => `${theBody(body)} ${at(body)}`;

/** @type {typeof import("../en/puzzles.js").puzzles} */
export const puzzles = {
  body: theBody,
  numbered: (kind, place, of) => `${kind}, ${place} von ${of}`,
  custom: "Eigenes Rätsel",
  edited: (name) => `${name}, geändert`,
  customStory: "Diese Szene hat jemand selbst gebaut. Sie gehört nicht zum Benchmark.",
  goal: (object, target, time) =>
    `${upper(theBody(object))} ${object.shape === "standing_sticks" ? "sollen" : "soll"} ${time} Sekunden lang ${theBody(target, "accusative")} berühren.`,
  description: (object, target, others) =>
    `256 mal 256, y zeigt nach oben. ${upper(placed(object))}; das Ziel ist ${placed(target)}. ` +
    (others.length ? `Außerdem: ${others.map((body) => `${aBody(body)} ${at(body)}`).join("; ")}.` : "Sonst nichts."),
  difficulties: { easy: "leicht", medium: "mittel", hard: "schwer" },
  oneInSolves: (balls) => `etwa 1 von ${number(balls)} Kugeln löst es`,
  fewerSolve: (balls) => `weniger als 1 von ${number(balls)} Kugeln löst es`,
  howHard: (difficulty, share) => `${puzzles.difficulties[difficulty]}: ${share}`,
  facts: (task, difficulty) => `Rätsel ${task}, ${difficulty}.`,
};
