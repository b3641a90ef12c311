// The exhibits "Watch it learn" and "Results", which load their texts themselves.

import { ATTEMPT_LIMIT } from "../pkg/constants.ts";
import { formatsOf } from "./formats.ts";
import { puzzle } from "./en.ts";
import type { Reminder, Setup } from "../pkg/page/pathlight.js";

const { counted, number, percent } = formatsOf("en-GB", "under 1%");

const tries = (first: number | null) =>
  first === null ? `not solved with ${ATTEMPT_LIMIT} balls` : first === 1 ? "at once" : `with ball ${first}`;
const puzzles = (count: number) => counted(count, "puzzle", "puzzles");

export const exhibits = {
  number,
  percent: (share: number, decimals = 0) => `${number(100 * share, decimals)}%`,
  kind: (template: string) => puzzle.name({ id: template, name: null }),
  back: "Pathlight: to the puzzles",
  retry: "Try again",

  learns: {
    title: "Watch it learn",
    about:
      "The model has never seen puzzles of these kinds. It plays twenty of one kind in a row, and remembers what each ball taught it. Beside it plays the same model without a memory. This is one run in a fixed order, not an average.",
    kinds: "Kind of puzzles",
    play: (count: number) => `Let it play ${count}`,
    more: (count: number) => `Play ${count} more`,
    pause: "Pause",
    goOn: "Go on",
    toTheEnd: "To the end",
    forget: "Forget everything",
    fetching: (arrived: number | null) => `Fetching the model …${arrived === null ? "" : ` ${percent(arrived)}`}`,
    failed: (reason: string) => `It cannot play now. ${reason}`,
    withMemory: "With memory",
    without: "Without",
    scene: (who: string) => `What the model tries. ${who}`,
    ball: (at: number) => `Ball ${at}`,
    ended: (first: number | null) => (first === null ? "Not solved" : `Solved ${tries(first)}`),
    chart: "Balls for each puzzle",
    chartLabel: "Balls for each puzzle, with memory and without; the list has the numbers",
    key: { learned: "● with memory", fresh: "■ without", missed: "× not solved", trend: "— trend of five" },
    axis: "puzzle",
    list: "Puzzle by puzzle",
    puzzle: (place: number) => `Puzzle ${place}`,
    played: (learned: number | null, fresh: number | null, helped: string) =>
      `${learned === null ? "" : "solved "}${tries(learned)}${helped}. Without memory: ${tries(fresh)}.`,
    /** `place` is the position in the list of the puzzle that helped; 0 if it is of another kind. */
    helped: (place: number, kind: string, { mirrored }: Reminder) =>
      `, helped by ${place ? `puzzle ${place}` : `“${kind}”`}${mirrored ? " (mirrored)" : ""}`,
    total: (count: number, learned: number, fresh: number) =>
      `In this one run ${puzzles(count)} took it ${counted(learned, "ball", "balls")} with its memory, and ${number(fresh)} without.`,
    remembers: (count: number) => (count ? `It remembers ${puzzles(count)}.` : "It remembers nothing yet."),
    forgotten: "It has forgotten everything.",
  },

  results: {
    title: "How good are the models?",
    about:
      "Two sets of figures, which must not be compared: first the two models of this page, each measured on one split of PHYRE’s puzzles (you play against A; B plays in “Watch it learn”); then agents that were trained anew for each of its ten splits, as means.",
    failed: (reason: string) => `The results could not be loaded: ${reason}.`,

    here: "The models on this page, on one split (fold 0)",
    model: "Model",
    models: { within: "A: trained on all 25 kinds", cross: "B: trained on random scenes" } satisfies Record<
      Setup,
      string
    >,
    agent: "How it plays",
    agents: {
      online: "online: as it plays here, learning from its misses",
      dynamics: "dynamics: the same without learning from its misses",
      success: "success: the success net alone",
      paper: "paper: the paper’s four nets alone",
      random: "random: balls at random",
    },
    auccess: "AUCCESS on this one split",
    auccessHint: "0: nothing is solved; 100: everything with the first ball.",
    solved: (most: number) => (most === 1 ? "solved with the first ball" : `solved within ${most} balls`),
    unseen: (count: number) => `${number(count)} test puzzles, new to the model.`,
    others: "The other ways to play, on the same split:",
    /** What its nets were trained on in addition to PHYRE's training tasks. */
    sawMore: {
      within:
        "Its net learned from more than PHYRE’s training tasks: also from puzzles of the same kinds that PHYRE does not list. So do not compare it with published agents.",
      cross:
        "Its net learned from random scenes alone, from none of PHYRE’s tasks; the four nets that draw its maps learned from 20 kinds. Fold 0 is one of the easier splits for it.",
      paper: "These four nets learned from PHYRE’s training tasks alone.",
      random: "Nothing is learned here.",
    },
    show: "Show",
    filters: {
      all: "all puzzles",
      failures: "only failures",
      late: "failures, and those that took more than ten balls",
      first: "those solved with the first ball",
    },
    cells: "Each number opens its puzzle: it is the ball that solved it. × was not solved.",
    none: "There are none.",
    ofKind: (solved: number, of: number) => `${number(solved)} of ${number(of)} solved`,
    cell: (task: string, first: number | null) =>
      `${task}, ${first === null ? "not solved" : `solved with ball ${first}`}`,
    csv: "Save all as CSV",

    calibration: "When it says 30%, is it right 30% of the time?",
    calibrationAbout:
      "Of the balls that the model gives 30%, three in ten should solve. Below the diagonal it promises too much. Random balls are any that may be placed; candidates are those that the model considers.",
    calibrationLabel: "Chance given, and share that solves; the table has the numbers",
    random: "random balls",
    candidates: "candidates",
    chance: "Chance",
    balls: "balls",
    solve: "solve",
    range: (from: number, to: number) => `${number(100 * from)} to ${percent(to)}`,

    means: "Means over all ten splits, beside what others have published",
    meansAbout:
      "AUCCESS, ± standard deviation over the splits. Most nets were trained briefly, anew for each split, so these figures are lower than those above. Most of ours were measured in version 3 of the simulator, which differed slightly from PHYRE’s. RAND, the rows marked † or ‡ and the puzzles here use version 4, which does not.",
    within: "Known kinds",
    cross: "New kinds",
    ours: "Ours, means over ten splits",
    /** Names by recipe of lab/recipes.toml. */
    recipes: {
      tasks: "online, taught PHYRE’s tasks alone",
      scenes: "online, taught more scenes †",
      memory: "online with a memory of all puzzles before ‡",
      success: "the success net, which imagines nothing",
      dqn: "DQN, smaller",
      paper: "the paper’s four nets",
      random: "RAND: PHYRE’s own list of random balls",
    },
    published: "Published, in PHYRE’s own simulator",
    sawMoreMark:
      "† Known kinds: also puzzles of these kinds that PHYRE does not list. New kinds: random scenes alone. No published agent has seen these.",
    memoryMark: "‡ It keeps what it learned at one test puzzle for the next.",
    byKind: "The paper’s nets, kind by kind",
    byKindAbout: "A dash: no split tests this kind as new.",
    kindColumn: "Kind",
    publishedColumn: "published",
    oursColumn: "ours",
  },
};

export type ExhibitText = typeof exhibits;
