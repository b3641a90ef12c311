// The texts of the page in German.

import { ATTEMPT_LIMIT, MAX_RADIUS, MIN_RADIUS } from "../pkg/constants.ts";
import { formatsOf, GOAL_SECONDS, secondsOf } from "./formats.ts";
import { widthsIn } from "./widths.ts";
import type { Failure } from "../core/change/model.ts";
import type { Point } from "../core/change/placement.ts";
import type { Named, Size } from "../core/derived/bodies.ts";
import type { LuckKind, Outcome } from "../core/derived/duel.ts";
import type { Difficulty } from "../core/derived/home.ts";
import type { Result } from "../core/derived/sharing.ts";
import type { Body } from "../pkg/page/pathlight.js";
import type { Language, Text } from "./languages.ts";

const { chance, counted, number, percent, seconds } = formatsOf("de", "unter 1\u00a0%");

export const language: Language = "de";

// The panels next to the scene, in the order of their tabs.
export const tabs: Text["tabs"] = {
  play: "Spielen",
  imagine: "Vorstellen",
  predict: "Vorhersagen",
  make: "Bauen",
  data: "Daten",
};

// Distances in widths of a ball.
const balls = widthsIn({
  hair: "ein Haar",
  quarter: "eine Viertelkugel",
  half: "eine halbe Kugel",
  one: "eine Kugelbreite",
  more: (count) => `${number(count)} Kugeln`,
});

// Puzzles: their names, goals and bodies.
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

