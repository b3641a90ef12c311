// The German words for en/results.js.

import { list, number, percent } from "./format.js";

/** @type {typeof import("../en/results.js").results} */
export const results = {
  title: "Wie gut sind die Modelle?",
  model: "Modell",
  agent: "Spielweise",
  show: "Zeige",
  all: "alle Rätsel",
  failures: "nur nicht gelöste",
  late: "nicht gelöste und erst nach dem zehnten Versuch gelöste",
  first: "im ersten Versuch gelöste",
  csv: "Alles als CSV speichern",
  cells:
    "Jeder Eintrag öffnet sein Rätsel mit diesem Modell. Die Zahl sagt, in welchem Versuch es gelöst wurde; × heißt: nicht gelöst.",
  none: "Es gibt keine.",

  namedAgent: (name, what) => `${name}: ${what}`,
  about: (name, what, puzzles) =>
    `${name} ${what}; diese ${number(puzzles)} Rätsel des Benchmarks PHYRE hat es noch nie gesehen.`,
  outcome: ([hundred, ten, one], of) =>
    `${number(hundred)} von ${number(of)} Rätseln in höchstens hundert Versuchen gelöst, ${number(ten)} in zehn, ${number(one)} im ersten.`,
  auccess: (auccess) => `AUCCESS: ${number(auccess, 1)} von 100; je weniger Versuche, desto höher.`,
  compared: (others) => `Zum Vergleich: ${list(others.map(([agent, auccess]) => `${agent} ${number(auccess, 1)}`))}.`,
  ofKind: (solved, of) => `${number(solved)} von ${number(of)} gelöst`,
  solved: (task, at) => `${task}, gelöst im ${at}. Versuch`,
  missed: (task) => `${task}, nicht gelöst`,

  beside: {
    title: "Im Vergleich zu veröffentlichten Ergebnissen",
    about:
      "AUCCESS, gemittelt über die zehn Aufteilungen von PHYRE. Die Zahlen oben gelten für eine davon. Die meisten unserer Netze haben wir für jede Aufteilung neu und nur kurz trainiert. Gemessen haben wir in Version 3 unseres Simulators, die etwas anders rechnete als der von PHYRE. RAND probiert in jedem Rätsel dieselbe Liste von Kugeln durch; unsere zufälligen Kugeln werden jedes Mal neu gezogen.",
    within: "Bekannte Arten",
    cross: "Neue Arten",
    byKind: {
      title: "Die Netze des Fachartikels, Art für Art",
      about: "Ein Strich bedeutet: Keine Aufteilung prüft diese Art als neu.",
      kind: "Art",
      published: "Artikel",
      ours: "unsere",
    },
    otherData:
      "online, wenn das Netz auch aus selbst vorgeschlagenen Kugeln (bekannte Arten) oder nur aus zufälligen Rätseln (neue Arten) gelernt hat",
    ours: "Unsere Agenten",
    published: "Veröffentlichte Ergebnisse",
  },

  calibration: {
    title: "Wenn es 30\u00a0% sagt, klappt es dann in 30\u00a0% der Fälle?",
    about:
      "Von den Kugeln, denen das Modell eine Chance von 30\u00a0% gibt, sollten drei von zehn ihr Rätsel lösen. Unter der Diagonale verspricht es zu viel. Zufällige Kugeln sind beliebige, die auch du setzen dürftest; Kandidaten sind Kugeln, die das Modell selbst in Betracht zieht.",
    chart: "Angegebene Chance und Anteil der Kugeln, die lösen; die Zahlen stehen in der Tabelle",
    randomKey: "● zufällige Kugeln",
    candidatesKey: "■ Kandidaten",
    chance: "Chance",
    random: "Zufällige Kugeln",
    candidates: "Kandidaten",
    balls: "Kugeln",
    solve: "lösen",
    range: (from, to) => `${number(100 * from)} bis ${percent(to)}`,
  },
};
