// Controls that several views use.

import { html } from "lit-html";
import { live } from "lit-html/directives/live.js";
import type { View } from "./view.ts";

export function checkbox(checked: boolean, label: string, onChange: (checked: boolean) => void): View {
  return html`<label class="switch">
    <input
      type="checkbox"
      .checked=${live(checked)}
      @change=${({ target }: Event) => onChange((target as HTMLInputElement).checked)}
    />
    ${label}
  </label>`;
}
