// Puzzles: their names, goals and bodies.

import { MAX_RADIUS, MIN_RADIUS } from "../../pkg/constants.ts";
import { GOAL_SECONDS, formatsOf } from "../formats.ts";
import type { Named } from "../../core/derived/bodies.ts";
import type { Text } from "../text.ts";
import type { Body } from "../../pkg/page/pathlight.js";

const KINDS: Record<string, { name: string; story: string }> = {
  "00000": {
    name: "Freier Fall zu zweit",
    story: "Zwei Kugeln fallen nebeneinander aus gleicher Höhe; bring sie zusammen.",
  },
  "00001": {
    name: "Tablett mit Rand",
    story:
      "Eine Kugel fällt auf ein Brett mit schrägen Rändern; bring sie über den Rand bis an den hohen Streifen an der Wand.",
  },
  "00002": {
    name: "Vordach",
    story:
      "Eine Kugel fällt mitten auf ein Sims; sie soll dort nicht liegen bleiben, sondern bis auf den Boden kommen.",
  },
  "00003": {
    name: "An die Wand kippen",
    story: "Ein Balken steht aufrecht in einem kleinen Glas; stoß ihn gegen den Streifen an der näheren Seitenwand.",
  },
  "00004": {
    name: "Auf der Wippe",
    story: "Eine Kugel fällt auf einen Balken zu, der quer auf einer runden Stütze liegt; sie soll auf ihm bleiben.",
  },
  "00005": {
    name: "Am Glas vorbei",
    story: "Eine Kugel hängt genau über einem Glas; sie soll nicht darin landen, sondern auf dem Boden.",
  },
  "00006": {
    name: "Glas durch die Lücke",
    story:
      "Ein umgedrehtes Glas fällt durch die Lücke in einem Boden; bring die Kugel zu ihm, die auf diesem Boden liegt.",
  },
  "00007": {
    name: "Trichter",
    story:
      "Eine Kugel fällt durch einen Trichter; sie soll auf dem kurzen Streifen in der Ecke landen, hinter dem erhöhten Block.",
  },
  "00008": {
    name: "Treppe und Glas",
    story: "Schräge Stufen führen nach rechts hinab; lenk die Kugel in das abgeschirmte Glas unter einer von ihnen.",
  },
  "00009": {
    name: "Vom Sims",
    story:
      "Ein Balken steht aufrecht am äußeren Ende eines Simses unter einer niedrigen Decke; stoß ihn hinab auf den Boden.",
  },
  "00010": {
    name: "Ab ins Tal",
    story: "Ein Glas mit einer Kugel liegt am linken Hang eines Tals; bring die Kugel an den rechten Hang.",
  },
  "00011": {
    name: "Zwei Schrägen",
    story:
      "Eine Kugel fällt auf die linke obere oder die rechte untere von zwei Schrägen; an der rechten soll sie liegen bleiben.",
  },
  "00012": {
    name: "Zickzack aus Stiften",
    story:
      "Eine Kugel fällt zwischen Reihen von Stiften, die abwechselnd von links und rechts ansteigen; bring sie hinab auf den Boden.",
  },
  "00013": {
    name: "Dickicht aus Stiften",
    story: "Eine Kugel fällt in zwei verzweigte, gewundene Ketten aus Stiften; bring sie hindurch bis auf den Boden.",
  },
  "00014": {
    name: "Hinter die Trennwand",
    story:
      "Eine Kugel landet neben einem dünnen Pfosten; bring sie an der hängenden Trennwand vorbei in die andere Hälfte.",
  },
  "00015": {
    name: "Wiege",
    story: "Eine Kugel sitzt in einer winzigen Wiege mitten in der Luft; stoß sie heraus und hinab auf den Boden.",
  },
  "00016": {
    name: "Sprungschanze",
    story:
      "Eine Kugel rollt hinter einer kleineren eine Rampe hinab und über eine Schanze; sie soll auf dem kurzen Bodenstück landen.",
  },
  "00017": {
    name: "Kugel auf dem Pfosten",
    story: "Eine Kugel liegt auf einem aufrechten Pfosten, dicht unter einer Decke; stoß sie hinab auf den Boden.",
  },
  "00018": {
    name: "Verdeckte Kugel",
    story:
      "Eine kleine Kugel liegt auf einem Brett unter einem umgedrehten Glas; bring sie zu der Kugel in dem Glas auf dem Boden.",
  },
  "00019": {
    name: "Begleitschutz",
    story:
      "Zwei Kugeln fallen, eine über der anderen; die obere soll auf dem Podest mit den kleinen Rändern zur Ruhe kommen.",
  },
  "00020": {
    name: "Lamellen",
    story:
      "Eine Kugel fällt in den Spalt zwischen Lamellen und einer geteilten Wand; bring sie auf den Boden hinter der Wand.",
  },
  "00021": {
    name: "Schwankende Brücke",
    story:
      "Eine Kugel rollt von einer Rampe über ein Brett auf zwei runden Stützen; bring sie hinüber zum festen Glas.",
  },
  "00022": {
    name: "Ins Glas kippen",
    story: "Eine Kugel liegt auf einer kleinen schrägen Platte; bring sie zu der Kugel im Glas darunter.",
  },
  "00023": {
    name: "Rollende Brücke",
    story:
      "Ein Brett mit einer kleinen Kugel am Ende liegt auf einer großen losen Kugel; bring die kleine zu der Kugel im entfernten Glas.",
  },
  "00024": {
    name: "Loch und Stöpsel",
    story:
      "Zuerst fällt eine etwas größere Kugel in das Loch eines erhöhten Bodens; bring die andere bis ganz nach unten.",
  },
};

