// The German words for en/sharing.js.

import { counted } from "./format.js";

/** @type {typeof import("../en/sharing.js").sharing} */
export const sharing = {
  title: "Teilen",
  copyLink: "Link zu dem kopieren, was du siehst",
  lessonLink: "Link für den Unterricht",
  noBall: "Der Link im Text verrät nicht, wo deine Kugel lag.",
  system: "Teilen …",
  copy: "Text und Link kopieren",
  savePicture: "Bild speichern",
  saveFilm: "Film speichern",
  film: "Film aufnehmen",
  stop: "Aufnahme abbrechen",
  recording: "Aufnahme",
  close: "Schließen",

  showPaths: "Meine Bahn und die des Modells im Bild zeigen",
  showBall: "Meine Kugel im Bild zeigen",

  ask: (puzzle) => `„${puzzle}“: Kannst du das lösen?`,
  day: (day, puzzle) => `Pathlight, ${day}: ${puzzle}`,
  solved: (puzzle, at) =>
    `Ich habe das Pathlight-Rätsel „${puzzle}“ ${at === 1 ? "im ersten Versuch" : `in ${at} Versuchen`} gelöst.`,
  match: "Schaffst du das auch?",
  better: "Schaffst du es schneller?",
  modelSolved: (at, remembers) =>
    `Das Modell${remembers ? " mit Gedächtnis" : ""}: ${counted(at, "Versuch", "Versuche")}.`,
  modelMissed: (made, remembers) =>
    `Das Modell hat es${remembers ? " mit Gedächtnis" : ""} in ${counted(made, "Versuch", "Versuchen")} nicht gelöst.`,

  card: {
    solved: (at) => (at === 1 ? "Gelöst im ersten Versuch" : `Gelöst in ${at} Versuchen`),
    ask: "Kannst du das lösen?",
    dashed: "Gestrichelt: seine Bahn.",
    alt: (puzzle, solved, model) => `${puzzle}. ${solved}. ${model}`,
  },

  done: {
    film: (withBall) => `Der Film ist da: Speichere ihn oder teil ihn.${withBall ? " Er zeigt deine Kugel." : ""}`,
    filmStopped: "Die Aufnahme wurde abgebrochen.",
    filmFailed: "Dieser Browser konnte den Film nicht aufnehmen. Das Bild lässt sich speichern.",
    shareFailed: "Dieser Browser konnte nichts teilen. Kopier den Text oder speichere das Bild.",
    copied: "Text und Link sind kopiert.",
    pictureSaved: "Das Bild ist gespeichert.",
    filmSaved: "Der Film ist gespeichert.",
  },

  lesson: {
    title: "Link für den Unterricht",
    panels: "Reiter und ihre Teile",
    others: "Das kann die Klasse benutzen",
    begins: "So fängt es an",
    presentation: "Als Präsentation, für einen Beamer",
    ball: "Mit der Kugel, die jetzt gesetzt ist",
    link: "Der Link",
    copy: "Kopieren",
    copied: "Der Link ist kopiert.",
    notCopied:
      "Dieser Browser erlaubt der Seite nicht, etwas zu kopieren: Die Adresse ist markiert, kopier sie mit den Tasten oder dem Menü.",
    ownMachine:
      "Dieser Link funktioniert nur auf diesem Computer: Stell die Seite dort bereit, wo andere sie erreichen.",
    code: "Der Link als QR-Code",
    noCode: (why) => `Es gibt keinen QR-Code: ${why}. Die Adresse oben funktioniert auch ohne ihn.`,
    end: "Wer den Link öffnet, sieht nicht, was du weggelassen hast. Im Link steckt alles: Sonst wird nirgends etwas gespeichert.",
    close: "Schließen",
    parts: {
      compare: "Der Wettlauf gegen das Modell",
      story: "Der Satz, der sagt, was passiert und was zu tun ist",
      hint: "Wie man die Kugel setzt",
      fields: "Regler und Zahlen der Kugel, Rückgängig und Wiederholen",
      watch: "Der Knopf, der die Szene ohne Kugel laufen lässt",
      attempts: "Die Liste der Versuche",
      save: "Der Knopf, der alle Karten als ein Bild speichert",
      forecast: "Die Vermutung des Modells",
      transport: "Die Zeitleiste und einzelne Schritte",
      speed: "Das Tempo",
      puzzles: "Die Links zu anderen Rätseln",
      tools: "Die Knöpfe oben",
    },
  },
};
