// "Watch it learn": the model plays a sequence of puzzles of a kind that is new to it, and remembers what each ball
// taught. Next to it the same model plays without a memory. A worker plays one puzzle ahead of the display.

import { html, nothing } from "lit-html";
import { load } from "pathlight";
import { ballsChart } from "./charts.ts";
import { isDark, loadText, onDarkChange, puzzleAddress, show, still } from "./exhibit.ts";
import { duration, momentOf, playedOf, solvedAt } from "./learns-timeline.ts";
import { ATTEMPT_LIMIT } from "../pkg/constants.ts";
import type { TemplateResult } from "lit-html";
import type { Pathlight } from "pathlight";
import type { Answer, Game } from "./learns-worker.ts";
import type { Played } from "./learns-timeline.ts";

/** Number of puzzles in a sequence. */
const ROW = 20;
/** How long the end of a puzzle is shown, s. Under reduced motion, only the end is shown. */
const PAUSE = 0.6;
const STILL = 1.6;
/** The kind that is selected at first. */
const FIRST = "00015";
/** Maximum number of device pixels per CSS px; more are not worth their time. */
const MOST_PIXELS = 2;
const KEY = "pathlight.learns";

interface State {
  readonly kind: string;
  /** Puzzles played since everything was forgotten, by kind. */
  readonly played: Readonly<Record<string, readonly Played[]>>;
  /** The memory, as JSON. */
  readonly memory: string | null;
  readonly row: { readonly paused: boolean; readonly hurried: boolean } | null;
  /** The game that the scenes show, and how long it has been shown, s. */
  readonly shown: { readonly game: Game; readonly time: number } | null;
  /** The weights are loading; `part` is the fraction loaded. */
  readonly arriving: { readonly part: number | null } | null;
  readonly said: string;
  readonly failure: string | null;
}

type Side = "learned" | "fresh";
const SIDES = ["learned", "fresh"] as const;

const text = await loadText();
const words = text.learns;
let state: State = { ...NOTHING(), ...kept() };
let pathlight: Pathlight | null = null;
/** The tasks of each kind that the model has never seen. */
let kinds = new Map<string, string[]>();
let worker: Worker | null = null;
let playing: AbortController | null = null;
const canvases = { learned: canvas(words.withMemory), fresh: canvas(words.without) };
const thumbnails = new Map<string, HTMLCanvasElement>();

function NOTHING(): State {
  const nothing = { played: {}, memory: null, row: null, shown: null, arriving: null };
  return { ...nothing, kind: FIRST, said: "", failure: null };
}

/** Played puzzles are kept while the tab is open, even if a puzzle is opened meanwhile. */
function kept(): Partial<State> {
  try {
    return JSON.parse(sessionStorage.getItem(KEY) ?? "{}");
  } catch {
    return {};
  }
}

function change(part: Partial<State>): void {
  const before = state;
  state = { ...state, ...part };
  if (state.played !== before.played || state.memory !== before.memory || state.kind !== before.kind) {
    const { kind, played, memory } = state;
    try {
      sessionStorage.setItem(KEY, JSON.stringify({ kind, played, memory }));
    } catch {
      // Then it is kept only as long as the page.
    }
  }
  view();
}

const all = (): readonly Played[] => state.played[state.kind] ?? [];
const left = (): string[] => (kinds.get(state.kind) ?? []).slice(all().length);

async function begin(): Promise<void> {
  change({ failure: null });
  try {
    pathlight = await load({ weights: null });
    // The fold of the worker’s model.
    const unseen = new Set(pathlight.fold("cross", 0).test);
    const known = pathlight.templates().map(({ id, tasks }) => [id, tasks.filter((task) => unseen.has(task))] as const);
    kinds = new Map(known.filter(([, tasks]) => tasks.length > 0));
    change({ kind: kinds.has(state.kind) ? state.kind : [...kinds.keys()][0]! });
  } catch (error) {
    change({ failure: (error as Error).message });
  }
}

function choose(kind: string): void {
  stop();
  change({ kind, shown: null, said: "" });
}

function stop(): void {
  playing?.abort();
  playing = null;
  worker?.terminate();
  worker = null;
  change({ row: null, arriving: null });
}