type Case = "nominative" | "accusative";

const { number } = formatsOf("de");
const COLOURS: Record<Body["role"], string> = {
  green: "grün",
  blue: "blau",
  purple: "violett",
  gray: "grau",
  black: "schwarz",
};
const SHAPES: Record<Body["shape"], readonly [gender: "f" | "m" | "n" | "pl", noun: string]> = {
  ball: ["f", "Kugel"],
  bar: ["m", "Balken"],
  jar: ["n", "Glas"],
  standing_sticks: ["pl", "Stäbe"],
};
/** The article of each gender, and the ending of an adjective after it. */
const ARTICLES = {
  nominative: { f: ["die", "e"], m: ["der", "e"], n: ["das", "e"], pl: ["die", "en"] },
  accusative: { f: ["die", "e"], m: ["den", "en"], n: ["das", "e"], pl: ["die", "en"] },
} as const;

export function theBody({ role, shape }: Named, form: Case = "nominative"): string {
  const [gender, noun] = SHAPES[shape];
  const [article, ending] = ARTICLES[form][gender];
  return `${article} ${COLOURS[role]}${ending} ${noun}`;
}

const upper = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);
const placed = (one: Body) => `${theBody(one)} bei x ${number(one.x)}, y ${number(one.y)}`;

export const puzzle: Text["puzzle"] = {
  name: ({ id, name }) => (id ? KINDS[id.slice(0, 5)]!.name : (name ?? "Eigenes Rätsel")),
  instructions: ({ id }) => (id ? KINDS[id.slice(0, 5)]!.story : "Diese Szene ist selbst gebaut."),
  goal: (object, target) =>
    `${upper(theBody(object))} ${object.shape === "standing_sticks" ? "sollen" : "soll"} ${GOAL_SECONDS} Sekunden lang ` +
    `${theBody(target, "accusative")} berühren.`,
  body: theBody,
  scene: (object, target, others) =>
    `256 mal 256, y zeigt nach oben. ${upper(placed(object))}; das Ziel ist ${placed(target)}. ` +
    (others.length ? `Außerdem: ${[...new Set(others.map(placed))].join("; ")}.` : "Sonst nichts."),
  ballAt: (x, y, r) => `Deine Kugel liegt bei x ${x}, y ${y} und hat den Radius ${r}.`,
  fault: (fault, bodies) =>
    fault.kind === "overlaps"
      ? `Hier nicht: Die Kugel überlappt ${theBody(bodies[fault.body]!, "accusative")}.`
      : fault.kind === "outside"
        ? "Hier nicht: zu nah am Rand."
        : `Der Radius der Kugel ist ${MIN_RADIUS} bis ${MAX_RADIUS}.`,
};
