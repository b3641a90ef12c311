// The texts of the page in English.

import { ATTEMPT_LIMIT, MAX_RADIUS, MIN_RADIUS, TEMPLATES } from "../pkg/constants.ts";
import { formatsOf, GOAL_SECONDS, secondsOf } from "./formats.ts";
import { widthsIn } from "./widths.ts";
import type { Failure } from "../core/change/model.ts";
import type { Point } from "../core/change/placement.ts";
import type { Notice } from "../core/change/settings.ts";
import type { Dialog, Preset } from "../core/change/dialog.ts";
import type { Step } from "../core/change/walkthrough.ts";
import type { Named, NamedProblem, Role, Shape, Size } from "../core/derived/bodies.ts";
import type { LuckKind, Outcome, Verdict } from "../core/derived/duel.ts";
import type { Difficulty, Progress, Rarity, Standing } from "../core/derived/home.ts";
import type { Result } from "../core/derived/sharing.ts";
import type { About, Body, FoundSolutions, InvalidBall, MapName, Setup } from "../pkg/page/pathlight.js";
import type { Language } from "./languages.ts";

const { chance, counted, number, percent, seconds } = formatsOf("en-GB", "under 1%");

export const language = "en" as Language;

// The panels next to the scene, in the order of their tabs.
export const tabs = { play: "Play", imagine: "Imagine", predict: "Predict", make: "Make", data: "Data" };

// Distances in widths of a ball.
const balls = widthsIn({
  hair: "a hair",
  quarter: "a quarter of a ball",
  half: "half a ball",
  one: "a ball’s width",
  more: (count) => `${number(count)} balls`,
});

// Puzzles: their names, goals and bodies.
const SHAPES: Record<Body["shape"], string> = {
  ball: "ball",
  bar: "bar",
  jar: "jar",
  standing_sticks: "standing sticks",
};
const kinds = new Map(TEMPLATES.map((template) => [template.id, template]));

const body = ({ role, shape }: Named) => `${role} ${SHAPES[shape]}`;
const placed = (one: Body) => `${body(one)} at x ${number(one.x)}, y ${number(one.y)}`;

export const puzzle = {
  name: ({ id, name }: Pick<About, "id" | "name">) =>
    id ? kinds.get(id.slice(0, 5))!.name : (name ?? "Custom puzzle"),
  /** What happens in the puzzle, and what to do. */
  instructions: ({ id }: About) => (id ? kinds.get(id.slice(0, 5))!.story : "This scene is homemade."),
  goal: (object: Body, target: Body) =>
    `Get the ${body(object)} to touch the ${body(target)} for ${GOAL_SECONDS} seconds.`,
  body,
  scene: (object: Body, target: Body, others: readonly Body[]) =>
    `256 by 256, y is up. The ${placed(object)}; the goal is the ${placed(target)}. ` +
    (others.length ? `Also: ${[...new Set(others.map(placed))].join("; ")}.` : "Nothing else."),
  ballAt: (x: number, y: number, r: number) => `Your ball is at x ${x}, y ${y}, with radius ${r}.`,
  fault: (fault: InvalidBall, bodies: readonly Body[]) =>
    fault.kind === "overlaps"
      ? `Not here: the ball overlaps the ${body(bodies[fault.body]!)}.`
      : fault.kind === "outside"
        ? "Not here: too close to the edge."
        : `The radius of the ball is ${MIN_RADIUS} to ${MAX_RADIUS}.`,
};

// Playing: placing and dropping the ball, the duel and its verdict, the list of attempts, maps and the check.
const OUTCOMES: Record<Outcome, (round: number, modelAt: number | null) => string> = {
  won: (round) => (round === 1 ? "You beat the model with your first ball!" : `You beat the model with ball ${round}!`),
  draw: (round) => `A draw: both solve it with ball ${round}.`,
  late: (round, modelAt) => `Solved with ball ${round}! The model needed ${modelAt}.`,
  lost: (round) => `The model solves it with ball ${round}. Can you?`,
  behind: (_, modelAt) => `Not yet. The model needed ${counted(modelAt!, "ball", "balls")}.`,
  neither: () => "Neither of you, not yet.",
  solved: (round) => (round === 1 ? "Solved with your first ball!" : `Solved with ball ${round}!`),
  missed: () => "Not yet.",
  after: () => "A miss, but you have solved it already.",
};