function forget(): void {
  stop();
  change({ played: {}, memory: null, shown: null, said: words.forgotten });
  document.querySelector<HTMLButtonElement>(".step")!.focus();
}

async function play(): Promise<void> {
  const { signal } = (playing = new AbortController());
  worker ??= new Worker(new URL("learns-worker.js", import.meta.url), { type: "module" });
  change({ row: { paused: false, hurried: false }, failure: null });
  try {
    const tasks = left().slice(0, ROW);
    let next = ask(tasks[0]!, state.memory, signal);
    for (const [index, task] of tasks.entries()) {
      const game = await next;
      const following = tasks[index + 1];
      if (following) next = ask(following, game.memory, signal);
      // A failure is handled when it is awaited, after this puzzle has been shown.
      next.catch(() => {});
      await showGame(task, game, signal);
    }
  } catch (error) {
    if (signal.aborted) return;
    worker?.terminate();
    worker = null;
    change({ failure: (error as Error).message });
  }
  playing = null;
  change({ row: null, arriving: null });
}

function ask(task: string, memory: string | null, signal: AbortSignal): Promise<Game> {
  const asked = worker!;
  return new Promise((resolve, reject) => {
    const done = new AbortController();
    const listening = { signal: AbortSignal.any([signal, done.signal]) };
    const answered = ({ data: { arrived, failure, game } }: MessageEvent<Answer>) => {
      if (arrived !== undefined) return change({ arriving: { part: arrived } });
      change({ arriving: null });
      done.abort();
      if (game) resolve(game);
      else reject(new Error(failure));
    };
    asked.addEventListener("message", answered, listening);
    asked.addEventListener("error", ({ message }) => reject(new Error(message || "learns-worker.js")), listening);
    signal.addEventListener("abort", () => reject(signal.reason));
    asked.postMessage({ task, memory });
  });
}

async function showGame(task: string, game: Game, signal: AbortSignal): Promise<void> {
  const longest = Math.max(duration(game.learned.length), duration(game.fresh.length));
  change({ shown: { game, time: still.matches ? Infinity : 0 } });
  if (!still.matches) await pass(longest, signal, (time) => change({ shown: { game, time } }));
  const played = [...all(), playedOf(task, game.learned, game.fresh)];
  change({
    shown: { game, time: Infinity },
    memory: game.memory,
    played: { ...state.played, [state.kind]: played },
    said: `${words.puzzle(played.length)}: ${sentence(played, played.length - 1)}`,
  });
  await pass(still.matches ? STILL : PAUSE, signal);
}

