// The German words for en/play.js.

import { counted, number, seconds } from "./format.js";
import { sentence, upper } from "../sentence.js";
import { theBody } from "./puzzles.js";

/** @param {number} value */
const decimal = (value) => number(value, 2, { minimumFractionDigits: 0 });

const tries = (/** @type {number} */ count) => counted(count, "Versuch", "Versuchen");

/** In the dative, as most endings need it. */
const MOMENT = "einem Augenblick";

/** @type {typeof import("../en/play.js").play} */
export const play = {
  run: { drop: "Fallen lassen", run: "Los", pause: "Pause", replay: "Nochmal", goOn: "Weiter" },
  skipQuiet: "Nichts rührt sich: weiter",
  time: (time) => seconds(time),
  spokenTime: (time) => `${number(time, 1)} Sekunden`,
  meter: (time, goal) => `${number(time, 1)} von ${goal} s`,
  spokenMeter: (time, goal) => `${number(time, 1)} von ${goal} Sekunden`,

  ending: {
    solved: (time) => `gelöst nach ${time}`,
    never: "nie berührt",
    touching: (time) => `seit ${time} berührt, als die Zeit um war`,
    lost: (time) => `${time === MOMENT ? "einen Augenblick" : time} lang berührt, dann verloren`,
    moment: MOMENT,
  },

  status: {
    watched: "Das war die Szene ohne Kugel.",
    watching: "Die Szene ohne Kugel.",
    tries: (attempt) => `Das Modell probiert: Versuch ${attempt}.`,
    named: (author, attempt, preview) =>
      author === "file"
        ? "Der geöffnete Versuch"
        : preview
          ? `${author === "player" ? "Deine Kugel" : "Kugel"} ${attempt}${author === "player" ? "" : " des Modells"}`
          : upper(whose(author, attempt)),
    running: (named) => `${named} läuft.`,
    solved: (named, ending) => `Gelöst! ${named}: ${ending}.`,
    missed: (named, ending, still) => `Nicht gelöst. ${named}: ${ending}${still ? "; alles liegt still" : ""}.`,
    closest: (gap, time) =>
      time < 0.05 ? "kam nie näher heran" : `um ${number(gap, gap < 9.95 ? 1 : 0)} px verfehlt, nach ${seconds(time)}`,
    line: "Zeichne in die Szene, welche Bahn das grüne Objekt nehmen wird.",
    bodies: "Zieh an einem Körper oder an einem Griff des gewählten.",
    noBall: "Klick oder tipp in die Szene, um die rote Kugel zu setzen.",
    notHere: (why) => `Hier nicht: ${sentence(why)}`,
    ready: "Bereit. Lass die Kugel fallen!",
  },

  invalid: {
    overlaps: (body) => `die Kugel überschneidet sich mit ${theBody(body, "dative")}`,
    outside: "die Kugel ist zu nah am Rand",
    radius: "der Radius der Kugel muss zwischen 2 und 32 px liegen",
  },

  refusal: {
    invalid: (why) => `${sentence(why)} Das zählt nicht als Versuch.`,
    limit: (limit) =>
      `Alle ${limit} Versuche sind verbraucht: Lösch sie, um neu zu beginnen. Das zählt nicht als Versuch.`,
    noPrediction: "Zeichne zuerst deine Vorhersage: die Bahn des grünen Objekts.",
    noBall: "Setz zuerst die Kugel: Klick oder tipp in die Szene, oder drück dort eine Pfeiltaste.",
  },

  pair: {
    solved: "Gelöst!",
    missed: "Nicht gelöst.",
    both: "Beide haben es gelöst.",
    neither: "Keiner hat es gelöst.",
    player: "Du hast es gelöst, das Modell nicht.",
    model: "Das Modell hat es gelöst, du nicht.",
    result: (author, attempt, dashed, ending) =>
      `${whose(author, attempt)}${dashed ? " (gestrichelt)" : ""}: ${ending}`,
    running: (first, second) => `übereinander: ${whose(...first)} und, gestrichelt, ${whose(...second)}`,
    alone: (author, attempt) =>
      `${whose(author, attempt)}; ${author === "player" ? "das Modell hat" : "du hast"} noch keinen gemacht`,
  },

  verdict: {
    playerQuicker: (you, it) => `Du hast es im ${you}. Versuch gelöst, das Modell im ${it}. Du warst schneller.`,
    modelQuicker: (you, it) => `Das Modell hat es im ${it}. Versuch gelöst, du im ${you}. Das Modell war schneller.`,
    draw: (at) => `Du und das Modell habt es beide im ${at}. Versuch gelöst. Unentschieden.`,
    modelNext: (you) => `Du hast es im ${you}. Versuch gelöst. Das Modell war noch nicht dran.`,
    modelMissed: (you, made) =>
      `Du hast es im ${you}. Versuch gelöst. Das Modell hat es in ${tries(made)} nicht geschafft.`,
    playerNext: (it) => `Das Modell hat es im ${it}. Versuch gelöst. Jetzt bist du dran: Du hast noch nichts probiert.`,
    playerMissed: (it, made) =>
      `Das Modell hat es im ${it}. Versuch gelöst. Du hast es in ${tries(made)} noch nicht geschafft.`,
    nobody: "Noch hat es niemand probiert.",
    neither: (you, it) =>
      `Noch nicht gelöst: ${counted(you, "Versuch", "Versuche")} von dir, ${counted(it, "Versuch", "Versuche")} vom Modell.`,
  },

  attempts: {
    solved: (at) => `gelöst im ${at}. Versuch`,
    missed: (made, limit) => `${made} von ${limit}, nicht gelöst`,
    replay: (x, y, r) => `Noch einmal: Kugel bei x ${decimal(x)}; y ${decimal(y)}; Radius ${decimal(r)}`,
    compare: (attempt) => `Versuch ${attempt} vergleichen`,
    remove: (attempt) => `Versuch ${attempt} löschen`,
  },

  afterSolving: {
    title: (at) => (at === 1 ? "Gelöst im ersten Versuch!" : `Gelöst in ${at} Versuchen!`),
    challenge: {
      asked: (at) => `Eine Herausforderung: Jemand hat dieses Rätsel ${within(at)} gelöst. Schaffst du das auch?`,
      beaten: (at) => `Du warst schneller: In der Herausforderung war es ${within(at)} gelöst.`,
      equal: "Du warst genauso schnell wie in der Herausforderung.",
      missed: (at) => `Du hast länger gebraucht: In der Herausforderung war es ${within(at)} gelöst.`,
    },
  },

  guide: {
    watch: {
      words: (time) =>
        `Das grüne Objekt soll ${time} Sekunden lang sein gestreiftes Ziel berühren. Schau erst einmal, was ohne Hilfe passiert.`,
      button: "Zuschauen",
    },
    watching: { words: () => "Niemand hilft. Achte auf das grüne Objekt.", button: null },
    guess: {
      words: () =>
        "Allein kommt es nie ans Ziel. Setz eine rote Kugel dazu: Wo würde sie helfen? Klick oder tipp dorthin.",
      button: null,
    },
    blocked: { words: () => "Die Kugel braucht einen freien Platz.", button: null },
    drop: {
      words: () =>
        "Dort passt sie hin. Die gepunktete Linie ist die Vermutung des Modells für deine Kugel. Verschieb die Kugel, bis es dir gefällt, und lass sie dann fallen.",
      button: "Fallen lassen",
    },
    dropped: { words: () => "Jetzt greift niemand mehr ein.", button: null },
    missed: {
      words: () =>
        "Noch nicht: So enden die meisten Versuche. Verschieb die Kugel und lass sie noch einmal fallen, oder sieh, wie das Modell es macht.",
      button: "Gegen das Modell",
    },
    solved: { words: () => "Gelöst! Braucht das Modell weniger Versuche als du?", button: "Gegen das Modell" },
    race: {
      words: () => "Das Modell probiert am selben Rätsel seine eigenen Kugeln. Wer weniger Versuche braucht, gewinnt.",
      button: "Fertig",
    },
  },
  guideCount: (step, steps) => `${step} von ${steps}`,

  panel: {
    next: "Nächstes Rätsel",
    share: "Teilen",
    nextBy: "Als Nächstes:",
    similar: "ein ähnliches",
    harder: "ein schwereres",
    easier: "ein leichteres",
    race: "Du gegen das Modell",
    you: "Du",
    model: "Das Modell",
    skip: "Gleich zum Ergebnis",
    raceIt: "Wettlauf",
    remembers: "Das Modell erinnert sich",
    forget: "Vergessen",
    score:
      "Je weniger Versuche, desto mehr Punkte: Ein Rätsel, das im ersten Versuch gelöst ist, gibt 100, im zweiten 85, im zehnten 50; eines, das in 100 Versuchen nicht gelöst wird, gibt keine. Die Punkte sind das Mittel über alle Rätsel, die beide gespielt haben. Kugeln, die nicht gesetzt werden dürfen, zählen nicht, für keinen von beiden. Das ist AUCCESS, das Maß des Benchmarks: der Anteil der Rätsel, die in k Versuchen gelöst sind, wobei jedes k von 1 bis 100 mit ln(k + 1) − ln(k) gewichtet wird.",
    dotted: "Was sind die gepunkteten Linien?",
    dottedHow:
      "Die Vermutung des Modells, noch bevor sich etwas bewegt: welche Bahnen diese Kugel und Grün nehmen würden. Je breiter das Band um eine Linie, desto unsicherer ist sich das Modell. Es ist eine Vermutung, keine Simulation, und kann falsch sein: Lass die Kugel fallen und sieh, wie weit das Modell danebenlag.",
    radius: "Radius",
    placements: "Platzierungen",
    undo: "Rückgängig",
    redo: "Wiederholen",
    hint: `Tipp oder klick in die Szene, um die Kugel zu setzen; zieh sie, um sie zu verschieben. Ihre Größe änderst du an ihrem Griff<span class="with-mouse"> oder mit dem Mausrad</span>. <span class="with-mouse">Mit Tasten: Pfeile, <kbd>+</kbd> und <kbd>−</kbd>.</span>`,
    watch: "Ohne Kugel zuschauen",
    yourAttempts: "Deine Versuche",
    modelAttempts: "Die des Modells",
    luck: "Glück oder Plan?",
  },
};

/**
 * @param {import("../../pkg/pathlight.js").Author} author
 * @param {number} attempt
 */
function whose(author, attempt) {
  return author === "player" ? `dein Versuch ${attempt}` : `Versuch ${attempt} des Modells`;
}

/** @param {number} attempts */
function within(attempts) {
  return attempts === 1 ? "im ersten Versuch" : `in ${tries(attempts)}`;
}