const LUCK: Record<LuckKind, string> = { plan: "A plan", some: "A plan with some luck", mostly: "Mostly luck" };

export const play = {
  step: {
    start: "Play against it",
    drop: "Drop it",
    run: "Let it run",
    pause: "Pause",
    play: "Go on",
    again: "Try again",
    back: "Your turn",
    next: "Next puzzle",
    try: "Play it",
    make: "Back to making",
  },
  placeFirst: "Click or tap the scene to place your red ball. Nobody touches anything after that.",
  /** Only for screen readers. */
  keys: "By keys: arrows place and move it, plus and minus change its size, Enter drops it.",
  ready: "Ready. Drop it!",
  choosing: "The model chooses its ball …",
  running: "Now nobody touches anything.",
  full: `You have used all ${ATTEMPT_LIMIT} balls of this puzzle.`,

  verdict: ({ outcome, round, modelAt }: Verdict) => OUTCOMES[outcome](round, modelAt),
  /** How a miss ended. */
  miss: ({ facts: { ending, nearest, line }, changedNothing }: Verdict) =>
    changedNothing
      ? "Green went as it goes without your ball."
      : ending.longest_touch > 0
        ? `Green touched the goal for ${seconds(secondsOf(ending.longest_touch))} of ${GOAL_SECONDS}.`
        : `Green missed the goal by ${balls(nearest.gap, line.ball![2])}.`,
  guessed: (given: number, off: number, radius: number) =>
    `The model gave your ball a chance of ${chance(given)}; the path it guessed was ${balls(off, radius)} off.`,
  luck: (kind: LuckKind, solved: number, valid: number) =>
    `${LUCK[kind]}: ${solved} of the ${valid} balls beside yours ${solved === 1 ? "solves" : "solve"} it too.`,
  showModel: "Show the model’s ball",

  playback: "Playback",
  moment: "Moment",
  speed: "Speed",
  times: (speed: number) => (speed === 0.25 ? "¼×" : `${speed}×`),
  time: (steps: number) => seconds(secondsOf(steps)),
  replay: "Play it again",

  radius: "Size",
  duel: "You against the model",
  you: "You",
  model: "Model",
  noAttempts: "Every ball you drop is a duel: the model drops one of its own.",
  /** The mark of an attempt, and its name for a screen reader. */
  solved: "solved",
  missed: "missed",
  waiting: "not yet",
  done: "done",
  round: (round: number) => `Ball ${round}: show it again`,
  guess: "The model’s guess",
  alone: "Play without the model",
};

// The check: where balls of a radius work, and the search for an easy one.
export const check = {
  show: "Show every place that works",
  offer: "Three misses: would you like to see where a ball works?",
  radius: "Size of the balls",
  /** `working`: the share of the places where a ball works. */
  tried: (progress: number, working: number) =>
    (progress < 1
      ? `${percent(progress)} tried.`
      : working === 0
        ? "No ball of this size works."
        : `A ball of this size works at ${chance(working)} of all places.`) +
    `${working === 0 && progress === 1 ? "" : " Yellow: works."} Striped: no room for the ball.`,
  compare: "Compare with the model’s map",
  agrees: (share: number) => `${percent(share)} of its map lies where a ball works.`,
  seek: "Show a solution",
  stop: "Stop looking",
  shown: "That was the solution: it does not count. Another ball is yours.",
  found: ({ progress, valid, solved, rank, easiest, solves_itself }: FoundSolutions) =>
    [
      solves_itself ? "It solves itself, without any ball." : "",
      progress < 1
        ? `Looking for an easy ball: ${percent(progress)}.`
        : easiest
          ? `${number(solved)} of ${counted(valid, "ball", "balls")} ${solved === 1 ? "works" : "work"}. An easy one lies in the scene now.`
          : `None of ${counted(valid, "ball", "balls")} works, of all places and sizes. One in between still might.`,
      progress === 1 && easiest && rank !== null ? `${percent(rank)} of Pathlight’s puzzles are harder.` : "",
    ]
      .filter(Boolean)
      .join(" "),
};

