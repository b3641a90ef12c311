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

/** The largest accepted number: a body further away could not be found again. */
const FARTHEST = 1e5;

/** A field for a number; null leaves it empty. It keeps what is being typed when the page is rendered meanwhile. */
export function numberField(label: string, value: number | null, onTyped: (value: number) => void): View {
  const shown = value === null ? "" : String(Math.round(value * 100) / 100);
  return html`<label class="field">
    ${label} <input class="figure" type="number" step="any" .value=${shown} @change=${typed} />
  </label>`;

  function typed({ target }: Event): void {
    const field = target as HTMLInputElement;
    const now = field.valueAsNumber;
    // Reset a field that is empty or out of range.
    field.value = shown;
    if (Math.abs(now) <= FARTHEST) onTyped(now);
  }
}

/** A button that opens a file. */
export function fileButton(label: string, accept: string, onOpen: (file: File) => void): View {
  return html`<label class="button">
    ${label}<input type="file" class="unseen" accept=${accept} @change=${chosen} />
  </label>`;

  function chosen({ target }: Event): void {
    const input = target as HTMLInputElement;
    const [file] = input.files!;
    // Allow the same file to be opened again.
    input.value = "";
    if (file) onOpen(file);
  }
}
