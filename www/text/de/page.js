// The German words for en/page.js.

import { counted, number, percent } from "./format.js";

const MONTHS = [
  "Januar",
  "Februar",
  "März",
  "April",
  "Mai",
  "Juni",
  "Juli",
  "August",
  "September",
  "Oktober",
  "November",
  "Dezember",
];

const attempts = (/** @type {number} */ count) => counted(count, "Versuch", "Versuche");
/** „in 3 Versuchen“. */
const inAttempts = (/** @type {number} */ count) => `in ${counted(count, "Versuch", "Versuchen")}`;
const puzzles = (/** @type {number} */ count) => counted(count, "Rätsel", "Rätsel");
const notLoaded = (/** @type {string} */ part) =>
  `${part} ließ sich nicht laden. Prüf die Verbindung; falls Pathlight inzwischen aktualisiert wurde, lade die Seite neu.`;

/** @type {typeof import("../en/page.js").page} */
export const page = {
  name: "Pathlight",
  description:
    "Setz eine rote Kugel so, dass das grüne Objekt sein Ziel berührt, und schau zu, wie sich eine winzige KI vorstellt, was passiert.",
  title: (shown) => `${shown} – Pathlight`,
  views: { results: "Ergebnisse", learns: "Es lernt, während du zuschaust" },
  day: (date) => `${date.getDate()}. ${MONTHS[date.getMonth()]} ${date.getFullYear()}`,

  header: {
    skip: "Direkt zur Szene",
    puzzle: "Rätsel",
    previous: "Voriges Rätsel",
    previousKey: "Voriges Rätsel  [",
    which: "Welches der 100 Rätsel",
    next: "Nächstes Rätsel",
    nextKey: "Nächstes Rätsel  ]",
    random: "Zufälliges Rätsel",
    share: "Teilen",
    presentation: "Präsentation: die Szene und ein Satz, in großer Schrift",
    presentationKey: "Präsentation  V",
    about: "Über Pathlight",
    keys: "Tasten",
    keysKey: "Tasten  ?",
  },

  picker: {
    puzzle: (task) => `Rätsel ${task}`,
    place: (place, of) => `${place} von ${of}`,
    solved: (place, at) => `${place}: gelöst im ${at}. Versuch`,
    tried: (place, made) => `${place}: ungelöst, ${attempts(made)}`,
  },

  links: {
    all: "Alle Rätsel",
    first: (kind) => `Das erste Rätsel von „${kind}“`,
    noPuzzle: (task) => `Dieser Link führt zu Rätsel ${task}, aber das gibt es nicht.`,
    hidesAll: "Dieser Link nennt kein Rätsel und blendet die Liste der Rätsel aus.",
    copied: "Der Link zu dem, was du siehst, ist kopiert.",
    notCopied: (link) => `Dieser Browser erlaubt der Seite nicht, etwas zu kopieren. Der Link ist ${link}`,
  },

  broken: {
    crash: (reason) => `In Pathlight ist etwas kaputtgegangen: ${reason}. Lade die Seite neu, dann geht es weiter.`,
    reload: "Neu laden",
    noCanvas:
      "Dieser Browser gibt der Seite keine Fläche zum Zeichnen: Vielleicht ist sein Speicher voll. Schließ andere Tabs und lade die Seite neu.",
  },

  notLoaded: {
    results: notLoaded("Die Seite mit den Ergebnissen"),
    learns: notLoaded("Dieser Teil der Seite"),
    share: notLoaded("Das Fenster zum Teilen"),
  },

  files: {
    several: (count) => counted(count, "Datei", "Dateien"),
    reading: (name, done) => `Einlesen: ${name}, ${percent(done)}`,
    stop: "Anhalten",
    stopped: (name) => `Abgebrochen: ${name}. Hier bleibt alles, wie es war.`,
    failed: (name) =>
      `Nicht lesbar: ${name}. Vielleicht wurde etwas verschoben oder geändert: Wähl es noch einmal aus. Hier bleibt alles, wie es war.`,
    tooLarge: (name, megabytes) =>
      `${name} ist größer als ${megabytes} MB. Teil die Datei auf. Hier bleibt alles, wie es war.`,
  },

  progress: {
    save: "Als Datei speichern",
    saveAll: "Alles als Datei speichern",
    forget: "Fortschritt vergessen",
    read: "Fortschritt aus einer Datei einlesen",
    file: "Eine Datei mit Fortschritt",
    soFar: (tried, solved, made) =>
      `Bisher hast du ${puzzles(tried)} probiert und ${number(solved)} gelöst, ${inAttempts(made)}.`,
    custom: (tried, solved, made) =>
      `Von deinen eigenen Rätseln hast du ${number(tried)} probiert und ${number(solved)} gelöst, ${inAttempts(made)}.`,
    ofKind: (solved, of, made) => `${solved ? "✓" : "×"} ${solved} von ${of} gelöst, ${inAttempts(made)}`,
    forbidden: "Dieser Browser lässt die Seite nichts speichern: Wenn du sie schließt, ist dein Fortschritt weg.",
    full: (made) =>
      made
        ? `Dieser Browser hat keinen Platz mehr: ${counted(made, "Versuch geht", "Versuche gehen")} verloren, wenn du ${made === 1 ? "ihn" : "sie"} nicht als Datei speicherst, bevor du die Seite schließt.`
        : "Dieser Browser hat keinen Platz mehr: Die letzten Änderungen sind weg, wenn du die Seite schließt.",
    readBack: (count, made) => `Eingelesen: ${puzzles(count)} mit ${counted(made, "Versuch", "Versuchen")}.`,
    added: (made, solved) => `Neu hier: ${attempts(made)}, ${counted(solved, "gelöstes Rätsel", "gelöste Rätsel")}.`,
    left: (made, most) =>
      `${counted(made, "Versuch bleibt", "Versuche bleiben")} nur in der Datei: Dieser Browser speichert je Spieler 100 an einem Rätsel, ${number(1000)} an eigenen Rätseln und insgesamt ${number(most)}.`,
    unread: (lines) => `Nicht gelesen: ${counted(lines, "Zeile", "Zeilen")} ohne gültigen Versuch.`,
    undo: "Rückgängig",
    gone: "Rückgängig gemacht: Dein Fortschritt ist wieder wie vorher.",
  },

  forget: {
    title: "Deinen Fortschritt vergessen?",
    words:
      "Dieses Gerät weiß dann nicht mehr, welche Rätsel du probiert und gelöst hast, und kennt auch deine Versuche nicht mehr. Auch das Modell vergisst sie. Das lässt sich nicht rückgängig machen.",
    keep: "Behalten",
    forget: "Vergessen",
  },

  custom: {
    title: "Deine eigenen Rätsel",
    empty:
      "Noch keine. Öffne irgendein Rätsel, drück auf „Bauen“ und bau es um. Deine Rätsel kannst du hier speichern, und wer den Link hat, kann sie spielen.",
    open: "Datei öffnen",
    saveAll: "Alle als Datei speichern",
    files: "Dateien mit Rätseln",
    hidden: "Dieser Link zeigt nur ein Rätsel, darum wird hier keine Datei geöffnet.",
    remove: "Löschen",
    removeNamed: (name) => `${name} löschen`,
    removed: (name) => `„${name}“ ist gelöscht.`,
    undo: "Rückgängig",
    back: (name) => `„${name}“ ist wieder da.`,
    kept: (count) =>
      count === 1
        ? "Ein Rätsel ist gespeichert: Du findest es unter „Deine eigenen Rätsel“."
        : `${number(count)} Rätsel sind gespeichert: Du findest sie unter „Deine eigenen Rätsel“.`,
    known: (count) => (count === 1 ? "Eines war schon da." : `${number(count)} waren schon da.`),
    left: (count, most) =>
      `Kein Platz für ${number(count)} davon: Die Seite speichert höchstens ${number(most)} Rätsel. Lösch zuerst einige; in der Datei geht nichts verloren.`,
    solved: (made) => `✓ gelöst, ${inAttempts(made)}`,
    missed: (made) => `× nicht gelöst, ${inAttempts(made)}`,
  },

  widgets: { close: "Schließen", mostly: (difficulty) => `meist ${difficulty}` },
};