// Which model plays, and whether it was trained on the puzzle.
export const model = {
  choose: "Model",
  names: {
    within: "Model A: trained on all 25 kinds of puzzles",
    cross: "Model B: trained on random scenes",
  } satisfies Record<Setup, string>,
  short: { within: "Model A", cross: "Model B" } satisfies Record<Setup, string>,
  practised: {
    within: "Careful: it trained on this very puzzle.",
    cross: "Its maps were trained on this very puzzle; the net that picks the ball was not.",
  },
  /** What is new to the model; the kind of a custom puzzle is unknown. */
  unseen: {
    within: "It has practised this kind, not this puzzle.",
    cross: "It has never seen this kind of puzzle.",
    custom: "It has never seen this puzzle.",
  },
};

// What the model imagines: the walkthrough, the maps, and how they are made.
const place = ([x, y]: Point) => `x ${Math.round(x)}, y ${Math.round(y)}`;

export const imagine = {
  walkthrough: "How the model picks its ball",
  tour: "Play the steps",
  stop: "Stop",
  all: "All",
  back: "Step back",
  next: "Next step",
  step: (number: number, name: string) => `Step ${number}: ${name}`,
  maps: "Maps over the scene",
  intro: "Before anything moves, five small nets imagine what will. Press a map to lay it over the scene.",
  how: "How?",

  steps: {
    base: ["If you do nothing", "Where green goes by itself."],
    target: ["What green must do", "A path for green that ends at its goal."],
    action: ["What red must do", "A path for the red ball that makes green go there."],
    placement: ["Where to start", "Where the red ball should start, and where it would work."],
    imagined: [
      "Forty futures",
      "Each line is a possible path of green, each with a different ball. The stronger the line, the better the odds.",
    ],
    run: [
      "What really happens",
      "The model drops its favourite ball. Dotted: what it imagined. Solid: what really happens.",
    ],
  } satisfies Record<Step, [name: string, meaning: string]>,
  /** The map of all places; the other maps are named like their steps. */
  works: "What works",
  /** The paper's names for them; it has no map of what works. */
  paper: {
    base: "base path",
    target: "target path",
    action: "action path",
    placement: "placement",
    success: "success",
  } satisfies Record<MapName, string>,
  hows: {
    base: "Its net sees only the scene, as pictures of 64 × 64 cells, one for each colour. For every cell it says how sure it is that green passes there.",
    target:
      "Its net sees only the scene too. It learned from solved puzzles which way green went there. It does not know the red ball yet.",
    action:
      "Its net sees the scene, the base path and the target path: what would happen, and what should. The difference is what the red ball has to do.",
    placement: "Its net sees the scene, the target path and the action path.",
    success:
      "A fifth net, which the paper does not have, says for eight sizes of ball at every place how likely such a ball solves the puzzle. The map shows the best size.",
    imagined:
      "The fifth net learned from balls of all kinds what happens after they drop. The most promising balls become candidates. For each it imagines where green and the ball would go, and how likely that solves the puzzle. The forty likeliest are drawn. Nothing is simulated.",
    run: "The ball runs in the same simulator as yours. The wider the ribbon around a dotted line, the less sure the model was. If the ball fails, balls much like it become less likely, and the likeliest of the rest is next.",
  } satisfies Record<MapName | Step, string>,

  /** A map for people who cannot see it. */
  path: (from: Point, to: Point) => `from ${place(from)} to ${place(to)}`,
  strongest: (at: Point) => `strongest at ${place(at)}`,
  considered: (count: number, likely: number) =>
    `It considered ${counted(count, "ball", "balls")}, and gives ${likely === count ? "all" : likely || "none"} of them more than 50%.`,
  waiting: "The model is thinking …",
  ended: (solved: boolean, given: number) =>
    `It gave its ball ${chance(given)}, and ${solved ? "it works." : "it does not work."}`,
  off: (distance: number, radius: number) =>
    `The path it imagined for green was ${balls(distance, radius)} off, on average.`,
};

