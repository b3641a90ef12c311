// The German words for en/editor.js.

import { counted, number, percent } from "./format.js";
import { upper } from "../sentence.js";
import { aBody, theBody } from "./puzzles.js";

const SIZES = { radius: "Radius", length: "Länge", thickness: "Dicke", height: "Höhe" };

/** @param {number} value */
const decimal = (value) => number(value, 2, { minimumFractionDigits: 0 });

/** @type {typeof import("../en/editor.js").editor} */
export const editor = {
  panel: {
    intro: "Bau aus diesem Rätsel ein eigenes.",
    neverSeen: "Ändere etwas: Dann ist es neu für das Modell.",
    changes: "Änderungen",
    add: "Körper hinzufügen",
    addBall: "+ Kugel",
    addBar: "+ Balken",
    addJar: "+ Glas",
    addSticks: "+ Stäbe",
    snap: "Am Raster einrasten",
    problems: "Was du zuerst beheben musst",
    bodies: "Körper",
    selected: "Gewählter Körper",
    angle: "Winkel",
    moves: "Beweglich",
    actions: "Was damit passieren soll",
    object: "Grünes Objekt",
    goal: "Ziel",
    duplicate: "Duplizieren",
    remove: "Löschen",
    hint: "Wähl einen Körper in der Szene oder in der Liste. Mit Tasten, in der Szene: <kbd>N</kbd> und <kbd>P</kbd> wählen, Pfeile verschieben, <kbd>,</kbd> <kbd>.</kbd> drehen, <kbd>+</kbd> <kbd>−</kbd> ändern die Größe, mit <kbd>Umschalt</kbd> in größeren Schritten; <kbd>D</kbd> dupliziert, <kbd>Entf</kbd> löscht.",
    elsewhere:
      "Ein Rätsel, das du verändert hast, stellt sich das Modell etwa so gut vor wie das ursprüngliche. Ähnelt ein Rätsel keiner der 25 Arten, rät das Modell, das sie alle kennt, meistens nur. Das andere kommt besser zurecht: An zufälligen Rätseln hat es gelernt, Kugeln einzuschätzen.",
    imagined: "Was sich das Modell vorstellt",
    check: "Ist es lösbar?",
    trying: "Probiert",
    reveal: "Zeig die einfachste Lösung",
    yours: "Dein Rätsel",
    name: "Name",
    keep: "In diesem Browser speichern",
    save: "Als Datei speichern",
    link: "In der Adresse dieser Seite steckt das ganze Rätsel: Kopier den Link, und wer ihn öffnet, spielt, was du gebaut hast.",
  },

  sizes: SIZES,

  bodies: {
    none: "Nichts ist gewählt.",
    name: (body, index) => aBody(body) + (index === null ? "" : ` (Körper ${index})`),
    described: (name, { x, y, degrees }, sizes, moves) =>
      `${upper(name)}: x ${decimal(x)}; y ${decimal(y)}; um ${decimal(degrees)} Grad gedreht; ` +
      `${sizes.map(([size, value]) => `${SIZES[size]} ${decimal(value)}`).join("; ")}; ${moves ? "beweglich" : "fest"}.`,
  },

  check: {
    search: "Nach Lösungen suchen",
    stop: "Anhalten",
    blocked: "Behebe zuerst, was oben steht: Dann lässt sich nach Lösungen suchen.",
    solvesItself: "Die Szene löst sich von selbst, ganz ohne Kugel.",
    found: (solved, valid, ended) =>
      `Es ist lösbar: Von ${tried(valid, ended)} ${solved === 1 ? "löst es eine" : `lösen es ${number(solved)}`} (${share(solved / valid)}).`,
    none: (valid, ended) => `Unter ${tried(valid, ended)} ist keine Lösung.`,
    harder: (rank) => `Schwerer als deins: ${percent(rank)} der Rätsel des Benchmarks.`,
    between: "Eine Kugel zwischen denen des Rasters könnte es trotzdem lösen.",
    easiest: (x, y, r) =>
      `Die einfachste Lösung ist eine Kugel bei x ${decimal(x)} und y ${decimal(y)} mit Radius ${decimal(r)}. Sie liegt jetzt in der Szene: Drück auf „Fallen lassen“.`,
  },

  problems: {
    unreadable: (why) => `Diese Szene kann Pathlight nicht lesen. (${why})`,
    ownGoal: "Das grüne Objekt kann nicht sein eigenes Ziel sein: Wähl einen anderen Körper als Ziel.",
    staticObject: "Das grüne Objekt ist fest und kommt nie ans Ziel: Mach es beweglich oder wähl ein anderes.",
    bodies: (least, most, tooMany) =>
      `Eine Szene hat ${least} bis ${most} Körper, diese hat ${tooMany ? "mehr: Lösch einige" : "weniger: Füg welche hinzu"}.`,
    name: (most) => `Der Name hat mehr als ${most} Zeichen: Kürze ihn.`,
    place: (body) =>
      `${upper(indexed(body))} ${verb(body, "hat", "haben")} keinen Ort: x und y müssen Zahlen sein, und der Winkel muss zwischen −2π und 2π liegen.`,
    length: (body, size, length, [least, most]) =>
      `${upper(indexed(body))}: ${SIZES[size]} ${px(length)} px, erlaubt sind ${decimal(least)} bis ${decimal(most)}. ` +
      `Mach das ${length > most ? "kleiner" : "größer"}.`,
    sticksOut: (body, by) =>
      `${upper(indexed(body))} ${verb(body, "ragt", "ragen")} ${px(by)} px aus der Szene heraus: Schieb den Körper hinein oder mach ihn kleiner.`,
    sticksOutOfCorner: (body, by) =>
      `${upper(indexed(body))} ${verb(body, "ragt", "ragen")} an einer Ecke ${px(by)} px aus der Szene heraus: Schieb den Körper hinein oder mach ihn kleiner.`,
    outside: (body, by) =>
      `${upper(indexed(body))} ${verb(body, "liegt", "liegen")} ${px(by)} px außerhalb der Szene: Schieb den Körper näher oder lösch ihn.`,
    overlap: (body, other, by, most) =>
      `${upper(indexed(body))} und ${indexed(other)} überschneiden sich um ${px(by)} px, mehr als ${decimal(most)}: Schieb sie auseinander.`,
  },

  live: {
    notYet: "noch nicht vorgestellt",
    solvesItself: "Ohne Kugel löst sich die Szene von selbst: Es bleibt nichts zu tun.",
    ends: (x, y) => `Ohne Kugel landet das grüne Objekt bei x ${number(x)}, y ${number(y)}.`,
  },

  file: {
    attempts: (name) =>
      `${name} ist eine Datei mit Versuchen, nicht mit Rätseln: Öffne ein Rätsel und dann die Datei mit „Versuche öffnen“. Hier bleibt alles, wie es war.`,
    foreign: (name) => `${name} ist keine Datei mit Rätseln aus Pathlight. Hier bleibt alles, wie es war.`,
    tooLarge: (name, megabytes) =>
      `${name} ist größer als ${megabytes} MB. Teil die Datei auf. Hier bleibt alles, wie es war.`,
    empty: (name) => `In ${name} ist kein Rätsel.`,
    unplayable: (name, place, why) =>
      `${place === null ? name : `Rätsel ${number(place)} aus ${name}`} lässt sich nicht spielen: ${why} Hier bleibt alles, wie es war.`,
  },

  link: {
    damaged:
      "In diesem Link steckt ein selbst gebautes Rätsel, aber es ist beschädigt: Vielleicht fehlt ein Teil. Lass dir den Link noch einmal schicken.",
    unplayable: (why) => `In diesem Link steckt ein selbst gebautes Rätsel, das sich nicht spielen lässt: ${why}`,
  },

  kept: (name) =>
    `„${name}“ ist in diesem Browser gespeichert: Du findest es auf der Startseite unter „Deine eigenen Rätsel“.`,
};

/**
 * @param {number} balls
 * @param {boolean} ended
 */
function tried(balls, ended) {
  return `${ended ? "" : "bisher "}${counted(balls, "Kugel", "Kugeln")}`;
}

/** @param {number} fraction */
function share(fraction) {
  return fraction < 0.001 ? "weniger als eine von tausend" : percent(fraction, fraction < 0.01 ? 1 : 0);
}

/** @param {import("../en/editor.js").IndexedBody} body */
function indexed(body) {
  return `${theBody(body)} (Körper ${body.index})`;
}

/**
 * Sticks are plural.
 * @param {import("../en/editor.js").IndexedBody} body
 * @param {string} one
 * @param {string} more
 */
function verb({ shape }, one, more) {
  return shape === "standing_sticks" ? more : one;
}

/**
 * A length; one that is far too large as a power of ten.
 * @param {number} length
 */
function px(length) {
  return Math.abs(length) < 1e5 ? number(length, 1) : length.toExponential(0);
}
