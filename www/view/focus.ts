// Keeps the focus when the focused element is removed or disabled: it moves to the control that opened the dialog, to
// the tab of the panel that was left, or to the scene.

import type { Dialog } from "../core/change/dialog.ts";

/** Renders the document by `draw`. */
export type Rendering = (dialog: Dialog | null, draw: () => void) => void;

/** `root` contains everything that is rendered. */
export function keepingFocus(root: Document | ShadowRoot, scene: HTMLElement): Rendering {
  let shown: Dialog | null = null;
  let opener: Element | null = null;
  return (dialog, draw) => {
    const focused = root.activeElement;
    const panel = nameOf(focused?.closest(PANEL));
    if (dialog && !shown) opener = focused;
    draw();
    if (shown && !dialog && !hasFocus()) focus(placeOf(opener));
    else if (focused && (!focused.isConnected || focused.matches(":disabled")))
      focus(panel && panel !== nameOf(root.querySelector(PANEL)) ? root.querySelector(TAB) : scene);
    shown = dialog;
  };

  function hasFocus(): boolean {
    return root.activeElement !== null && root.activeElement !== document.body;
  }

  function focus(element: Element | null | undefined): void {
    ((element as HTMLElement | null) ?? scene).focus({ preventScroll: true });
  }
}

const PANEL = "[role=tabpanel]";
const TAB = "[role=tab][aria-selected=true]";

function nameOf(panel: Element | null | undefined): string | null | undefined {
  return panel?.getAttribute("aria-label");
}

/** An item of the menu is hidden again; return the button of the menu, which precedes it. */
function placeOf(opener: Element | null): Element | null | undefined {
  const places = [opener, opener?.closest("[popover]")?.previousElementSibling];
  return places.find((place) => place?.checkVisibility() && !place.matches(":disabled"));
}
