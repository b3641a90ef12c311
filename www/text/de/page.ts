// The page around the scene: header, menu, and messages about errors.

import { formatsOf } from "../formats.ts";
import { make } from "./make.ts";
import type { Failure } from "../../core/change/model.ts";
import type { Text } from "../text.ts";

const { counted, percent } = formatsOf("de");

const FAILURES: Record<Failure["code"], string> = {
  offline: "Keine Verbindung. Es geht weiter, sobald du wieder online bist.",
  unreachable:
    "Der Server antwortet nicht. Versuch es später noch einmal; die Content-Security-Policy einer Seite muss ihn erlauben (connect-src).",
  missing: "Eine Datei fehlt auf diesem Server. Wer ihn betreibt, muss alle Dateien von Pathlight dort ablegen.",
  page: "Statt einer Datei kam eine Webseite. Musst du dich in diesem Netz erst anmelden? Sonst antwortet der Server falsch.",
  damaged: "Eine Datei kam beschädigt an oder gehört zu einer anderen Version. Lade die Seite neu.",
  forbidden:
    "Diese Seite verbietet WebAssembly: Ihre Content-Security-Policy braucht 'wasm-unsafe-eval' in script-src.",
  old: "Dieser Browser ist zu alt: Er muss WebAssembly mit SIMD können. Aktualisier ihn oder nimm einen anderen.",
  worker:
    "Diese Seite verbietet Worker: Ihre Content-Security-Policy braucht worker-src, ein Frame mit sandbox allow-same-origin.",
  crashed: "Es ist unerwartet stehen geblieben. Lade es noch einmal.",
  broken: "Es konnte nicht gestartet werden. Lade die Seite neu.",
};

export const page: Text["page"] = {
  brand: "Pathlight",
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
  learns: "Sieh ihm beim Lernen zu",
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
        return `Ein Rätsel ${notice.task} gibt es nicht. Die Nummern gehen von 00000:000 bis 00024:099.`;
      case "unread_link":
        return `Dieser Link enthält etwas, das Pathlight nicht versteht: ${notice.parts.join(", ")}.`;
      case "bad_scene":
        return `Das Rätsel dieses Links lässt sich nicht öffnen: ${notice.problem ? make.problem(notice.problem) : "Ein Teil des Links fehlt. Lass ihn dir noch einmal schicken."}`;
      case "bad_file":
        return `Diese Datei wurde nicht geöffnet: ${notice.problem ? make.problem(notice.problem) : "Darin ist kein Rätsel von Pathlight."}`;
      case "storage_full":
        return "In diesem Browser ist kein Platz mehr: Was du jetzt spielst, ist vergessen, wenn du gehst.";
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