// Predicting where the green object goes.
export const predict = {
  intro:
    "Which way will green go? Draw its path, then let it run: were you closer, or the model? If you want a red ball in the scene, place it first.",
  keys: "By keys: arrows in the scene draw on from green, with Shift further.",
  draw: "Start at green, and draw the way it will go.",
  drawn: "Done? Let it run.",
  wipe: "Wipe the line",
  noBall: "Take the ball away",
  result: (you: number, model: number | null) => {
    const [mine, its] = [percent(you), model === null ? null : percent(model)];
    if (model === null) return `You were ${mine} right.`;
    if (mine === its) return `A draw: both were ${mine} right.`;
    return you > model ? `You were closer: ${mine}, the model ${its}.` : `The model was closer: ${its}, you ${mine}.`;
  },
  measured: "Black dots: your line. Green dots: the model’s. 100% would be exactly the real path.",
};

// Making a puzzle: its bodies, its problems, keeping and sharing it.
const SIZES: Record<Size, string> = { radius: "radius", length: "length", thickness: "thickness", height: "height" };
const px = (length: number) => (Math.abs(length) < 1e5 ? number(length, length % 1 ? 1 : 0) : length.toExponential(0));
const the = (body: Named | null) => `the ${puzzle.body(body!)}`;

export const make = {
  hint: "Drag a thing to move it. Tap it for handles: the square one resizes, the round one turns.",
  broken: "Not playable yet: see what is ringed in red.",
  watch: "Watch without a ball",

  add: "Add a body",
  shapes: { ball: "+ Ball", bar: "+ Bar", jar: "+ Jar", standing_sticks: "+ Sticks" } satisfies Record<Shape, string>,
  empty: "Start empty",
  selected: "Selected body",
  duplicate: "Duplicate",
  remove: "Delete",
  role: "It is",
  roles: {
    green: "green: has to reach the goal",
    blue: "blue: the goal, and moves",
    purple: "purple: the goal, and stays",
    gray: "gray: moves",
    black: "black: stays",
  } satisfies Record<Role, string>,

  details: "Details",
  body: "Body",
  nothing: "none selected",
  named: (body: Named, index: number) => `${index + 1}: ${puzzle.body(body)}`,
  angle: "angle",
  sizes: SIZES,
  keys: "Keys in the scene: N and P select, arrows move, comma and full stop turn, + and − resize, with Shift further; D duplicates, Delete removes, Ctrl+Z undoes.",
  /** For a screen reader. */
  described: (body: Named, x: number, y: number, degrees: number, sizes: readonly (readonly [Size, number])[]) =>
    `Selected: the ${puzzle.body(body)} at x ${px(x)}, y ${px(y)}, turned by ${px(degrees)} degrees, ` +
    `${sizes.map(([size, value]) => `${SIZES[size]} ${px(value)}`).join(", ")}.`,

  live: "Show where the model expects green to go",
  name: "Name",
  changed: (name: string) => `${name}, changed`,
  keep: "Keep in this browser",
  kept: "Kept in this browser",
  save: "Save as a file",
  open: "Open a file",
  link: "The address of this page holds your whole puzzle: whoever opens the link plays it.",
  yours: (count: number) => `Your puzzles (${number(count)})`,
  forget: (name: string) => `Delete “${name}”`,

  problem: ({ fault, body, other }: NamedProblem): string => {
    switch (fault.kind) {
      case "unreadable":
        return "This isn’t a Pathlight scene.";
      case "own_goal":
        return "Green cannot be its own goal: choose another goal.";
      case "static_object":
        return "Green has to move, or it never reaches a goal.";
      case "bodies":
        return fault.count > fault.most
          ? `It has more than ${fault.most} bodies: remove some.`
          : `It needs at least ${fault.least} bodies: add one.`;
      case "name":
        return `The name is longer than ${fault.most} characters.`;
      case "place":
        return `There is no valid place for ${the(body)}.`;
      case "length":
        return `The ${SIZES[fault.key]} of ${the(body)} has to be ${px(fault.least)} to ${px(fault.most)}.`;
      case "sticks_out":
      case "sticks_out_of_corner":
        return `Sticks out by ${px(fault.by)} px: move it inside, or make it smaller.`;
      case "outside":
        return `${px(fault.by)} px outside the scene: move it nearer, or delete it.`;
      case "overlap":
        return `Overlaps ${the(other)} by ${px(fault.by)} px: move them apart.`;
    }
  },
};