/** Advances time in frames: not while paused, and not at all when hurried. */
function pass(seconds: number, signal: AbortSignal, onTime: (time: number) => void = () => {}): Promise<void> {
  return new Promise((resolve, reject) => {
    let time = 0;
    let last = performance.now();
    const frame = (now: number) => {
      if (signal.aborted) return reject(signal.reason);
      if (!state.row?.paused) time += Math.max(now - last, 0) / 1000;
      last = now;
      if (state.row?.hurried || time >= seconds) return resolve();
      if (!state.row?.paused) onTime(time);
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  });
}

function sentence(played: readonly Played[], index: number): string {
  const { task, learned, fresh, reminder } = played[index]!;
  const place = played.slice(0, index).findIndex((earlier) => earlier.task === reminder?.task) + 1;
  const isOther = reminder?.task && reminder.task.slice(0, 5) !== task.slice(0, 5);
  const helped = reminder && (place || isOther) ? words.helped(place, text.kind(reminder.task!), reminder) : "";
  return words.played(learned, fresh, helped);
}

function view(): void {
  show(
    text,
    words.title,
    html`<p>${words.about}</p>
      ${state.failure ? html`<p class="trouble" role="alert">${words.failed(state.failure)} ${pathlight ? nothing : html`<button @click=${begin}>${text.retry}</button>`}</p>` : nothing}
      ${pathlight ? exhibit() : nothing}`,
  );
  if (pathlight) paint();
}

function exhibit(): TemplateResult {
  const { row, shown, arriving } = state;
  const more = Math.min(left().length, ROW);
  const total = (side: Side) => all().reduce((sum, played) => sum + (played[side] ?? ATTEMPT_LIMIT), 0);
  const count = Object.values(state.played).flat().length;
  return html`<fieldset class="radios">
      <legend>${words.kinds}</legend>
      ${[...kinds.keys()].map(
        (kind) =>
          html`<label
            ><input type="radio" name="kind" .checked=${kind === state.kind} @change=${() => choose(kind)} />
            ${thumbnail(kind)}<span>${text.kind(kind)}</span></label
          >`,
      )}
    </fieldset>
    <div class="actions">
      <button class="step ${row && !row.paused ? "pause" : ""}" ?disabled=${!row && more === 0} @click=${clicked}>
        ${row ? (row.paused ? words.goOn : words.pause) : all().length ? words.more(more) : words.play(more)}
      </button>
      <button aria-disabled=${!row} @click=${() => row && change({ row: { paused: false, hurried: true } })}>
        ${words.toTheEnd}
      </button>
      <button aria-disabled=${count === 0} @click=${() => count && forget()}>${words.forget}</button>
      <span class="quiet">${arriving ? words.fetching(arriving.part) : words.remembers(count)}</span>
    </div>
    <p class="said" role="status">${state.said}</p>
    <div class="boards">
      ${SIDES.map(
        (side) =>
          html`<figure class=${side}>
            <figcaption><b>${side === "learned" ? words.withMemory : words.without}</b> ${caption(side)}</figcaption>
            ${canvases[side]}
          </figure>`,
      )}
      <figure>
        <figcaption><b>${words.chart}</b></figcaption>
        ${ballsChart(all(), text)}
        <p class="key">
          <span class="learned">${words.key.learned}</span> <span class="fresh">${words.key.fresh}</span>
          <span>${words.key.missed}</span> <span>${words.key.trend}</span>
        </p>
      </figure>
    </div>
    ${
      all().length
        ? html`<p>${words.total(all().length, total("learned"), total("fresh"))}</p>
            <details>
              <summary>${words.list}</summary>
              <ol>
                ${all().map(({ task }, index) => html`<li><a href=${puzzleAddress(task)}>${words.puzzle(index + 1)}</a>: ${sentence(all(), index)}</li>`)}
              </ol>
            </details>`
        : nothing
    }`;

  function caption(side: Side): string {
    const moment = shown && momentOf(shown.game[side], shown.time);
    if (!moment) return "";
    return moment.isOver ? words.ended(solvedAt(shown.game[side])) : words.ball(moment.number);
  }

  // The second click of a double click must not pause what the first has started.
  function clicked({ detail }: MouseEvent): void {
    if (detail > 1) return;
    if (row) change({ row: { paused: !row.paused, hurried: false } });
    else void play();
  }
}

function paint(): void {
  const task = state.shown?.game.task ?? left()[0] ?? kinds.get(state.kind)![0]!;
  for (const side of SIDES) {
    const canvas = canvases[side];
    const pixels = Math.round(canvas.clientWidth * Math.min(devicePixelRatio, MOST_PIXELS)) || 1;
    if (canvas.width !== pixels) canvas.width = canvas.height = pixels;
    const tries = state.shown?.game[side] ?? [];
    const moment = momentOf(tries, state.shown?.time ?? 0);
    const marks = tries.slice(0, (moment?.number ?? 1) - 1).map(({ ball }) => ball);
    const shown = moment ? { ball: tries[moment.number - 1]!.ball, step: moment.step, marks } : {};
    pathlight!.paintScene(canvas.getContext("2d")!, task, { ...shown, dark: isDark() });
  }
}

function canvas(who: string): HTMLCanvasElement {
  const made = document.createElement("canvas");
  made.setAttribute("role", "img");
  made.ariaLabel = words.scene(who);
  return made;
}

function thumbnail(kind: string): HTMLCanvasElement {
  const made = thumbnails.get(kind) ?? document.createElement("canvas");
  if (!thumbnails.has(kind)) {
    made.width = made.height = 144;
    pathlight!.paintScene(made.getContext("2d")!, kinds.get(kind)![0]!, { dark: isDark() });
    thumbnails.set(kind, made);
  }
  return made;
}

onDarkChange(() => {
  thumbnails.clear();
  view();
});
addEventListener("resize", view);
addEventListener("pagehide", stop);
void begin();
