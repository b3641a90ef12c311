// The German words for en/element.js.

import { list } from "./format.js";

/** @type {typeof import("../en/element.js").element} */
export const element = {
  insideOf: { imagine: "Die Geschichte" },
  panels: {
    play: "Spielen",
    imagine: "Vorstellen",
    compare: "Die Kugeln des Modells, eine nach der anderen",
    predict: "Vorhersagen",
    map: "Nachprüfen",
    make: "Bauen",
  },
  tabs: "Reiter",
  parts: "Teile",
  close: "Schließen",
  tryAgain: "Noch einmal versuchen",

  puzzle: (name, task) => `Rätsel ${name} ${task ?? ""}`.trim(),
  noPuzzle: (task) => `Ein Rätsel ${task} gibt es nicht.`,
  noPanels: "Ein Teil dieses Rätsels ließ sich nicht laden. Prüf die Verbindung und lade die Seite neu.",
  unread: (attributes) => `Dieses Rätsel ist mit ${list(attributes)} eingebunden. Das versteht Pathlight nicht.`,

  style: {
    missing: (why, address) =>
      `Das Stylesheet von Pathlight ließ sich nicht laden (${why}, ${address}). Bau oder installier Pathlight neu.`,
    unreachable: (why, address) =>
      `Das Stylesheet von Pathlight ließ sich nicht laden (${why}, ${address}). Prüf die Verbindung und versuch es noch einmal.`,
  },

  scene: {
    role: "Rätselszene",
    playback: "Ablauf",
    step: "Ein Schritt",
    time: "Zeit",
    speed: "Tempo",
    back: "Kugel neu setzen",
    reset: "Zurücksetzen",
    seeIt: "Ansehen",
    closest: "Zeigt den Moment, in dem das grüne Objekt seinem Ziel am nächsten war",
    touched: "Wie lange das grüne Objekt sein Ziel schon berührt",
    guess: "Vermutung des Modells",
    introduction: "Einführung",
    leaveIntroduction: "Einführung beenden",
    takeOff: "Karten ausblenden",
  },

  story: { label: "Geschichte", back: "Zurück", next: "Weiter", leave: "Alles zeigen" },

  more: {
    title: "Mehr",
    ball: "Kugel",
    model: "Modell",
    opacity: "Deckkraft",
    saveMaps: "Alle Karten als ein Bild speichern",
    trained: "Wie wurde es trainiert?",
    attempts: "Versuche",
    saveAttempts: "Versuche speichern",
    openAttempts: "Versuche öffnen",
    attemptsFile: "Eine Datei mit Versuchen",
    clearAttempts: "Versuche löschen",
    saveBalls: "Kugeln des Modells als CSV speichern",
    pair: "Zwei Modelle nebeneinander",
    playBoth: "Beide spielen lassen",
    second: "Zweites Modell",
    map: "Karte",
  },

  keys: {
    title: "Tasten",
    ctrl: "Strg",
    space: "Leertaste",
    to: "bis",
    move: "in der Szene: die Kugel um 1 verschieben, mit <kbd>Umschalt</kbd> um 10",
    resize: "in der Szene: die Kugel größer, kleiner machen",
    undo: "eine Platzierung rückgängig machen, wiederholen",
    run: "los, Pause, weiter",
    step: "einen Schritt vor, einen zurück",
    reset: "die Kugel neu setzen",
    puzzles: "voriges, nächstes Rätsel",
    outcome: "bei den Kugeln des Modells: die nächste mit einem anderen Ergebnis, mit <kbd>Umschalt</kbd> die vorige",
    presentation: "die Präsentation: die Szene und ein Satz, in großer Schrift; <kbd>Esc</kbd> beendet sie",
    story: "<kbd>←</kbd> <kbd>→</kbd> oder <kbd>Bild ↑</kbd> <kbd>Bild ↓</kbd> blättern durch die Geschichte",
    sheet: "diese Liste der Tasten",
  },

  about: {
    title: "Über Pathlight",
    rules:
      "Du bestimmst, wo eine rote Kugel startet. Danach greift niemand mehr ein: Kugeln fallen und rollen, Balken kippen, und alles stößt gegen alles andere.",
    sameRules: "Das Modell spielt nach denselben Regeln, im selben Simulator.",
    thinks: "Wie das Modell denkt",
    training: "Wie es trainiert wurde",
    trained:
      "Niemand hat ihm die Gesetze der Bewegung erklärt. Seine Kartennetze bekamen gelöste Rätsel zu sehen: die Szene, die Bahn, die das grüne Objekt von selbst nimmt, die Bahnen von Grün und der roten Kugel in der Lösung und den Ort, an dem diese Kugel startete. Jedes Mal wurden alle ihre Zahlen ein wenig verändert, damit die nächsten Karten besser passen.",
    noModel: "Kein Modell ist geladen.",
    sources: "Woher die Ideen kommen",
    paper: `Die Netze: Augustin Harter, Andrew Melnik, Gaurav Kumar, Dhruv Agarwal, Animesh Garg und Helge Ritter, <a href="https://arxiv.org/abs/2011.07357">Solving Physics Puzzles by Reasoning about Paths</a> (2020).`,
    benchmark: `Die Rätsel: die 25 Arten mit einer Kugel aus <a href="https://phyre.ai">PHYRE</a>, einem Benchmark für physikalisches Denken von Anton Bakhtin und anderen (2019).`,
    local: "All das läuft in deinem Browser. Nichts von dem, was du hier tust, verlässt dein Gerät.",
    licences: `Pathlight ist freie Software unter der Apache-Lizenz 2.0, und viele andere haben mit ihrer Arbeit dazu beigetragen: <a id="licences" target="_blank">ihre Namen und Lizenzen</a>.`,
  },
};