// The panel Data: numbers and files.
export const data = {
  ball: "Ball",
  axes: { x: "x", y: "y", r: "radius" },
  run: "Imagined and real",
  noRun: "Once a ball has run, you see here in numbers how well it was imagined.",
  green: "Green",
  red: "Red",
  off: "Green, off by",
  you: "Your ball",
  model: "The model’s ball",
  alone: "Without a ball",
  agreement: percent,
  px: (distance: number) => `${number(distance, 1)}\u00a0px`,
  explained:
    "Percentages: how well the imagined paths cover the real ones, intersection over union on 64 × 64 cells; without a ball the base path, otherwise target and action path. Distance: between what the model imagined for your very ball and what happened, on average.",
  saveMaps: "Save the maps as a picture",
  attempts: "Your attempts",
  kept: (count: number) =>
    `${counted(count, "attempt", "attempts")}, kept in this browser alone. Safari deletes them after seven days without a visit, other browsers if the disk is full; a file stays.`,
  save: "Save to a file",
  open: "Open a file",
  table: "This puzzle as CSV",
};

// The home page.
const LEVELS: Record<Difficulty, string> = { easy: "easy", medium: "medium", hard: "hard" };

export const home = {
  title: "Watch a tiny AI imagine what happens. Then beat it.",
  goal: "Place one red ball so that the green object touches its striped goal for 3 seconds.",
  about: "The AI is a small model that runs in your browser and has never seen this puzzle either.",
  play: "Play the animation",
  pause: "Pause the animation",

  waiting: "You can play already: click or tap in the picture.",
  imagine: (futures: number) => `It imagines ${futures} futures …`,
  pick: (chance: number) => `… and picks one: ${percent(chance)} sure.`,
  real: "Now its ball really drops.",
  result: (solved: boolean, off: number, radius: number) =>
    `${solved ? "Solved" : "Missed"}: its guess was ${balls(off, radius)} off. Your turn: click or tap in the picture.`,

  day: "Puzzle of the day",
  unsolved: "The model never solved this",
  canYou: (facts: string) => `Can you? ${facts}`,
  make: "Make your own",
  makeHint: "Drag things around, play it, send it to a friend",
  facts: (puzzle: string, difficulty: Difficulty) => `${puzzle}, ${LEVELS[difficulty]}`,
  howHard: (difficulty: Difficulty, { balls, isRarer }: Rarity) =>
    `${difficulty.charAt(0).toUpperCase()}${LEVELS[difficulty].slice(1)}: ` +
    (isRarer ? `fewer than 1 ball in ${balls} solve it.` : `1 ball in ${balls} solves it.`),

  kinds: (count: number) => `${count} kinds of puzzles`,
  number: "Or by number:",
  /** "Puzzle 3 of 20 · 1 solved, 1 missed" */
  standing: (next: number, of: number, played: Standing["played"]) => {
    const solved = played.filter((one) => one.solved).length;
    const missed = played.length - solved;
    const found = [solved && `${solved} solved`, missed && `${missed} missed`].filter(Boolean).join(", ");
    return `Puzzle ${next} of ${of} · ${found}`;
  },
  results: "How good are the models? All results",
  learns: "Watch it learn",

  progress: "Your progress",
  soFar: ({ tried, solved, attempts }: Progress) =>
    `So far you have tried ${counted(tried, "puzzle", "puzzles")} and solved ${number(solved)}, with ${counted(attempts, "ball", "balls")}`,
  forget: "Forget all attempts",
  keep: "Keep them",
  forgetHint: "This browser then knows none of your balls and solutions any more. That cannot be undone.",
};

// Sharing a puzzle, and links for a lesson.
const first = (at: number) => (at === 1 ? "with the first ball" : `with ball ${at}`);

