// What the keyboard shortcuts of a puzzle act on. Those in the scene are in play/gestures.js, what the keys are is in
// widgets/shortcuts.js.

import { visibleTabs } from "../state/view.js";
import { onShortcut } from "../widgets/shortcuts.js";

/**
 * @typedef {object} ShortcutTarget
 * @property {import("./components.js").Components} components
 * @property {import("../play/session.js").Session | null} session
 * @property {import("../state/url-state.js").State} state
 * @property {(panel: import("../state/url-state.js").Panel) => void} showPanel
 * @property {() => void} showKeys
 * @property {() => void} togglePresentation
 */

/**
 * Acts on a shortcut.
 * @param {KeyboardEvent} event
 * @param {ShortcutTarget} target
 */
export function onPuzzleKey(event, { components, session, state, showPanel, showKeys, togglePresentation }) {
  const { canvas, panels } = components;
  // What a link for a lesson hides has no key either: no button leads away from what it shows.
  const locked = state.hide.includes("tools");
  panels?.presentation.onKeydown(event);
  onShortcut(event, {
    session,
    undoing: state.panel === "make" ? (panels?.editor ?? null) : (session?.placement ?? null),
    scene: canvas,
    showPanel: (index) => {
      const panel = visibleTabs(state)[index];
      if (panel) showPanel(panel);
    },
    showKeys: () => !locked && showKeys(),
    goToOtherOutcome: (by) => panels?.proposals.goToOtherOutcome(by),
    togglePresentation: () => !locked && togglePresentation(),
  });
}
