// The exhibits "Watch it learn" and "Results", which load their texts themselves.

import { ATTEMPT_LIMIT } from "../pkg/constants.ts";
import { formatsOf } from "./formats.ts";
import { puzzle } from "./de.ts";
import type { ExhibitText } from "./exhibits-en.ts";

const { counted, number, percent } = formatsOf("de", "unter 1\u00a0%");

const tries = (first: number | null) =>
  first === null ? `nicht mit ${ATTEMPT_LIMIT} Kugeln` : first === 1 ? "sofort" : `mit Kugel ${first}`;
const puzzles = (count: number) => `${number(count)} Rätsel`;

export const exhibits: ExhibitText = {
  number,
  percent: (share, decimals = 0) => `${number(100 * share, decimals)}\u00a0%`,
  kind: (template) => puzzle.name({ id: template, name: null }),
  back: "Pathlight: zu den Rätseln",
  retry: "Noch einmal versuchen",

  learns: {
    title: "Dem Modell beim Lernen zusehen",
    about:
      "Rätsel dieser Arten hat das Modell noch nie gesehen. Es spielt zwanzig einer Art nacheinander und merkt sich, was jede Kugel gezeigt hat. Daneben spielt dasselbe Modell ohne Gedächtnis. Das ist ein einzelner Durchgang in fester Reihenfolge, kein Mittelwert.",
    kinds: "Art von Rätseln",
    play: (count) => `${count} spielen lassen`,
    more: (count) => `Noch ${count} spielen lassen`,
    pause: "Pause",
    goOn: "Weiter",
    toTheEnd: "Bis zum Ende",
    forget: "Alles vergessen",
    fetching: (arrived) => `Das Modell wird geladen …${arrived === null ? "" : ` ${percent(arrived)}`}`,
    failed: (reason) => `Es kann gerade nicht spielen. ${reason}`,
    withMemory: "Mit Gedächtnis",
    without: "Ohne",
    scene: (who) => `Was das Modell probiert. ${who}`,
    ball: (at) => `Kugel ${at}`,
    ended: (first) => (first === null ? "Nicht gelöst" : first === 1 ? "Sofort gelöst" : `Gelöst mit Kugel ${first}`),
    chart: "Kugeln je Rätsel",
    chartLabel: "Kugeln je Rätsel, mit Gedächtnis und ohne; die Zahlen stehen in der Liste",
    key: { learned: "● mit Gedächtnis", fresh: "■ ohne", missed: "× nicht gelöst", trend: "— Verlauf über fünf" },
    axis: "Rätsel",
    list: "Rätsel für Rätsel",
    puzzle: (place) => `Rätsel ${place}`,
    played: (learned, fresh, helped) =>
      `${tries(learned)}${learned === null ? "" : " gelöst"}${helped}. Ohne Gedächtnis: ${tries(fresh)}.`,
    helped: (place, kind, { mirrored }) =>
      `, dank ${place ? `Rätsel ${place}` : `„${kind}“`}${mirrored ? " (gespiegelt)" : ""}`,
    total: (count, learned, fresh) =>
      `In diesem einen Durchgang brauchte es für ${puzzles(count)} mit Gedächtnis ${counted(learned, "Kugel", "Kugeln")}, ohne ${number(fresh)}.`,
    remembers: (count) => (count ? `Es erinnert sich an ${puzzles(count)}.` : "Noch erinnert es sich an nichts."),
    forgotten: "Es hat alles vergessen.",
  },

  results: {
    title: "Wie gut sind die Modelle?",
    about:
      "Hier stehen zweierlei Zahlen, die man nicht vergleichen darf: zuerst die beiden Modelle dieser Seite, gemessen auf je einer Aufteilung der Rätsel von PHYRE (du spielst gegen A; B spielt in „Dem Modell beim Lernen zusehen“); dann Agenten, die für jede der zehn Aufteilungen neu trainiert wurden, als Mittelwerte.",
    failed: (reason) => `Die Ergebnisse konnten nicht geladen werden: ${reason}.`,

    here: "Die Modelle dieser Seite, auf einer Aufteilung (Fold 0)",
    model: "Modell",
    models: { within: "A: mit allen 25 Arten trainiert", cross: "B: mit zufälligen Szenen trainiert" },
    agent: "Spielweise",
    agents: {
      online: "online: wie es hier spielt, es lernt aus Fehlversuchen",
      dynamics: "dynamics: dasselbe, ohne aus Fehlversuchen zu lernen",
      success: "success: das Erfolgsnetz allein",
      paper: "paper: die vier Netze des Fachartikels allein",
      random: "random: zufällige Kugeln",
    },
    auccess: "AUCCESS auf dieser einen Aufteilung",
    auccessHint: "0: nichts wird gelöst; 100: alles mit der ersten Kugel.",
    solved: (most) => (most === 1 ? "mit der ersten Kugel gelöst" : `mit höchstens ${most} Kugeln gelöst`),
    unseen: (count) => `${number(count)} Testrätsel, alle neu für das Modell.`,
    others: "Die anderen Spielweisen auf derselben Aufteilung:",
    sawMore: {
      within:
        "Sein Netz hat aus mehr gelernt als den Trainingsaufgaben von PHYRE: auch aus Rätseln derselben Arten, die PHYRE nicht aufführt. Vergleiche es also nicht mit veröffentlichten Agenten.",
      cross:
        "Sein Netz hat nur aus zufälligen Szenen gelernt, aus keiner Aufgabe von PHYRE; die vier Netze, die seine Karten zeichnen, kennen 20 Arten. Fold 0 ist eine der leichteren Aufteilungen.",
      paper: "Diese vier Netze haben nur aus den Trainingsaufgaben von PHYRE gelernt.",
      random: "Hier wird nichts gelernt.",
    },
    show: "Zeige",
    filters: {
      all: "alle Rätsel",
      failures: "nur nicht gelöste",
      late: "nicht gelöste, und solche mit mehr als zehn Kugeln",
      first: "mit der ersten Kugel gelöste",
    },
    cells: "Jede Zahl öffnet ihr Rätsel und sagt, welche Kugel es gelöst hat. × wurde nicht gelöst.",
    none: "Es gibt keine.",
    ofKind: (solved, of) => `${number(solved)} von ${number(of)} gelöst`,
    cell: (task, first) => `${task}, ${first === null ? "nicht gelöst" : `gelöst mit Kugel ${first}`}`,
    csv: "Alles als CSV speichern",

    calibration: "Wenn es 30\u00a0% sagt, klappt es dann in 30\u00a0% der Fälle?",
    calibrationAbout:
      "Von den Kugeln, denen das Modell 30\u00a0% gibt, sollten drei von zehn lösen. Unter der Diagonale verspricht es zu viel. Zufällige Kugeln sind beliebige, die man setzen darf; Kandidaten sind die, die das Modell in Betracht zieht.",
    calibrationLabel: "Angegebene Chance und Anteil, der löst; die Zahlen stehen in der Tabelle",
    random: "zufällige Kugeln",
    candidates: "Kandidaten",
    chance: "Chance",
    balls: "Kugeln",
    solve: "lösen",
    range: (from, to) => `${number(100 * from)} bis ${percent(to)}`,

    means: "Mittelwerte über alle zehn Aufteilungen, neben veröffentlichten",
    meansAbout:
      "AUCCESS, ± Standardabweichung über die Aufteilungen. Die meisten Netze wurden für jede Aufteilung neu und nur kurz trainiert, darum liegen diese Zahlen unter denen oben. Die meisten unserer Werte wurden in Version 3 des Simulators gemessen, die etwas anders rechnete als der von PHYRE. RAND, die Zeilen mit † oder ‡ und die Rätsel hier nutzen Version 4, die genauso rechnet.",
    within: "Bekannte Arten",
    cross: "Neue Arten",
    ours: "Unsere, Mittelwerte über zehn Aufteilungen",
    recipes: {
      tasks: "online, nur mit PHYREs Aufgaben trainiert",
      scenes: "online, mit mehr Szenen trainiert †",
      memory: "online, merkt sich alle Rätsel davor ‡",
      success: "das Erfolgsnetz, das sich nichts vorstellt",
      dqn: "DQN, kleiner",
      paper: "die vier Netze des Fachartikels",
      random: "RAND: PHYREs eigene Liste zufälliger Kugeln",
    },
    published: "Veröffentlicht, im Simulator von PHYRE",
    sawMoreMark:
      "† Bekannte Arten: auch Rätsel dieser Arten, die PHYRE nicht aufführt. Neue Arten: nur zufällige Szenen. Kein veröffentlichter Agent kennt sie.",
    memoryMark: "‡ Es behält für das nächste Testrätsel, was es beim vorigen gelernt hat.",
    byKind: "Die Netze des Fachartikels, Art für Art",
    byKindAbout: "Ein Strich: Keine Aufteilung prüft diese Art als neu.",
    kindColumn: "Art",
    publishedColumn: "Fachartikel",
    oursColumn: "unsere",
  },
};