const rival = ({ modelAt, modelBalls }: Result) =>
  modelAt !== null
    ? `The model needed ${counted(modelAt, "ball", "balls")}.`
    : modelBalls > 0
      ? `The model had ${counted(modelBalls, "ball", "balls")} and did not solve it.`
      : "";

export const share = {
  /** On the picture. */
  headline: (solvedAt: number | null) => (solvedAt === null ? "Can you solve it?" : `Solved ${first(solvedAt)}`),
  model: rival,
  message: (puzzle: string, found: Result, isDaily: boolean) => {
    const { solvedAt, isWon, marks } = found;
    if (solvedAt === null) return `“${puzzle}” in Pathlight: can you solve it?`;
    const daily = isDaily ? `Pathlight’s puzzle of the day. ${marks} ` : "";
    const result = isWon
      ? `I beat the model at “${puzzle}” ${first(solvedAt)}.`
      : `I solved “${puzzle}” ${first(solvedAt)}.`;
    return `${daily}${result} ${rival(found)} ${solvedAt === 1 ? "Can you match it?" : "Can you do better?"}`.replace(
      "  ",
      " ",
    );
  },
  link: "The link",
  noBall: "The link hides your ball, the model’s balls and its guess until the puzzle is solved.",
  copy: "Copy text and link",
  system: "Share…",
  save: "Save the picture",
  drawing: "The picture is being drawn …",
  noCard: {
    missing: "This browser can’t make the picture. The text and the link say it all.",
    noise:
      "This browser guards its pictures, so there would be stripes instead of one. The text and the link say it all.",
  },
  withBall: "Show my ball in the picture",
  done: {
    copied: "Copied.",
    not_copied: "This browser does not let the page copy. Select the link above and copy it.",
    not_shared: "This browser could not share it. Copy the text and the link.",
  },
  send: "Send it on",

  challenge: (at: number) =>
    `Somebody solved this ${first(at)}. Can you do better? The model keeps quiet until you have solved it.`,
  challenged: (at: number, theirs: number) =>
    at < theirs
      ? `You win: they needed ${theirs} balls.`
      : at === theirs
        ? "A draw: they needed as many."
        : `They needed ${counted(theirs, "ball", "balls")}.`,

  puzzles: "Numbers of the puzzles, separated by commas; they stand beside the names",
  /** In a lesson. */
  lastPuzzle: "That was the last puzzle of the lesson.",
  place: (number: number, of: number) => `${number} of ${of}`,
  noPuzzles: (wrong: string[]) =>
    `${wrong.join(", ")}: ${wrong.length === 1 ? "that isn’t a puzzle" : "these aren’t puzzles"}. Their numbers look like 00007:008, or 7:8.`,
  shows: "What the class sees",
  presets: { everything: "Everything", play: "Play only", predict: "Predict: no guess of the model" } satisfies Record<
    Preset,
    string
  >,
  customise: "Customise",
  parts: { puzzles: "The ways to other puzzles", guess: "The model’s guess", model: "The model" },
  presentation: "As a presentation, for a projector",
  copyLink: "Copy the link",
  preview: "See it as the class does",
  code: "The link as a QR code",
  noCode: "The link is too long for a QR code. It works without one.",
  ownMachine: "This link works only on this computer: serve the page where others can reach it.",
  end: "The link holds everything: nothing is stored elsewhere.",
};

// The dialog "About Pathlight".
export const about = {
  idea: [
    "Pathlight is a game against a small AI that plans by imagining. Before a ball drops, four little neural nets draw where the green object goes by itself, where it should go, what red must do for that, and where red should start. A fifth imagines what any ball would lead to.",
    "Nothing you see of the model is made up: it thinks in your browser while you play. Then the simulator shows what really happens, to the bit as in the benchmark that the puzzles come from. Whatever you play stays on this device.",
  ],
  paper: "The paper: Solving Physics Puzzles by Reasoning about Paths (Harter and others, 2020)",
  phyre: "The puzzles: PHYRE, a benchmark for physical reasoning (Bakhtin and others, 2019)",
  keys: "Keys",
  keyList: [
    ["← ↑ → ↓", "move the ball; with Shift, farther"],
    ["+ -", "change its size"],
    ["Enter", "drop it, then go on"],
    ["Space", "pause or play"],
    [", .", "one step back or forward"],
    ["R", "try again"],
    ["Ctrl+Z Ctrl+Y", "undo, redo"],
    ["1 … 5", "the panels"],
    ["[ ]", "the puzzle before, and after"],
  ] as [keys: string, does: string][],
  source: "Source code and citation",
  cite: "Pathlight is open source, under the Apache License 2.0. Whoever uses it in research can cite it, and the work that it builds on.",
  citation: "How to cite it",
  licences: "Licences of all that is inside",
};

