// The custom element <pathlight-puzzle>: one puzzle in any page. Importing this file defines the element:
//
//     <script type="module" src="…/element.js"></script>
//     <pathlight-puzzle task="00007:008" layers="base" remember></pathlight-puzzle>
//
// Its attributes are the parts of a link, follow the person, and can be changed at any time; besides, `theme` is
// "light" or "dark", and `remember` keeps attempts and choices in this browser (read once, when the puzzle is opened).

import { follow, puzzleOf } from "./actions.ts";
import { filesAt, languageOf, mount } from "./app.ts";
import { NOTHING_KEPT, choose } from "./core/change/kept.ts";
import { theme } from "./core/derived/looks.ts";
import { nextTask } from "./core/derived/next.ts";
import { LINK_PARTS, linkOf, readParts, writePart } from "./effects/address.ts";
import { keepingEffect, listenToOtherTabs, readKept } from "./effects/keeping.ts";
import { benchmark, loadSimulator, openPuzzle } from "./simulator.ts";
import css from "./style.css";
import type { Theme } from "./core/change/kept.ts";
import type { State } from "./core/state.ts";
import type { Effect } from "./core/store.ts";
import type { App } from "./view/view.ts";

export class PathlightPuzzle extends HTMLElement {
  static observedAttributes = [...LINK_PARTS, "theme"];

  /** Where worker, wasm and weights lie; by default beside this script. Set it before the element is connected. */
  static base: string | null = null;

  #root = this.attachShadow({ mode: "open" });
  #app: App | null = null;
  #leaving: AbortController | null = null;
  /** Its attributes follow the state, and must not be taken for a wish. */
  #isFollowing = false;

  connectedCallback(): void {
    if (this.#leaving) return;
    this.#leaving = new AbortController();
    this.#start(this.#leaving.signal).catch((error) => {
      reportError(error);
      this.#root.replaceChildren(String(error.message));
    });
  }

  disconnectedCallback(): void {
    // One that is moved within its page is connected again at once, and keeps its puzzle.
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.#leaving?.abort();
      this.#leaving = this.#app = null;
    });
  }

  attributeChangedCallback(name: string, before: string | null, now: string | null): void {
    if (!this.#app || this.#isFollowing || before === now) return;
    const { store } = this.#app;
    if (name === "theme") return store.change(choose, { theme: themeOf(now) });
    const read = readParts(this.#parts()).link;
    // The attribute that has been set last names the puzzle.
    const link = name === "task" && now !== null ? { ...read, scene: null } : read;
    const { task, scene } = store.state.route;
    const isElsewhere = (link.task !== null && link.task !== task) || (link.scene !== null && link.scene !== scene);
    const named = (link.task ?? link.scene) ? link : { ...link, task, scene };
    follow(store, isElsewhere && name !== "ball" ? { ...named, ball: null } : named);
  }

  async #start(signal: AbortSignal): Promise<void> {
    const files = filesAt(PathlightPuzzle.base ?? import.meta.url);
    await loadSimulator(files.simulator);
    if (signal.aborted) return;
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(css);
    this.#root.adoptedStyleSheets = [sheet];
    const { link } = readParts(this.#parts());
    const remembers = this.hasAttribute("remember");
    const kept = { ...(remembers ? readKept() : NOTHING_KEPT), theme: themeOf(this.getAttribute("theme")) };
    const shared = link.scene === null ? null : await puzzleOf(link.scene);
    if (signal.aborted) return;
    if (shared && "problem" in shared) throw new Error("The attribute scene holds no puzzle that may be played.");
    const puzzle = shared ?? openPuzzle(link.task ?? nextTask(benchmark(), null, (task) => task in kept.attempts));
    const language = languageOf(this.closest("[lang]")?.getAttribute("lang") ?? navigator.language);
    const effects = [this.#attributes(), ...(remembers ? [keepingEffect()] : [])];
    const given = { root: this.#root, keys: this.#root, link, puzzle, kept, files, embedded: true, language, effects };
    const app = await mount(given, signal);
    if (signal.aborted) return;
    this.#app = app;
    if (remembers) listenToOtherTabs(app.store, signal);
  }

  /** The attributes that are parts of a link. */
  *#parts(): Generator<[string, string]> {
    for (const part of LINK_PARTS) {
      const text = this.getAttribute(part);
      if (text !== null) yield [part, text];
    }
  }

  /** Keeps the attributes as the state is. */
  #attributes(): Effect<State> {
    return {
      needs: (state) => [theme(state), ...LINK_PARTS.map((part) => writePart(linkOf(state), part))],
      run: ({ state }) => {
        this.#isFollowing = true;
        for (const part of LINK_PARTS) {
          const text = writePart(linkOf(state), part);
          if (text === null) this.removeAttribute(part);
          else if (text !== this.getAttribute(part)) this.setAttribute(part, text);
        }
        this.dataset.theme = theme(state);
        this.#isFollowing = false;
      },
    };
  }
}

function themeOf(attribute: string | null): Theme | null {
  return attribute === "light" || attribute === "dark" ? attribute : null;
}

if (!customElements.get("pathlight-puzzle")) customElements.define("pathlight-puzzle", PathlightPuzzle);
