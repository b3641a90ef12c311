// The icons of the page, drawn in the colour of the text.

import { svg, html } from "lit-html";
import type { View } from "./view.ts";

const ICONS = {
  brand: svg`<path d="M3 20h18" class="line"/><circle cx="7" cy="6" r="3"/><path d="M9 9q2 8 9 8" class="line dotted"/>`,
  previous: svg`<path d="M15.5 5 8.5 12l7 7" class="line"/>`,
  next: svg`<path d="m8.5 5 7 7-7 7" class="line"/>`,
  menu: svg`<path d="M4 7h16M4 12h16M4 17h16" class="line"/>`,
  share: svg`<path d="M12 15V4M8 7.5 12 3.5l4 4M6 11H4.5v9.5h15V11H18" class="line"/>`,
  tour: svg`<path d="M8 5v14l11-7z"/>`,
  stop: svg`<path d="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z"/>`,
  replay: svg`<path d="M5 12a7 7 0 1 0 2.5-5.4M5 4v4h4" class="line"/>`,
};

export function icon(name: keyof typeof ICONS): View {
  return html`<svg viewBox="0 0 24 24" aria-hidden="true">${ICONS[name]}</svg>`;
}
