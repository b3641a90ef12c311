// Assembles a puzzle: the store with its effects, the scene, and one frame loop that advances time, renders the
// document and paints the scene.

import { render } from "lit-html";
import { startModel } from "./core/change/model.ts";
import { moves, tick } from "./core/change/home.ts";
import { setDevice } from "./core/change/settings.ts";
import { shownSolution } from "./core/derived/check.ts";
import { introShown } from "./core/derived/home.ts";
import { start } from "./core/state.ts";
import { Store } from "./core/store.ts";
import { languageEffect } from "./effects/language.ts";
import { makingEffect } from "./effects/making.ts";
import { modelEffects } from "./effects/model.ts";
import { walkthroughEffect } from "./effects/walkthrough.ts";
import { listen } from "./stage/listen.ts";
import { LoadError } from "./model/loading.ts";
import { Stage } from "./stage/stage.ts";
import { toolOf } from "./stage/tools.ts";
import { loadText } from "./text/languages.ts";
import { keepingFocus } from "./view/focus.ts";
import { description } from "./view/news.ts";
import { page } from "./view/page.ts";
import { thumbnailsPainted } from "./simulator.ts";
import models from "../assets/model.json";
import type { Kept, Theme } from "./core/change/kept.ts";
import type { Language, Text } from "./text/languages.ts";
import type { Device } from "./core/change/settings.ts";
import type { Link } from "./core/change/route.ts";
import type { Puzzle } from "./core/puzzle.ts";
import type { State } from "./core/state.ts";
import type { Effect } from "./core/store.ts";
import type { ModelFiles } from "./model/shared.ts";
import type { App } from "./view/view.ts";

export interface Given {
  /** The element to render into. Its content is replaced. */
  readonly root: HTMLElement | ShadowRoot;
  /** Where to listen for keys that are not only for the scene. */
  readonly keys: Document | ShadowRoot;
  readonly link: Link;
  readonly puzzle: Puzzle;
  readonly kept: Kept;
  readonly files: Files;
  /** Embedded in another page, without the header. */
  readonly embedded: boolean;
  readonly language: Language;
  /** The theme that the embedding page asks for. */
  readonly theme: Theme | null;
  readonly text: Text;
  /** Effects in addition to those of the model and the language. */
  readonly effects: readonly Effect<State>[];
}

/** Addresses of the files that are loaded in addition to the scripts. */
export interface Files extends ModelFiles {
  readonly simulator: string;
}

/** `base` is the folder of the files, or a function that returns the address of each. */
export function filesAt(base: string | ((path: string) => string)): Files {
  const at = typeof base === "function" ? base : (path: string) => new URL(path, base).href;
  return {
    simulator: at("pkg/page/pathlight_bg.wasm"),
    wasm: at("pkg/worker/pathlight_bg.wasm"),
    worker: at("worker.js"),
    weights: Object.fromEntries(models.models.map(({ file }) => [file, at(`assets/${file}`)])),
  };
}

/** Longest time step, ms. A tab that slept resumes where it was. */
const LONGEST_FRAME = 100;

const dark = matchMedia("(prefers-color-scheme: dark)");
const still = matchMedia("(prefers-reduced-motion: reduce)");

/** Shows a puzzle until the signal is aborted. */
export async function mount(given: Given, signal: AbortSignal): Promise<App> {
  const { ball, ...route } = given.link;
  const device = (): Omit<Device, "asked"> => ({
    language: given.language,
    theme: dark.matches ? "dark" : "light",
    stillness: still.matches,
    day: today(),
  });
  // Start a new task, so that neither this one nor the previous one blocks the browser for long.
  await new Promise((resolve) => setTimeout(resolve));
  const { id } = given.puzzle.about;
  // The home page names no puzzle, although one is open on it.
  const isNamed = given.embedded || route.task !== null;
  const named = { ...route, task: isNamed ? id : null, scene: id === null ? route.scene : null };
  const first = start(named, given.puzzle, given.kept, { ...device(), asked: given.theme }, given.text, ball);
  // Buttons far below the scene show something in it.
  const inView: Effect<State> = {
    needs(state) {
      const shown = state.run?.balls ?? shownSolution(state);
      return shown && !given.embedded && !introShown(state) ? [shown] : null;
    },
    run: () => stage.canvas.scrollIntoView({ block: "nearest", behavior: still.matches ? "auto" : "smooth" }),
  };
  const store = new Store(first, [
    inView,
    languageEffect,
    walkthroughEffect,
    makingEffect,
    ...modelEffects(given.files),
    ...given.effects,
  ]);
  const stage = new Stage(() => store.state);
  const app: App = { store, canvas: stage.canvas, loupe: stage.loupe, embedded: given.embedded, parts: 1 };
  const root = given.root as HTMLElement;
  const rendering = keepingFocus(given.keys, stage.canvas);
  let frame = 0;
  let skipped = false;
  /** Time of the previous frame, while something plays. */
  let before: number | null = null;

  listen(stage, given.keys, store, signal);
  const follow = () => store.change(setDevice, device());
  for (const query of [dark, still]) query.addEventListener("change", follow, { signal });
  // It may be another day by then.
  document.addEventListener("visibilitychange", follow, { signal });
  // A page restored from the browser's cache continues as it was, but must load again what was loading.
  addEventListener("pageshow", ({ persisted }) => persisted && store.change(startModel), { signal });
  addEventListener("online", () => isOffline(store.state) && store.change(startModel), { signal });
  signal.addEventListener("abort", () => {
    store.stop();
    stage.stop();
    cancelAnimationFrame(frame);
  });
  root.replaceChildren();
  store.start(schedule);
  draw(performance.now());
  void showRest();
  return app;

  /** The first view waits neither for the rest of the page nor for the model. */
  async function showRest(): Promise<void> {
    for (const parts of [2, 3] as const) {
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      if (signal.aborted) return;
      app.parts = parts;
      schedule();
    }
    // On few cores, they and the model would hold each other up.
    await new Promise(requestAnimationFrame);
    await thumbnailsPainted();
    store.change(startModel);
  }

  function schedule(): void {
    frame ||= requestAnimationFrame((now) => {
      frame = 0;
      // Half of the frames are enough for the show: without a GPU each takes long to paint, and clicks wait for it.
      skipped = introShown(store.state) && !skipped;
      if (skipped) schedule();
      else draw(now);
    });
  }

  function draw(now: number): void {
    if (signal.aborted) return;
    const isPlaying = moves(store.state);
    // Each advance is a change, which schedules the next frame.
    if (isPlaying) store.change(tick, Math.min(Math.max(now - (before ?? now), 0), LONGEST_FRAME));
    before = isPlaying ? now : null;
    // Without a time step nothing has changed that would schedule the next frame.
    if (moves(store.state)) schedule();
    rendering(store.state.dialog, () => render(page(app), root));
    const described = description(store.state);
    if (stage.canvas.ariaLabel !== described) stage.canvas.ariaLabel = described;
    stage.canvas.classList.toggle("taken", toolOf(store.state).holds(store.state));
    stage.paint(store.state);
  }
}

function today(): number {
  const now = new Date();
  return Date.UTC(now.getFullYear(), now.getMonth(), now.getDate()) / 86_400_000;
}

function isOffline({ model }: State): boolean {
  return model.kind === "failed" && model.failure.code === "offline";
}

/** Explains why nothing can be shown, and what helps. */
export async function explained(error: unknown, language: Language): Promise<string> {
  const { page } = await loadText(language);
  return page.failure(error instanceof LoadError ? error.failure : { code: "broken", reason: String(error) });
}
