// The custom element <pathlight-puzzle>: one puzzle in any page. Importing this file defines the element:
//
//     <script type="module" src="…/element.js"></script>
//     <pathlight-puzzle task="00007:008" layers="base" remember></pathlight-puzzle>
//
// Its attributes are the parts of a link. They follow the person's actions, can be changed at any time, and are also
// properties. In addition, `theme` is "light" or "dark", `fill` takes the height of the container, and `remember` keeps
// attempts and choices in this browser (read once, when the puzzle is opened).

import { existing, follow, puzzleOf } from "./opening.ts";
import { explained, filesAt, mount } from "./app.ts";
import { NOTHING_KEPT } from "./core/change/kept.ts";
import { setDevice } from "./core/change/settings.ts";
import { attempts, toldAttempts } from "./core/derived/duel.ts";
import { theme } from "./core/derived/preferences.ts";
import { nextTask } from "./core/derived/next.ts";
import { LINK_PARTS, linkOf, readParts, writePart } from "./effects/address.ts";
import { keepingEffect, listenToOtherTabs, readKept } from "./effects/keeping.ts";
import { benchmark, loadSimulator } from "./simulator.ts";
import { languageOf, loadText } from "./text/languages.ts";
import css from "./style.css";
import type { Files } from "./app.ts";
import type { Theme } from "./core/change/kept.ts";
import type { Language } from "./text/languages.ts";
import type { Link } from "./core/change/route.ts";
import type { State } from "./core/state.ts";
import type { Effect } from "./core/store.ts";
import type { Ball } from "./pkg/page/pathlight.js";
import type { App } from "./view/view.ts";

/** The events of the element. All bubble. */
export interface PathlightPuzzleEventMap extends HTMLElementEventMap {
  /**
   * An attempt of the person has ended, or was left before its end. `task` is the digest of the scene if it is not a
   * task; `number` counts from 1.
   */
  attempt: CustomEvent<{ task: string; number: number; ball: Ball; solved: boolean }>;
  /** The model was loaded, unloaded or failed; `name` is its name, if it is loaded. */
  modelchange: CustomEvent<{ name: string | null; status: "off" | "loading" | "ready" | "failed" }>;
  /** The person has changed the view: the current attributes, null for those that are not set. */
  statechange: CustomEvent<Record<string, string | null>>;
}

/** Types of event listeners. */
export interface PathlightPuzzle {
  addEventListener<Type extends keyof PathlightPuzzleEventMap>(
    type: Type,
    listener: (this: PathlightPuzzle, event: PathlightPuzzleEventMap[Type]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<Type extends keyof PathlightPuzzleEventMap>(
    type: Type,
    listener: (this: PathlightPuzzle, event: PathlightPuzzleEventMap[Type]) => unknown,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}

declare global {
  interface HTMLElementTagNameMap {
    "pathlight-puzzle": PathlightPuzzle;
  }
}

/** Why the attributes name no puzzle, in the language of the element. */
class Refusal extends Error {}

const PROPERTIES = [...LINK_PARTS, "theme"] as const;

export class PathlightPuzzle extends HTMLElement {
  static observedAttributes: readonly string[] = PROPERTIES;

  /**
   * The address of the folder that holds worker.js, pkg/ and assets/, or a function that returns the address of each of
   * these files by its path; by default the folder of this script. Set it before an element is connected if the script
   * has no address, as in a blob.
   */
  static base: string | ((path: string) => string) | null = null;

  /** The puzzle, "00007:008"; null for one that is new to person and model. */
  declare task: string | null;
  /** A custom scene instead of a task, as in its link; null for none. */
  declare scene: string | null;
  /** The panel next to the scene; null for "play". */
  declare panel: string | null;
  /** The maps over the scene, separated by commas; null for none. */
  declare layers: string | null;
  /** The step of the walkthrough in the panel "imagine"; null for everything that the model imagines. */
  declare step: string | null;
  /** "presentation" for the scene and one sentence in large type; null for the whole puzzle. */
  declare view: string | null;
  /** The number of attempts to beat; null for none. */
  declare challenge: string | null;
  /** The puzzles of a lesson in order, separated by commas; null for none. */
  declare lesson: string | null;
  /** The hidden parts, separated by commas; null for none. */
  declare hide: string | null;
  /** The ball that is being placed: "x,y,r" in px of the scene; null for none. */
  declare ball: string | null;
  /** "light" or "dark"; null to follow the system. */
  declare theme: string | null;

  static {
    for (const name of PROPERTIES) {
      Object.defineProperty(this.prototype, name, {
        get(this: PathlightPuzzle) {
          return this.getAttribute(name);
        },
        set(this: PathlightPuzzle, value: unknown) {
          setAttribute(this, name, value === null || value === undefined ? null : String(value));
        },
      });
    }
  }

  #root = this.attachShadow({ mode: "open" });
  #app: App | null = null;
  #leaving: AbortController | null = null;
  /** Whether the attributes name no puzzle. */
  #isRefused = false;
  /** Whether attributes are being set from the state, which must not count as a request. */
  #isFollowing = false;

  connectedCallback(): void {
    if (this.#leaving) return;
    // Properties set before the element was defined hide the accessors.
    for (const name of PROPERTIES) {
      if (!Object.hasOwn(this, name)) continue;
      const value = this[name];
      Reflect.deleteProperty(this, name);
      this[name] = value;
    }
    this.#leaving = new AbortController();
    this.#isRefused = false;
    this.#start(this.#leaving.signal).catch(async (error) => {
      reportError(error);
      this.#isRefused = error instanceof Refusal;
      this.#root.replaceChildren(this.#isRefused ? error.message : await explained(error, this.#language()));
    });
  }

  disconnectedCallback(): void {
    // An element that is moved within its page is reconnected at once and keeps its puzzle.
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.#leaving?.abort();
      this.#leaving = this.#app = null;
    });
  }

