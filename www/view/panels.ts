// The panels next to the scene. To add one, name it in core/change/route.ts and here.

import { html, nothing } from "lit-html";
import { openPanel } from "../core/change/route.ts";
import { shownPanel, shownPanels } from "../core/derived/hidden.ts";
import { data } from "./data.ts";
import { imagine } from "./imagine.ts";
import { make } from "./make.ts";
import { play } from "./play.ts";
import { predict } from "./predict.ts";
import type { Panel } from "../core/change/route.ts";
import type { Text } from "../text/languages.ts";
import type { App, View } from "./view.ts";

const VIEWS: Record<Panel, { tab(text: Text): string; view(app: App): View }> = {
  play: { tab: (text) => text.play.tab, view: play },
  imagine: { tab: (text) => text.imagine.tab, view: imagine },
  predict: { tab: (text) => text.predict.tab, view: predict },
  make: { tab: (text) => text.make.tab, view: make },
  data: { tab: (text) => text.data.tab, view: data },
};

export function panels(app: App): View {
  const { state } = app.store;
  const panel = VIEWS[shownPanel(state)];
  const hasTabs = shownPanels(state).length > 1;
  return html`${hasTabs ? tabs(app) : nothing}
    <div class="panel" role=${hasTabs ? "tabpanel" : nothing} aria-label=${panel.tab(state.text)}>
      ${panel.view(app)}
    </div>`;
}

function tabs({ store }: App): View {
  const { text } = store.state;
  const panels = shownPanels(store.state);
  const open = shownPanel(store.state);
  return html`<div class="tabs" role="tablist" aria-label=${text.page.tabs}>
    ${panels.map(
      (panel) =>
        html`<button
          role="tab"
          aria-selected=${panel === open}
          tabindex=${panel === open ? 0 : -1}
          @click=${() => store.change(openPanel, panel)}
          @keydown=${(event: KeyboardEvent) => moved(event, panel)}
        >
          ${VIEWS[panel].tab(text)}
        </button>`,
    )}
  </div>`;

  function moved(event: KeyboardEvent, from: Panel): void {
    const places = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!places) return;
    const to = panels.at((panels.indexOf(from) + places) % panels.length)!;
    store.change(openPanel, to);
    const tab = (event.currentTarget as HTMLElement).parentElement!.children[panels.indexOf(to)];
    (tab as HTMLElement).focus();
  }
}