function theBody({ role, shape }: Named, form: Case = "nominative"): string {
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

// Playing: placing and dropping the ball, the duel and its verdict, the list of attempts, maps and the check.
const OUTCOMES: Record<Outcome, (round: number, modelAt: number | null) => string> = {
  won: (round) =>
    round === 1 ? "Du schlägst das Modell mit der ersten Kugel!" : `Du schlägst das Modell mit Kugel ${round}!`,
  draw: (round) => `Unentschieden: Beide lösen es mit Kugel ${round}.`,
  late: (round, modelAt) => `Gelöst mit Kugel ${round}! Das Modell brauchte ${modelAt}.`,
  lost: (round) => `Das Modell löst es mit Kugel ${round}. Und du?`,
  behind: (_, modelAt) => `Noch nicht. Das Modell brauchte ${counted(modelAt!, "Kugel", "Kugeln")}.`,
  neither: () => "Noch keiner von beiden.",
  solved: (round) => (round === 1 ? "Gelöst mit der ersten Kugel!" : `Gelöst mit Kugel ${round}!`),
  missed: () => "Noch nicht.",
  after: () => "Verfehlt, aber gelöst hast du es schon.",
};

const LUCK: Record<LuckKind, string> = {
  plan: "Ein Plan",
  some: "Ein Plan mit etwas Glück",
  mostly: "Vor allem Glück",
};

export const play: Text["play"] = {
  step: {
    start: "Spiel gegen sie",
    drop: "Fallen lassen",
    run: "Laufen lassen",
    pause: "Pause",
    play: "Weiter",
    again: "Neuer Versuch",
    back: "Du bist dran",
    next: "Nächstes Rätsel",
    try: "Spielen",
    make: "Weiterbauen",
  },
  placeFirst: "Klick oder tipp in die Szene, um deine rote Kugel zu setzen. Danach fasst niemand mehr etwas an.",
  keys: "Mit Tasten: Pfeile setzen und bewegen sie, Plus und Minus ändern ihre Größe, Enter lässt sie fallen.",
  ready: "Bereit. Lass sie fallen!",
  choosing: "Das Modell wählt seine Kugel …",
  running: "Jetzt fasst niemand mehr etwas an.",
  full: `Du hast alle ${ATTEMPT_LIMIT} Kugeln dieses Rätsels verbraucht.`,

  verdict: ({ outcome, round, modelAt }) => OUTCOMES[outcome](round, modelAt),
  miss: ({ facts: { ending, nearest, line }, changedNothing }) =>
    changedNothing
      ? "Grün lief genau so, wie es ohne deine Kugel läuft."
      : ending.longest_touch > 0
        ? `Grün hat das Ziel ${seconds(secondsOf(ending.longest_touch))} lang berührt, ${GOAL_SECONDS} wären nötig.`
        : `Grün hat das Ziel um ${balls(nearest.gap, line.ball![2])} verfehlt.`,
  guessed: (given, off, radius) =>
    `Das Modell gab deiner Kugel eine Chance von ${chance(given)}; ` +
    `seine Vermutung lag um ${balls(off, radius)} daneben.`,
  luck: (kind, solved, valid) =>
    `${LUCK[kind]}: ${solved === 1 ? "eine" : solved} der ${valid} Kugeln neben deiner ${solved === 1 ? "löst" : "lösen"} es auch.`,
  showModel: "Kugel des Modells zeigen",

  playback: "Wiedergabe",
  moment: "Zeitpunkt",
  speed: "Tempo",
  times: (speed) => (speed === 0.25 ? "¼×" : `${speed}×`),
  time: (steps) => seconds(secondsOf(steps)),
  replay: "Noch einmal abspielen",

  radius: "Größe",
  duel: "Du gegen das Modell",
  you: "Du",
  model: "Modell",
  noAttempts: "Jede Kugel ist ein Duell: Das Modell lässt eine eigene fallen.",
  solved: "gelöst",
  missed: "verfehlt",
  waiting: "noch nicht",
  done: "fertig",
  round: (round) => `Kugel ${round}: noch einmal zeigen`,
  guess: "Vermutung des Modells",
  alone: "Ohne das Modell spielen",
};

// The check: where balls of a radius work, and the search for an easy one.
export const check: Text["check"] = {
  show: "Alle Lösungen zeigen",
  offer: "Dreimal verfehlt: Möchtest du sehen, wo eine Kugel es schafft?",
  radius: "Größe der Kugeln",
  tried: (progress, working) =>
    (progress < 1
      ? `${percent(progress)} probiert.`
      : working === 0
        ? "Keine Kugel dieser Größe schafft es."
        : `Eine Kugel dieser Größe schafft es von ${chance(working)} aller Plätze aus.`) +
    `${working === 0 && progress === 1 ? "" : " Gelb: löst es."} Gestreift: kein Platz für die Kugel.`,
  compare: "Mit der Karte des Modells vergleichen",
  agrees: (share) => `${percent(share)} seiner Karte liegen dort, wo eine Kugel es schafft.`,
  seek: "Eine Lösung zeigen",
  stop: "Nicht weitersuchen",
  shown: "Das war die Lösung: Sie zählt nicht. Eine andere Kugel ist deine.",
  found: ({ progress, valid, solved, rank, easiest, solves_itself }) =>
    [
      solves_itself ? "Es löst sich von selbst, ganz ohne Kugel." : "",
      progress < 1
        ? `Sucht eine einfache Kugel: ${percent(progress)}.`
        : easiest
          ? `Von ${counted(valid, "Kugel", "Kugeln")} ${solved === 1 ? "löst es eine" : `lösen es ${number(solved)}`}. Eine einfache liegt jetzt in der Szene.`
          : `Von ${counted(valid, "Kugel", "Kugeln")} aller Plätze und Größen löst es keine. Dazwischen könnte es noch eine geben.`,
      progress === 1 && easiest && rank !== null ? `${percent(rank)} der Rätsel von Pathlight sind schwerer.` : "",
    ]
      .filter(Boolean)
      .join(" "),
};

// Which model plays, and whether it was trained on the puzzle.
export const model: Text["model"] = {
  choose: "Modell",
  names: {
    within: "Modell A: mit allen 25 Arten von Rätseln trainiert",
    cross: "Modell B: mit zufälligen Szenen trainiert",
  },
  short: { within: "Modell A", cross: "Modell B" },
  practised: {
    within: "Achtung: Genau dieses Rätsel hat es geübt.",
    cross: "Die Netze seiner Karten haben genau dieses Rätsel geübt; das Netz, das die Kugel wählt, nicht.",
  },
  unseen: {
    within: "Es kennt diese Art, aber nicht dieses Rätsel.",
    cross: "Diese Art Rätsel hat es nie gesehen.",
    custom: "Dieses Rätsel hat es nie gesehen.",
  },
};

// What the model imagines: the walkthrough, the maps, and how they are made.
const place = ([x, y]: Point) => `x ${Math.round(x)}, y ${Math.round(y)}`;

export const imagine: Text["imagine"] = {
  walkthrough: "Wie das Modell auf seine Kugel kommt",
  tour: "Schritte abspielen",
  stop: "Anhalten",
  all: "Alle",
  back: "Schritt zurück",
  next: "Nächster Schritt",
  step: (number, name) => `Schritt ${number}: ${name}`,
  maps: "Karten über der Szene",
  intro:
    "Bevor sich etwas bewegt, stellen sich fünf kleine Netze vor, was kommt. Tipp auf eine Karte, um sie über die Szene zu legen.",
  how: "Wie geht das?",

  steps: {
    base: ["Wenn du nichts tust", "Wohin sich Grün von allein bewegt."],
    target: ["Was Grün tun muss", "Eine Bahn für Grün, die an seinem Ziel endet."],
    action: ["Was Rot tun muss", "Eine Bahn für die rote Kugel, die Grün dorthin bringt."],
    placement: ["Wo Rot beginnt", "Wo die rote Kugel starten sollte und wo es klappen würde."],
    imagined: [
      "Vierzig mögliche Bahnen",
      "Jede Linie ist eine mögliche Bahn von Grün, jede mit einer anderen Kugel. Je kräftiger die Linie, desto besser die Chancen.",
    ],
    run: [
      "Was wirklich passiert",
      "Das Modell lässt seine Lieblingskugel fallen. Gepunktet: was es sich vorgestellt hat. Durchgezogen: was wirklich passiert.",
    ],
  },
  works: "Was gelingt",
  paper: {
    base: "Grundbahn",
    target: "Zielbahn",
    action: "Aktionsbahn",
    placement: "Startkarte",
    success: "Erfolgskarte",
  },
  hows: {
    base: "Das Netz sieht nur die Szene, als Bilder aus 64 × 64 Feldern, eines für jede Farbe. Für jedes Feld sagt es, wie sicher es ist, dass Grün dort vorbeikommt.",
    target:
      "Auch dieses Netz sieht nur die Szene. Es hat aus gelösten Rätseln gelernt, welchen Weg Grün dort nahm. Die rote Kugel kennt es noch nicht.",
    action:
      "Dieses Netz sieht die Szene, die Grundbahn und die Zielbahn: was passieren würde und was passieren soll. Für den Unterschied muss die rote Kugel sorgen.",
    placement: "Dieses Netz sieht die Szene, die Zielbahn und die Aktionsbahn.",
    success:
      "Ein fünftes Netz, das es im Fachartikel nicht gibt, sagt für Kugeln in acht Größen an jedem Ort, wie wahrscheinlich sie das Rätsel lösen. Die Karte zeigt die beste Größe.",
    imagined:
      "Das fünfte Netz hat an Kugeln aller Art gelernt, was sie bewirken. Die vielversprechendsten Kugeln kommen in die Auswahl. Bei jeder davon stellt es sich vor, wohin sich Grün und die Kugel bewegen würden und wie wahrscheinlich das eine Lösung ist. Gezeichnet sind die vierzig aussichtsreichsten. Nichts davon wird simuliert.",
    run: "Die Kugel läuft im selben Simulator wie deine. Je breiter das Band um eine gepunktete Linie, desto unsicherer war sich das Modell. Schafft es die Kugel nicht, werden ähnliche unwahrscheinlicher, und die aussichtsreichste der anderen ist als Nächste dran.",
  },

  path: (from, to) => `von ${place(from)} bis ${place(to)}`,
  strongest: (at) => `am stärksten bei ${place(at)}`,
  considered: (count, likely) =>
    `Es hat ${counted(count, "Kugel", "Kugeln")} erwogen und gibt ${likely === count ? "allen" : likely === 1 ? "einer" : likely || "keiner"} davon mehr als 50 %.`,
  waiting: "Das Modell überlegt …",
  ended: (solved, given) =>
    `Es gab seiner Kugel ${chance(given)}, und ${solved ? "sie schafft es." : "sie schafft es nicht."}`,
  off: (distance, radius) =>
    `Die Bahn, die es sich für Grün vorgestellt hat, lag im Schnitt um ${balls(distance, radius)} daneben.`,
};

// Predicting where the green object goes.
export const predict: Text["predict"] = {
  intro:
    "Welchen Weg nimmt Grün? Zeichne seine Bahn und lass es dann laufen: Warst du näher dran oder das Modell? Soll eine rote Kugel mitspielen, setz sie vorher.",
  keys: "Mit Tasten: In der Szene zeichnen Pfeile von Grün aus weiter, mit Umschalt in größeren Schritten.",
  draw: "Fang bei Grün an und zeichne seinen Weg.",
  drawn: "Fertig? Dann lass es laufen.",
  wipe: "Linie wegwischen",
  noBall: "Kugel wegnehmen",
  result: (you, model) => {
    const [mine, its] = [percent(you), model === null ? null : percent(model)];
    if (model === null) return `Du hattest zu ${mine} recht.`;
    if (mine === its) return `Unentschieden: Beide hatten zu ${mine} recht.`;
    return you > model
      ? `Du warst näher dran: ${mine}, das Modell ${its}.`
      : `Das Modell war näher dran: ${its}, du ${mine}.`;
  },
  measured: "Schwarze Punkte: deine Linie. Grüne Punkte: die des Modells. 100 % wäre genau der wirkliche Weg.",
};

// Making a puzzle: its bodies, its problems, keeping and sharing it.
const SIZES: Record<Size, string> = { radius: "Radius", length: "Länge", thickness: "Dicke", height: "Höhe" };
const px = (length: number) => (Math.abs(length) < 1e5 ? number(length, length % 1 ? 1 : 0) : length.toExponential(0));

export const make: Text["make"] = {
  hint: "Zieh ein Teil, um es zu verschieben. Tipp es an, dann hat es Griffe: Der eckige ändert die Größe, der runde dreht.",
  broken: "Noch nicht spielbar: Schau nach, was rot umringt ist.",
  watch: "Ohne Kugel ansehen",

  add: "Teil hinzufügen",
  shapes: { ball: "+ Kugel", bar: "+ Balken", jar: "+ Glas", standing_sticks: "+ Stäbe" },
  empty: "Leer beginnen",
  selected: "Gewähltes Teil",
  duplicate: "Duplizieren",
  remove: "Löschen",
  role: "Es ist",
  roles: {
    green: "grün: soll ans Ziel",
    blue: "blau: das Ziel, beweglich",
    purple: "violett: das Ziel, fest",
    gray: "grau: beweglich",
    black: "schwarz: fest",
  },

  details: "Details",
  body: "Teil",
  nothing: "nichts gewählt",
  named: (body, index) => `${index + 1}: ${puzzle.body(body)}`,
  angle: "Winkel",
  sizes: SIZES,
  keys: "Tasten in der Szene: N und P wählen, Pfeile verschieben, Komma und Punkt drehen, + und − ändern die Größe, mit Umschalt in größeren Schritten; D dupliziert, Entf löscht, Strg+Z macht rückgängig.",
  described: (body, x, y, degrees, sizes) =>
    `Gewählt: ${puzzle.body(body)} bei x ${px(x)}, y ${px(y)}, um ${px(degrees)} Grad gedreht, ` +
    `${sizes.map(([size, value]) => `${SIZES[size]} ${px(value)}`).join("; ")}.`,

  live: "Zeigen, wo das Modell Grün erwartet",
  name: "Name",
  changed: (name) => `${name}, verändert`,
  keep: "In diesem Browser behalten",
  kept: "In diesem Browser behalten ✓",
  save: "Als Datei speichern",
  open: "Datei öffnen",
  link: "In der Adresse dieser Seite steckt dein ganzes Rätsel: Wer den Link öffnet, spielt es.",
  yours: (count) => `Deine Rätsel (${number(count)})`,
  forget: (name) => `„${name}“ löschen`,

  problem: ({ fault, body, other }) => {
    switch (fault.kind) {
      case "unreadable":
        return "Das ist keine Szene von Pathlight.";
      case "own_goal":
        return "Grün kann nicht sein eigenes Ziel sein: Wähl ein anderes Ziel.";
      case "static_object":
        return "Grün muss beweglich sein, sonst kommt es nie ans Ziel.";
      case "bodies":
        return fault.count > fault.most
          ? `Es sind mehr als ${fault.most} Teile: Lösch einige.`
          : `Es braucht mindestens ${fault.least} Teile: Füg eins hinzu.`;
      case "name":
        return `Der Name hat mehr als ${fault.most} Zeichen.`;
      case "place":
        return `Kein gültiger Ort für ${theBody(body!, "accusative")}.`;
      case "length":
        return `${SIZES[fault.key]}: ${px(fault.least)} bis ${px(fault.most)} px sind erlaubt (${theBody(body!)}).`;
      case "sticks_out":
      case "sticks_out_of_corner":
        return `Ragt ${px(fault.by)} px hinaus: Schieb es hinein oder mach es kleiner.`;
      case "outside":
        return `Liegt ${px(fault.by)} px außerhalb: Schieb es näher oder lösch es.`;
      case "overlap":
        return `Überschneidet ${theBody(other!, "accusative")} um ${px(fault.by)} px: Schieb sie auseinander.`;
    }
  },
};

// The panel Data: numbers and files.
export const data: Text["data"] = {
  ball: "Kugel",
  axes: { x: "x", y: "y", r: "Radius" },
  run: "Vorgestellt und wirklich",
  noRun: "Sobald eine Kugel gefallen ist, steht hier in Zahlen, wie gut die Vorstellung war.",
  green: "Grün",
  red: "Rot",
  off: "Grün daneben um",
  you: "Deine Kugel",
  model: "Kugel des Modells",
  alone: "Ohne Kugel",
  agreement: percent,
  px: (distance) => `${number(distance, 1)}\u00a0px`,
  explained:
    "Prozente: wie gut die vorgestellten Bahnen die wirklichen decken, Schnitt durch Vereinigung auf 64 × 64 Feldern; ohne Kugel die Grundbahn, sonst Ziel- und Aktionsbahn. Abstand: zwischen dem, was sich das Modell für genau deine Kugel vorgestellt hat, und dem, was geschah, im Schnitt.",
  saveMaps: "Karten als Bild speichern",
  attempts: "Deine Versuche",
  kept: (count) =>
    `${counted(count, "Versuch", "Versuche")}, nur in diesem Browser. Safari löscht sie nach sieben Tagen ohne Besuch, andere Browser, wenn die Platte voll ist; eine Datei bleibt.`,
  save: "Als Datei speichern",
  open: "Datei öffnen",
  table: "Dieses Rätsel als CSV",
};

// The home page.
const LEVELS: Record<Difficulty, string> = { easy: "leicht", medium: "mittel", hard: "schwer" };

export const home: Text["home"] = {
  title: "Schau zu, wie sich eine winzige KI vorstellt, was passiert. Dann schlag sie.",
  goal: "Setz eine rote Kugel so, dass das grüne Objekt 3 Sekunden lang sein gestreiftes Ziel berührt.",
  about: "Die KI ist ein kleines Modell, das in deinem Browser läuft; auch sie hat dieses Rätsel noch nie gesehen.",
  play: "Animation abspielen",
  pause: "Animation anhalten",

  waiting: "Du kannst schon spielen: Klick oder tipp ins Bild.",
  imagine: (futures) => `Das Modell stellt sich ${futures} Bahnen vor …`,
  pick: (chance) => `… und wählt eine: Es ist sich zu ${percent(chance)} sicher.`,
  real: "Jetzt fällt seine Kugel wirklich.",
  result: (solved, off, radius) =>
    `${solved ? "Gelöst" : "Verfehlt"}: Seine Vermutung lag um ${balls(off, radius)} daneben. Du bist dran: Klick oder tipp ins Bild.`,

  day: "Rätsel des Tages",
  unsolved: "Das hat das Modell nie gelöst",
  canYou: (facts) => `Schaffst du es? ${facts}`,
  make: "Bau dein eigenes Rätsel",
  makeHint: "Verschieb, was du willst, spiel es und schick es Freunden",
  facts: (puzzle, difficulty) => `${puzzle}, ${LEVELS[difficulty]}`,
  howHard: (difficulty, { balls, isRarer }) =>
    `${LEVELS[difficulty].charAt(0).toUpperCase()}${LEVELS[difficulty].slice(1)}: ` +
    (isRarer ? `Weniger als 1 von ${balls} Kugeln löst es.` : `1 von ${balls} Kugeln löst es.`),

  kinds: (count) => `${count} Arten von Rätseln`,
  number: "Oder nach Nummer:",
  standing: (next, of, played) => {
    const solved = played.filter((one) => one.solved).length;
    const missed = played.length - solved;
    const found = [solved && `${solved} gelöst`, missed && `${missed} verfehlt`].filter(Boolean).join(", ");
    return `Rätsel ${next} von ${of} · ${found}`;
  },
  results: "Wie gut sind die Modelle? Alle Ergebnisse",
  learns: "Dem Modell beim Lernen zusehen",

  progress: "Dein Fortschritt",
  soFar: ({ tried, solved, attempts }) =>
    `Bisher hast du ${counted(tried, "Rätsel", "Rätsel")} probiert und ${number(solved)} gelöst, mit ${counted(attempts, "Kugel", "Kugeln")}`,
  forget: "Alle Versuche vergessen",
  keep: "Behalten",
  forgetHint:
    "Dieser Browser kennt dann keine deiner Kugeln und Lösungen mehr. Das lässt sich nicht rückgängig machen.",
};

// Sharing a puzzle, and links for a lesson.
const first = (at: number) => (at === 1 ? "mit der ersten Kugel" : `mit Kugel ${at}`);

const rival = ({ modelAt, modelBalls }: Result) =>
  modelAt !== null
    ? `Das Modell brauchte ${counted(modelAt, "Kugel", "Kugeln")}.`
    : modelBalls > 0
      ? `Das Modell hat es mit ${counted(modelBalls, "Kugel", "Kugeln")} nicht gelöst.`
      : "";

export const share: Text["share"] = {
  headline: (solvedAt) => (solvedAt === null ? "Kannst du das lösen?" : `Gelöst ${first(solvedAt)}`),
  model: rival,
  message: (puzzle, found, isDaily) => {
    const { solvedAt, isWon, marks } = found;
    if (solvedAt === null) return `„${puzzle}“ in Pathlight: Kannst du das lösen?`;
    const daily = isDaily ? `Pathlights Rätsel des Tages. ${marks} ` : "";
    const result = isWon
      ? `Ich habe das Modell bei „${puzzle}“ ${first(solvedAt)} geschlagen.`
      : `Ich habe „${puzzle}“ ${first(solvedAt)} gelöst.`;
    const ask = solvedAt === 1 ? "Schaffst du das auch?" : "Schaffst du es schneller?";
    return `${daily}${result} ${rival(found)} ${ask}`.replace("  ", " ");
  },
  link: "Der Link",
  noBall: "Der Link verrät weder deine Kugel noch die des Modells noch seine Vermutung, bis das Rätsel gelöst ist.",
  copy: "Text und Link kopieren",
  system: "Teilen …",
  save: "Bild speichern",
  drawing: "Das Bild wird gemalt …",
  noCard: {
    missing: "Dieser Browser gibt kein Bild her. Text und Link sagen alles.",
    noise: "Dieser Browser schützt seine Bilder, darum kämen nur Streifen heraus. Text und Link sagen alles.",
  },
  withBall: "Meine Kugel im Bild zeigen",
  done: {
    copied: "Kopiert.",
    not_copied: "Dieser Browser erlaubt der Seite nicht, etwas zu kopieren. Markier oben den Link und kopier ihn.",
    not_shared: "Dieser Browser konnte nichts teilen. Kopier Text und Link.",
  },
  send: "Weitersagen",

  challenge: (at) =>
    `Jemand hat das ${first(at)} gelöst. Schaffst du es schneller? Das Modell schweigt, bis du es gelöst hast.`,
  challenged: (at, theirs) =>
    at < theirs
      ? `Du gewinnst: Die anderen brauchten ${theirs} Kugeln.`
      : at === theirs
        ? "Unentschieden: gleich viele Kugeln."
        : `Die anderen brauchten ${counted(theirs, "Kugel", "Kugeln")}.`,

  puzzles: "Nummern der Rätsel, mit Komma getrennt; sie stehen neben den Namen",
  lastPuzzle: "Das war das letzte Rätsel der Stunde.",
  place: (number, of) => `${number} von ${of}`,
  noPuzzles: (wrong) =>
    `${wrong.join(", ")}: ${wrong.length === 1 ? "Das ist kein Rätsel" : "Das sind keine Rätsel"}. Rätselnummern sehen aus wie 00007:008 oder 7:8.`,
  shows: "Was die Klasse sieht",
  presets: { everything: "Alles", play: "Nur Spielen", predict: "Vorhersagen: ohne Vermutung des Modells" },
  customise: "Selbst auswählen",
  parts: { puzzles: "Die Wege zu anderen Rätseln", guess: "Die Vermutung des Modells", model: "Das Modell" },
  presentation: "Als Präsentation, für einen Beamer",
  copyLink: "Link kopieren",
  preview: "So ansehen, wie die Klasse es sieht",
  code: "Der Link als QR-Code",
  noCode: "Für einen QR-Code ist der Link zu lang. Er funktioniert auch ohne.",
  ownMachine: "Dieser Link funktioniert nur auf diesem Computer: Stell die Seite dort bereit, wo andere sie erreichen.",
  end: "Im Link steckt alles: Sonst wird nirgends etwas gespeichert.",
};

// The dialog "About Pathlight".
export const about: Text["about"] = {
  idea: [
    "Pathlight ist ein Spiel gegen eine kleine KI, die plant, indem sie sich etwas vorstellt. Bevor eine Kugel fällt, malen vier kleine neuronale Netze, wohin das grüne Objekt von allein gelangt, wohin es soll, was Rot dafür tun muss und wo Rot beginnen sollte. Ein fünftes stellt sich vor, was jede beliebige Kugel bewirken würde.",
    "Nichts, was du vom Modell siehst, ist gestellt: Es denkt in deinem Browser, während du spielst. Dann zeigt der Simulator, was wirklich passiert, auf das Bit genau wie in dem Benchmark, aus dem die Rätsel stammen. Was du spielst, bleibt auf diesem Gerät.",
  ],
  paper: "Der Fachartikel: Solving Physics Puzzles by Reasoning about Paths (Harter und andere, 2020)",
  phyre: "Die Rätsel: PHYRE, ein Benchmark für physikalisches Denken (Bakhtin und andere, 2019)",
  keys: "Tasten",
  keyList: [
    ["← ↑ → ↓", "die Kugel bewegen; mit Umschalt weiter"],
    ["+ -", "ihre Größe ändern"],
    ["Enter", "fallen lassen, dann weiter"],
    ["Leertaste", "anhalten oder abspielen"],
    [", .", "einen Schritt zurück oder vor"],
    ["R", "neuer Versuch"],
    ["Strg+Z Strg+Y", "rückgängig, wiederholen"],
    ["1 … 5", "die Bereiche"],
    ["[ ]", "das Rätsel davor und danach"],
  ],
  source: "Quelltext und Zitat",
  cite: "Pathlight ist quelloffen, unter der Apache-Lizenz 2.0. Wer es in der Forschung benutzt, kann es zitieren, und die Arbeiten, auf denen es beruht.",
  citation: "So wird es zitiert",
  licences: "Lizenzen von allem, was darin steckt",
};

// The page around the scene: header, menu, and messages about errors.
const FAILURES: Record<Failure["code"], string> = {
  offline: "Keine Verbindung. Es geht weiter, sobald du wieder online bist.",
  unreachable: "Der Server antwortet nicht. Versuch es später noch einmal.",
  missing: "Eine Datei fehlt auf diesem Server. Wer ihn betreibt, muss alle Dateien von Pathlight dort ablegen.",
  page: "Statt einer Datei kam eine Webseite. Musst du dich in diesem Netz erst anmelden? Sonst antwortet der Server falsch.",
  damaged: "Eine Datei kam beschädigt an oder gehört zu einer anderen Version. Lad die Seite neu.",
  forbidden:
    "Diese Seite verbietet WebAssembly: Ihre Content-Security-Policy braucht 'wasm-unsafe-eval' in script-src.",
  old: "Dieser Browser ist zu alt: Er muss WebAssembly mit SIMD können. Aktualisier ihn oder nimm einen anderen.",
  worker:
    "Diese Seite verbietet Worker: Ihre Content-Security-Policy braucht worker-src, ein Frame mit sandbox allow-same-origin.",
  crashed: "Es ist unerwartet stehen geblieben. Lad es noch einmal.",
  broken: "Es konnte nicht gestartet werden. Lad die Seite neu.",
};

export const page: Text["page"] = {
  brand: "Pathlight",
  titles: {
    share: "Teilen",
    lesson: "Link für den Unterricht",
    about: "Über Pathlight",
    forget: "Alle Versuche vergessen?",
  },
  share: "Teilen",
  present: "Präsentation",
  leave: "Präsentation verlassen",
  previous: "Voriges Rätsel",
  next: "Nächstes Rätsel der Liste",
  number: "Nummer des Rätsels",
  tabs: "Bereiche",
  menu: "Menü",
  theme: "Farben",
  themes: { light: "Hell", dark: "Dunkel" },
  language: "Sprache",
  learns: "Dem Modell beim Lernen zusehen",
  results: "Wie gut sind die Modelle?",
  scene: "Szene des Rätsels",

  loading: (arrived) => `Das Modell lädt (${percent(arrived)}). Du kannst schon spielen.`,
  failure: (failure) => FAILURES[failure.code],
  noModel: (failure) => `Du kannst weiterspielen, nur das Modell fehlt. ${FAILURES[failure.code]}`,
  retry: "Noch einmal laden",
  dismiss: "Schließen",
  notice: (notice) => {
    switch (notice.kind) {
      case "no_task":
        return `Ein Rätsel ${notice.task} gibt es nicht. Jede Art hat hundert Nummern mit Lücken dazwischen: Die Nummer eines Rätsels steht neben seinem Namen.`;
      case "unread_link":
        return `Dieser Link enthält etwas, das Pathlight nicht versteht: ${notice.parts.join(", ")}.`;
      case "bad_scene":
        return `Das Rätsel dieses Links lässt sich nicht öffnen: ${notice.problem ? make.problem(notice.problem) : "Ein Teil des Links fehlt. Lass ihn dir noch einmal schicken."}`;
      case "bad_file":
        return `Diese Datei wurde nicht geöffnet: ${notice.problem ? make.problem(notice.problem) : "Darin ist kein Rätsel von Pathlight."}`;
      case "storage_full":
        return "Dieser Browser behält hier nichts: Was du jetzt spielst, ist vergessen, wenn du gehst.";
      case "no_text":
        return "Diese Sprache konnte nicht geladen werden. Lad die Seite neu.";
      case "no_picture":
        return "Dieser Browser konnte das Bild nicht machen.";
      case "opening":
        return `Die Datei wird gelesen: ${percent(notice.share)}.`;
      case "opened":
        return (
          `${counted(notice.found, "Versuch", "Versuche")} in der Datei, ${notice.added === 1 ? "einer" : notice.added || "keiner"} davon neu.` +
          (notice.unread ? ` ${counted(notice.unread, "Zeile ist", "Zeilen sind")} kein Versuch.` : "")
        );
      case "no_attempts":
        return `${notice.file} ist keine Datei mit Versuchen aus Pathlight. Hier bleibt alles, wie es war.`;
    }
  },
};
