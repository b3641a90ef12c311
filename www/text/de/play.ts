// Playing: placing and dropping the ball, the duel and its verdict, the list of attempts, maps and the check.

import { ATTEMPT_LIMIT } from "../../pkg/constants.ts";
import { GOAL_SECONDS, formatsOf, secondsOf } from "../formats.ts";
import { balls } from "./widths.ts";
import type { Outcome } from "../../core/derived/duel.ts";
import type { Text } from "../text.ts";

const { counted, percent, seconds } = formatsOf("de");

const OUTCOMES: Record<Outcome, (round: number, modelAt: number | null) => string> = {
  won: (round) =>
    round === 1 ? "Du schlägst das Modell mit der ersten Kugel!" : `Du schlägst das Modell mit Kugel ${round}!`,
  draw: (round) => `Unentschieden: Beide lösen es mit Kugel ${round}.`,
  late: (round, modelAt) => `Gelöst mit Kugel ${round}! Das Modell brauchte ${modelAt}.`,
  lost: (round) => `Das Modell löst es mit Kugel ${round}. Und du?`,
  behind: (_, modelAt) => `Noch nicht. Das Modell brauchte ${counted(modelAt!, "Kugel", "Kugeln")}.`,
  neither: () => "Noch keiner von beiden.",
  solved: (round) => (round === 1 ? "Gelöst mit der ersten Kugel!" : `Gelöst mit Kugel ${round}!`),
  missed: () => "Noch nicht.",
  after: () => "Verfehlt, aber gelöst hast du es schon.",
};

export const play: Text["play"] = {
  tab: "Spielen",
  step: {
    start: "Spiel gegen sie",
    drop: "Fallen lassen",
    run: "Laufen lassen",
    pause: "Pause",
    play: "Weiter",
    again: "Neuer Versuch",
    back: "Du bist dran",
    next: "Nächstes Rätsel",
    try: "Spielen",
    make: "Weiterbauen",
  },
  placeFirst: "Klick oder tipp in die Szene, um deine rote Kugel zu setzen. Danach fasst niemand mehr etwas an.",
  keys: "Mit Tasten: Pfeile setzen und bewegen sie, Plus und Minus ändern ihre Größe, Enter lässt sie fallen.",
  ready: "Bereit. Lass sie fallen!",
  choosing: "Das Modell wählt seine Kugel …",
  running: "Jetzt fasst niemand mehr etwas an.",
  full: `Du hast alle ${ATTEMPT_LIMIT} Kugeln dieses Rätsels verbraucht.`,

  verdict: ({ outcome, round, modelAt }) => OUTCOMES[outcome](round, modelAt),
  miss: ({ facts: { ending, nearest }, radius }) =>
    ending.longest_touch > 0
      ? `Grün hat das Ziel ${seconds(secondsOf(ending.longest_touch))} lang berührt, ${GOAL_SECONDS} wären nötig.`
      : `Grün hat das Ziel um ${balls(nearest.gap, radius)} verfehlt.`,
  guessed: (chance, off, radius) =>
    `Das Modell gab deiner Kugel eine Chance von ${chance < 0.01 ? "unter 1 %" : percent(chance)}; ` +
    `seine Vermutung lag um ${balls(off, radius)} daneben.`,
  luck: (solved, valid) =>
    solved > 0.6 * valid
      ? `Ein Plan: ${solved} der ${valid} Kugeln neben deiner lösen es auch.`
      : solved > 0.25 * valid
        ? `Ein Plan mit etwas Glück: ${solved} der ${valid} Kugeln neben deiner lösen es auch.`
        : `Vor allem Glück: ${solved} der ${valid} Kugeln neben deiner lösen es auch.`,
  showModel: "Kugel des Modells zeigen",

  playback: "Wiedergabe",
  moment: "Zeitpunkt",
  speed: "Tempo",
  times: (speed) => (speed === 0.25 ? "¼×" : `${speed}×`),
  time: (steps) => seconds(secondsOf(steps)),
  replay: "Noch einmal abspielen",

  radius: "Radius",
  duel: "Du gegen das Modell",
  you: "Du",
  model: "Modell",
  noAttempts: "Jede Kugel ist ein Duell: Das Modell lässt eine eigene fallen.",
  solved: "gelöst",
  missed: "verfehlt",
  waiting: "noch nicht",
  done: "fertig",
  round: (round) => `Kugel ${round}: noch einmal zeigen`,
  guess: "Vermutung des Modells",
  alone: "Ohne das Modell spielen",
};
