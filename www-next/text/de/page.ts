// The page round the scene: header, menu, and what is said when something goes wrong.

import { formatsOf } from "../formats.ts";
import { make } from "./make.ts";
import type { Failure } from "../../core/change/model.ts";
import type { Text } from "../text.ts";

const { counted, percent } = formatsOf("de");

const FAILURES: Record<Failure["code"], string> = {
  offline: "Keine Verbindung. Du kannst weiterspielen; das Modell kommt, sobald du wieder online bist.",
  missing: "Die Dateien des Modells fehlen auf diesem Server. Du kannst allein weiterspielen.",
  damaged: "Die Datei des Modells kam beschädigt an. Du kannst allein weiterspielen.",
  crashed: "Das Modell ist unerwartet stehen geblieben. Du kannst allein weiterspielen.",
  broken: "Das Modell konnte nicht gestartet werden. Du kannst allein weiterspielen.",
};

export const page: Text["page"] = {
  brand: "Pathlight",
  skip: "Zur Szene springen",
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
      case "file_read":
        return (
          `Neu hier: ${counted(notice.attempts, "Kugel", "Kugeln")}.` +
          (notice.unread ? ` Weggelassen: ${counted(notice.unread, "Zeile", "Zeilen")} ohne gültigen Versuch.` : "")
        );
      case "file_unread":
        return `In ${notice.name} stehen keine Versuche. Nimm eine Datei, die Pathlight gespeichert hat.`;
    }
  },
};
