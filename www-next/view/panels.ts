// The panels beside the scene. To add one: name it in core/change/route.ts, and here.

import { html, nothing } from "lit-html";
import { PANELS, openPanel } from "../core/change/route.ts";
import { make } from "./make.ts";
import { play } from "./play.ts";
import type { Panel } from "../core/change/route.ts";
import type { Text } from "../text/text.ts";
import type { App, View } from "./view.ts";

const VIEWS: Record<Panel, { tab(text: Text): string; view(app: App): View }> = {
  play: { tab: (text) => text.play.tab, view: play },
  make: { tab: (text) => text.make.tab, view: make },
};

export function panels(app: App): View {
  const { route, text } = app.store.state;
  return html`${PANELS.length > 1 ? tabs(app) : nothing}
    <div class="panel" role=${PANELS.length > 1 ? "tabpanel" : nothing} aria-label=${VIEWS[route.panel].tab(text)}>
      ${VIEWS[route.panel].view(app)}
    </div>`;
}

function tabs({ store }: App): View {
  const { route, text } = store.state;
  return html`<div class="tabs" role="tablist" aria-label=${text.page.tabs}>
    ${PANELS.map(
      (panel) =>
        html`<button
          role="tab"
          aria-selected=${panel === route.panel}
          tabindex=${panel === route.panel ? 0 : -1}
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
    const to = PANELS.at((PANELS.indexOf(from) + places) % PANELS.length)!;
    store.change(openPanel, to);
    const tab = (event.currentTarget as HTMLElement).parentElement!.children[PANELS.indexOf(to)];
    (tab as HTMLElement).focus();
  }
}