// The page around the scene: header, menu, and messages about errors.
const FAILURES: Record<Failure["code"], string> = {
  offline: "No connection. It comes when you are back.",
  unreachable: "The server does not answer. Try again in a while.",
  missing: "A file was not found on this server. Whoever runs it has to put all files of Pathlight there.",
  page: "A web page came in place of a file. Does this network ask you to log in first? Otherwise the server answers wrongly.",
  damaged: "A file arrived damaged, or is of another version. Load the page again.",
  forbidden: "This page forbids WebAssembly: its Content-Security-Policy needs 'wasm-unsafe-eval' in script-src.",
  old: "This browser is too old: it needs WebAssembly with SIMD. Update it, or use another.",
  worker:
    "This page forbids workers: its Content-Security-Policy needs worker-src, and a sandboxed frame allow-same-origin.",
  crashed: "It stopped unexpectedly. Load it again.",
  broken: "It could not be started. Load the page again.",
};

export const page = {
  brand: "Pathlight",
  /** Of the dialogs. */
  titles: {
    share: "Share",
    lesson: "Link for a lesson",
    about: "About Pathlight",
    forget: "Forget all attempts?",
  } satisfies Record<Dialog, string>,
  share: "Share",
  present: "Presentation",
  leave: "Leave the presentation",
  previous: "Previous puzzle",
  next: "Next puzzle in the list",
  number: "Number of the puzzle",
  tabs: "Panels",
  menu: "Menu",
  theme: "Theme",
  themes: { light: "Light", dark: "Dark" },
  language: "Language",
  learns: "Watch it learn",
  results: "How good are the models?",
  scene: "puzzle scene",

  loading: (arrived: number) => `The model is loading (${percent(arrived)}). You can play already.`,
  /** Explains a failure and its remedy. */
  failure: (failure: Failure) => FAILURES[failure.code],
  noModel: (failure: Failure) => `You can play on, but the model is not here. ${FAILURES[failure.code]}`,
  retry: "Load it again",
  dismiss: "Close",
  notice: (notice: Notice) => {
    switch (notice.kind) {
      case "no_task":
        return `There is no puzzle ${notice.task}. Each kind has a hundred numbers, with gaps between them: the number of a puzzle stands beside its name.`;
      case "unread_link":
        return `This link has a part that Pathlight does not understand: ${notice.parts.join(", ")}.`;
      case "bad_scene":
        return `This link’s puzzle cannot be opened: ${notice.problem ? make.problem(notice.problem) : "a part of the link is missing. Ask for it again."}`;
      case "bad_file":
        return `This file was not opened: ${notice.problem ? make.problem(notice.problem) : "it holds no puzzles of Pathlight."}`;
      case "storage_full":
        return "This browser keeps nothing here: what you play now is forgotten when you leave.";
      case "no_text":
        return "This language could not be loaded. Load the page again.";
      case "no_picture":
        return "This browser could not make the picture.";
      case "opening":
        return `The file is read: ${percent(notice.share)}.`;
      case "opened":
        return (
          `${counted(notice.found, "attempt", "attempts")} in the file, ${notice.added || "none"} of them new here.` +
          (notice.unread ? ` ${counted(notice.unread, "line isn’t an attempt", "lines aren’t attempts")}.` : "")
        );
      case "no_attempts":
        return `${notice.file} is not a file of attempts from Pathlight. Nothing was changed.`;
    }
  },
};
