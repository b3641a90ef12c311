// The panels next to the scene. The texts of their tabs name them.

import { html, nothing } from "lit-html";
import { openPanel } from "../core/change/route.ts";
import { shownPanel, shownPanels } from "../core/derived/hidden.ts";
import { data } from "./data.ts";
import { imagine } from "./imagine.ts";
import { make } from "./make.ts";
import { play } from "./play.ts";
import { predict } from "./predict.ts";
import type { Panel } from "../core/change/route.ts";
import type { App, View } from "./view.ts";

const VIEWS: Record<Panel, (app: App) => View> = { play, imagine, predict, make, data };

export function panels(app: App): View {
  const { state } = app.store;
  const panel = shownPanel(state);
  const hasTabs = shownPanels(state).length > 1;
  return html`${hasTabs ? tabs(app) : nothing}
    <div class="panel" role=${hasTabs ? "tabpanel" : nothing} aria-label=${state.text.tabs[panel]}>
      ${VIEWS[panel](app)}
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
          ${text.tabs[panel]}
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
