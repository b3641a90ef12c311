// The German words for en/panels.js.

import { counted, number, percent } from "./format.js";

/** @param {number} value */
const decimal = (value) => number(value, 2, { minimumFractionDigits: 0 });

/** @type {typeof import("../en/panels.js").panels} */
export const panels = {
  about: (name) => `Das Modell „${name}“:`,

  choice: {
    none: "Das Modell findet keine Kugel, die es probieren kann.",
    choosing: "Das Modell wählt aus.",
    ideas: (ideas, likely) =>
      `Es hat ${counted(ideas, "Kugel", "Kugeln")} erwogen und gibt ${likely > 1 ? number(likely) : likely ? "einer" : "keiner"}${ideas > 1 ? " davon" : ""} eine Chance von mehr als 50\u00a0%.`,
    running: "Gepunktet: was sich das Modell vorgestellt hat. Gestrichelt: was wirklich passiert.",
    ended: (solved, words) => (solved ? words : `Es hat nicht geklappt. ${words}`),
  },

  compare: {
    play: "Das Modell spielen lassen",
    stop: "Modell anhalten",
    played: "Das Modell hat gespielt",
    trying: "probiert …",
    notYet: "noch nicht",
    first: "Du zuerst: Lass eine Kugel fallen.",
    stopRace: "Anhalten",
    again: "Noch einmal ansehen",
    solved: (at) => `✓ im ${at}. Versuch`,
    missed: (used) => `noch nicht, ${counted(used, "Versuch", "Versuche")}`,
  },

  forecast: {
    loading: "Das Modell wird noch geladen.",
    guessing: "Das Modell überlegt.",
    guess: (chance) => `Vermutung des Modells: ${chance}.`,
    guessWas: (chance, ...sentences) => [`Das Modell hatte vermutet: ${chance}.`, ...sentences].join(" "),
  },

  imagine: {
    loading: "Das Modell wird geladen",
    play: "Abspielen",
    pause: "Pause",
    all: "Alle",
    back: "Zurück",
    next: "Weiter",
    how: "Wie?",
    outlines: "Über der Szene sind zwei Karten schattiert, von den anderen siehst du die Umrisse.",
    real: "Vorgestellt und wirklich",
    empty: `Lass eine Kugel fallen<span data-hideable="compare">, lass das Modell spielen</span> oder schau ohne Kugel zu: Dann siehst du hier, wie gut die Vorstellung war.`,
    numbers: "Was bedeuten die Zahlen?",
    numbersHow:
      "Die schattierte Fläche ist vorgestellt, die Umrisslinie zeigt, was wirklich passiert ist. 100\u00a0% heißt, dass beide gleich sind, 0\u00a0%, dass sie nichts gemeinsam haben. Es ist das Verhältnis von Schnitt und Vereinigung auf 64 × 64 Feldern: die Summe der jeweils kleineren Werte, geteilt durch die Summe der jeweils größeren.",
    noMap: "diese Karte hat das Modell nicht",
    notYet: "noch nicht vorgestellt",
    described: (name, words) => `${name}: ${words}`,
    inNumbers: (summary) => `In Zahlen: ${summary}.`,
    took: (milliseconds) => `In ${number(milliseconds)} ms vorgestellt.`,
  },

  imaginedVsReal: {
    green: "Grünes Objekt",
    red: "Rote Kugel",
    unknown: "unbekannt",
    run: (title, green, red) => `${title}: grünes Objekt ${green}${red === null ? "" : `, rote Kugel ${red}`}`,
    all: (runs) => `Wie vorgestellt – ${runs.join("; ")}.`,
    alone: "Ohne Kugel",
    opened: "Der geöffnete Versuch",
    ball: (ball) => `Kugel ${ball} des Modells`,
    attempt: (author, attempt) => (author === "player" ? `Dein Versuch ${attempt}` : `Versuch ${attempt} des Modells`),
  },

  model: {
    nets: (about) => `${about} Im Reiter „Vorstellen“ siehst du alle Karten und unter „Wie?“, was jedes Netz sieht.`,
    named: (name, knows) => `${name} ${knows}.`,
  },

  modelPair: {
    playing: "Beide Modelle spielen.",
    noMap: "diese Karte hat es nicht",
    watch: (ball) => `Seine Kugel ${ball} ansehen`,
    solved: (at) => `Gelöst im ${at}. Versuch.`,
    missed: (attempts) => `Nicht gelöst in ${counted(attempts, "Versuch", "Versuchen")}.`,
    guess: (chance) => `Seine eigene Vermutung zu seiner ersten Kugel: ${chance}.`,
    neither: "Keines der beiden Modelle löst dieses Rätsel.",
    only: (name) => `Nur ${name} löst dieses Rätsel.`,
    both: (at) => `Beide lösen es im ${at}. Versuch.`,
    quicker: (name, fewer, more) => `${name} braucht weniger Versuche: ${fewer} statt ${more}.`,
  },

  overlap: (name, share) => `${name}, und eine Linie um die wirkliche Bahn: Sie decken sich zu ${percent(share)}`,

  laid: { over: "Über der Szene", green: "Bahn von Grün, vermutet", red: "Bahn von Rot, vermutet" },

  predict: {
    intro:
      "Welchen Weg nimmt das grüne Objekt? Zeichne seine Bahn in die Szene. Lass es dann laufen und sieh, wer näher dran war: du oder das Modell.",
    watch: "Ohne Kugel laufen lassen",
    run: "Mit der Kugel laufen lassen",
    wipe: "Wegwischen",
    result: "Vorhersage und Wirklichkeit",
    measured: "Wie wird das gemessen?",
    measuredHow:
      "Deine Linie zählt so, als wäre das grüne Objekt an ihr entlanggeglitten. Was schattiert ist und was wirklich war, innerhalb der Umrisslinie, wird übereinandergelegt: 100\u00a0% heißt, dass beide gleich sind. Das Modell wird genauso gemessen: ohne Kugel an seiner Grundbahn, mit Kugel an seiner Zielbahn. Deine Kugel hat es nicht gesehen.",
    hint: "Zeichne mit der Maus oder dem Finger. Mit Tasten, in der Szene: Pfeile zeichnen vom grünen Objekt aus weiter, mit <kbd>Umschalt</kbd> in größeren Schritten; die <kbd>Rücktaste</kbd> nimmt ein Stück zurück.",
    ends: (x, y) => `Deine Linie endet bei x ${number(x)}, y ${number(y)}. Fertig? Dann lass es laufen.`,
    nothing: "Noch nichts gezeichnet.",
    you: "Du",
    model: "Das Modell",
    alone: (you) => `Du hattest zu ${you} recht.`,
    draw: (both) => `Unentschieden: Beide hatten zu ${both} recht.`,
    player: (you, it) => `Du warst näher dran: ${you}, das Modell ${it}.`,
    modelCloser: (you, it) => `Das Modell war näher dran: ${it}, du ${you}.`,
  },

  proposals: {
    back: "Vorige Kugel",
    next: "Nächste Kugel",
    which: "Welche Kugel des Modells",
    other: "Nächstes anderes Ergebnis",
    hint: "Das Modell hat bis zu hundert Kugeln bereit. Geh sie durch und sieh, woher jede kommt und was sie bewirkt.",
    afresh: "Das sind seine Kugeln ohne Gedächtnis.",
    why: "Warum diese",
    ball: "Kugel",
    outcome: "Ergebnis",
    imagined: "Vorgestellt",
    close: "Zurück zu deiner Kugel",
    noOther: (by) => `Keine Kugel ${by > 0 ? "nach" : "vor"} dieser hat ein anderes Ergebnis.`,
    none: "keine",
    place: (x, y, r) => `x ${decimal(x)}; y ${decimal(y)}; Radius ${decimal(r)}`,
    notTried: "Als das Modell dran war, hat es sie nicht probiert.",
    origin: {
      perturbed: (ball) => `Kugel ${ball}, zufällig verschoben.`,
      success: (chance) =>
        `Nach den Kugeln davor gibt das Erfolgsnetz dieser die beste Chance, das Rätsel zu lösen: ${percent(chance)}.`,
      uniform: "Zufall: Die Startkarte zeigt keinen Ort, an dem eine Kugel liegen darf.",
      map: (value, x, y) =>
        `Die Startkarte${value === null ? "." : `: Bei x ${x}, y ${y} hat sie den Wert ${number(value, 2)}.`} Von dort wurde die Kugel verschoben, um mehr von der Karte zu bedecken.`,
      likeliest: (chance) =>
        `Von allen noch nicht probierten Kugeln gab das Modell dieser die beste Chance, das Rätsel zu lösen: ${chance}.`,
      lowered: (before, failed, now) =>
        `Vor dem ersten Versuch gab das Modell dieser Kugel eine Chance von ${before}. Dann scheiterte Kugel ${failed}, die ähnlich startet oder Ähnliches bewirkt. Jetzt sind es ${now}, immer noch die beste Chance aller noch nicht probierten.`,
    },
  },

  remembers: {
    nothing: "Noch erinnert es sich an nichts. Ab jetzt lernt es aus dem, was ihr beide in diesem Browser probiert.",
    damaged: "Seine Erinnerungen waren beschädigt oder aus einer anderen Version, deshalb fängt es ohne welche an.",
    source: (mirrored) => ["Gelernt aus ", mirrored ? " (gespiegelt)." : "."],
    puzzle: (kind, place) => `„${kind}“ ${place}`,
    custom: (name) => (name === null ? "einem eigenen Rätsel" : `„${name}“`),
  },

  score: (puzzles, you, it) =>
    `${puzzles === 1 ? "Punkte in einem Rätsel" : `Punkte im Schnitt von ${number(puzzles)} Rätseln`}: du ${you}, das Modell ${it}`,

  solveMap: {
    intro:
      "Wo könnte die rote Kugel starten, damit das Rätsel gelöst wird? Der Computer probiert jeden Ort: zuerst grob, dann feiner.",
    trying: "Probiert",
    solves: "löst es",
    doesNot: "löst es nicht",
    noRoom: "kein Platz",
    compare: "Mit der Vermutung des Modells vergleichen",
    hint: "Der Radius ist der deiner Kugel. Jeder Ort wird im Hintergrund mit einer ganzen Simulation geprüft.",
    stop: "Anhalten",
    start: (radius) => `Jeden Ort mit Radius ${decimal(radius)} probieren`,
    tried: (progress, solving, invalid, radius) => {
      const [tried, about] =
        progress < 1 ? [`Bisher ${percent(progress)} probiert`, "etwa "] : ["Jeder Ort ist probiert", ""];
      return `${tried}: An ${rough(solving, about)} der Orte löst es eine Kugel mit Radius ${decimal(radius)}, und an ${rough(invalid)} ist kein Platz.`;
    },
    sides: (sides) => `Orte, an denen es klappt: ${sides}.`,
    agrees: (share) => `Das Modell legt ${percent(share)} seiner Startkarte auf solche Orte.`,
  },

  strip: {
    saved: "Das Bild ist gespeichert.",
    failed: "Dieser Browser konnte das Bild nicht erstellen.",
    puzzle: "Rätsel",
    ball: "Die Kugel",
    result: "Was passiert",
  },

  trouble: { otherModel: "Das Standardmodell nehmen" },

  walkthrough: {
    all: "Alle zusammen",
    step: (step, of) => `Schritt ${step} von ${of}`,
    dot: (step, name) => `Schritt ${step}: ${name}`,
    here: (words) => `In diesem Rätsel: ${words}.`,
  },

  of: (place, of) => `${place} von ${of}`,
};

/**
 * @param {number} share
 * @param {string} [about] before a rounded number
 */
function rough(share, about = "") {
  return share > 0 && share < 0.01 ? `weniger als ${percent(0.01)}` : about + percent(share);
}