  attributeChangedCallback(name: string, before: string | null, now: string | null): void {
    if (this.#isFollowing || before === now) return;
    if (this.#isRefused && this.isConnected) {
      this.#leaving = null;
      this.connectedCallback();
    }
    if (!this.#app) return;
    const { store } = this.#app;
    if (name === "theme") return store.change(setDevice, { asked: themeOf(now) });
    const read = readParts(this.#parts(), store.state.text).link;
    // The attribute set last names the puzzle.
    const link = name === "task" && now !== null ? { ...read, scene: null } : read;
    const { task, scene } = store.state.route;
    const isElsewhere = (link.task !== null && link.task !== task) || (link.scene !== null && link.scene !== scene);
    const named = (link.task ?? link.scene) ? link : { ...link, task, scene };
    if (!isElsewhere || name === "ball") return follow(store, named);
    // Parts that belong to one puzzle do not carry over to the next.
    for (const part of ["ball", name === "task" ? "scene" : "task"] as const)
      if (part !== name) this.#write(part, null);
    follow(store, { ...named, ball: null });
  }

  /** Focuses the scene. */
  override focus(options?: FocusOptions): void {
    this.#app?.canvas.focus(options);
  }

  async #start(signal: AbortSignal): Promise<void> {
    const files = PathlightPuzzle.base === null ? filesHere() : filesAt(PathlightPuzzle.base);
    const remembers = isOn(this, "remember");
    const kept = remembers ? readKept() : NOTHING_KEPT;
    const language = this.#language();
    const [text] = await Promise.all([loadText(kept.language ?? language), loadSimulator(files.simulator)]);
    if (signal.aborted) return;
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(css);
    this.#root.adoptedStyleSheets = [sheet];
    const { link } = readParts(this.#parts(), text);
    const shared = link.scene === null ? null : await puzzleOf(link.scene);
    if (signal.aborted) return;
    if (shared && "problem" in shared) throw new Refusal(text.page.notice({ kind: "bad_scene", ...shared }));
    const task = link.task ?? nextTask(benchmark(kept.model), null, (task) => task in kept.attempts);
    const puzzle = shared ?? existing(task);
    if (!puzzle) throw new Refusal(text.page.notice({ kind: "no_task", task }));
    const told = [this.#attributes(), this.#attempts(), this.#model()];
    const effects = [...told, ...(remembers ? [keepingEffect()] : [])];
    const shown = { link, puzzle, kept, language, theme: themeOf(this.getAttribute("theme")), text };
    const given = { root: this.#root, keys: this.#root, ...shown, files, embedded: true, effects };
    const app = await mount(given, signal);
    if (signal.aborted) return;
    this.#app = app;
    if (remembers) listenToOtherTabs(app.store, signal);
  }

  #language(): Language {
    return languageOf(this.closest("[lang]")?.getAttribute("lang") ?? navigator.language) ?? "en";
  }

  /** The attributes that are parts of a link. */
  *#parts(): Generator<[string, string]> {
    for (const part of LINK_PARTS) {
      const text = this.getAttribute(part);
      if (text !== null) yield [part, text];
    }
  }

  #write(part: keyof Link, text: string | null): void {
    this.#isFollowing = true;
    setAttribute(this, part, text);
    this.#isFollowing = false;
  }

  #tell<Type extends "attempt" | "modelchange" | "statechange">(
    type: Type,
    detail: PathlightPuzzleEventMap[Type]["detail"],
  ): void {
    this.dispatchEvent(new CustomEvent(type, { detail, bubbles: true }));
  }

  /** Keeps the attributes in sync with the state. Their initial values are not a change by the person. */
  #attributes(): Effect<State> {
    let begun = false;
    return {
      needs: (state) => [theme(state), ...LINK_PARTS.map((part) => writePart(linkOf(state), part))],
      run: ({ state }) => {
        this.dataset.theme = theme(state);
        const texts = LINK_PARTS.map((part) => [part, writePart(linkOf(state), part)] as const);
        const changed = texts.filter(([part, text]) => text !== this.getAttribute(part));
        for (const [part, text] of changed) this.#write(part, text);
        if (begun && changed.length > 0) this.#tell("statechange", Object.fromEntries(texts));
        begun = true;
      },
    };
  }

