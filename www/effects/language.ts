// The language and theme of the page. Texts are loaded when they are needed.

import { setNotice, setText } from "../core/change/settings.ts";
import { isHome } from "../core/derived/home.ts";
import { language, theme } from "../core/derived/preferences.ts";
import { loadText } from "../text/languages.ts";
import type { State } from "../core/state.ts";
import type { Effect } from "../core/store.ts";

export const languageEffect: Effect<State> = {
  needs: (state) => [language(state)],
  async run(store, signal) {
    const text = await loadText(language(store.state)).catch(() => null);
    if (signal.aborted) return;
    if (text) store.change(setText, text);
    else store.change(setNotice, { kind: "no_text" });
  },
};

/** Applies them to the document, if the page is the whole document. */
export const documentEffect: Effect<State> = {
  needs: (state) => [theme(state), state.text, state.puzzle, isHome(state)],
  run({ state }) {
    const { documentElement: root } = document;
    root.dataset.theme = theme(state);
    root.lang = state.text.language;
    document.title = isHome(state) ? "Pathlight" : `${state.text.puzzle.name(state.puzzle.about)} · Pathlight`;
  },
};