  #attempts(): Effect<State> {
    let before: State | null = null;
    /** The number of the attempt whose outcome has not been reported. */
    let running: number | null = null;
    return {
      needs: (state) => [state.puzzle, attempts(state).length, toldAttempts(state).length],
      run: ({ state }) => {
        const isElsewhere = before?.puzzle !== state.puzzle;
        const there = isElsewhere ? before : state;
        // Attempts from other tabs are not the current round.
        if (before && !isElsewhere && attempts(state).length > attempts(before).length)
          running = state.run?.round === attempts(state).length ? state.run.round : running;
        if (there && running !== null && (isElsewhere || running <= toldAttempts(state).length)) {
          const { ball, status } = attempts(there)[running - 1]!;
          const solved = status === "solved";
          this.#tell("attempt", { task: there.puzzle.key, number: running, ball: ball!, solved });
          running = null;
        }
        before = state;
      },
    };
  }

  #model(): Effect<State> {
    return {
      needs: ({ model }) => [model.kind],
      run: ({ state: { model } }) =>
        this.#tell("modelchange", { name: model.kind === "ready" ? model.name : null, status: model.kind }),
    };
  }
}

/** Bundlers find a file only by its literal address, which is relative to the bundle. */
function filesHere(): Files {
  return {
    simulator: new URL("./pkg/page/pathlight_bg.wasm", import.meta.url).href,
    wasm: new URL("./pkg/worker/pathlight_bg.wasm", import.meta.url).href,
    worker: new URL("./worker.js", import.meta.url).href,
    weights: { "within-0.safetensors": new URL("./assets/within-0.safetensors", import.meta.url).href },
  };
}

function setAttribute(element: Element, name: string, value: string | null): void {
  if (value === null) element.removeAttribute(name);
  else if (value !== element.getAttribute(name)) element.setAttribute(name, value);
}

/** React 18 writes `remember={false}` as "false". */
function isOn(element: Element, name: string): boolean {
  return element.hasAttribute(name) && element.getAttribute(name) !== "false";
}

function themeOf(attribute: string | null): Theme | null {
  return attribute === "light" || attribute === "dark" ? attribute : null;
}

// Checks that each part of a link is a property.
({}) as PathlightPuzzle satisfies Record<keyof Link, string | null>;

if (!customElements.get("pathlight-puzzle")) customElements.define("pathlight-puzzle", PathlightPuzzle);
