// The keyboard shortcuts of a puzzle; those of its scene are in play/gestures.js. A field that is typed in, a list, a
// dialog and a menu keep their own keys.

import { visibleTabs } from "../state/view.js";

/**
 * What the shortcuts act on. The session is null while no puzzle is open.
 * @typedef {object} ShortcutTarget
 * @property {import("./components.js").Components} components
 * @property {import("../play/session.js").Session | null} session
 * @property {import("../state/url-state.js").State} state
 * @property {(panel: import("../state/url-state.js").Panel) => void} showPanel
 * @property {() => void} showKeys
 * @property {() => void} togglePresentation
 */

const OWN_KEYS = "input:not([type=range], [type=checkbox], [type=radio]), select, dialog, [popover]";

/**
 * Acts on a key that was pressed in the puzzle, or in the page with the focus nowhere.
 * @param {KeyboardEvent} event
 * @param {ShortcutTarget} puzzle
 */
export function onPuzzleKey(event, puzzle) {
  const { canvas, panels } = puzzle.components;
  panels?.presentation.onKeydown(event);
  const { ctrlKey, metaKey, altKey, target } = event;
  if (event.defaultPrevented || altKey || !(target instanceof Element)) return;
  const act = ctrlKey || metaKey ? undoAction(event, target, puzzle) : plainAction(event, target, puzzle);
  if (act) {
    event.preventDefault();
    act();
  } else if (target.matches("body") && puzzle.session) {
    // Nothing has the focus, as after a button that is disabled now: the arrows mean the ball.
    canvas.onKeydown(event);
  }
}

/**
 * Does the element where a key was pressed leave the plain keys to shortcuts?
 * @param {EventTarget | undefined} target
 */
export function leavesPlainKeys(target) {
  return target instanceof Element && !target.closest(OWN_KEYS);
}

/**
 * Is a dialog of the page or of a puzzle open? All of them are modal: nothing behind them may be used.
 * @param {ParentNode | null} root
 */
export function showsDialog(root) {
  return Boolean(root?.querySelector("dialog[open]"));
}

/**
 * Is Ctrl or Cmd held, so that the key is a command? AltGr, which counts as Ctrl and Alt, and Option type characters,
 * such as the brackets on German keyboards.
 * @param {KeyboardEvent} event
 */
export function isChord({ ctrlKey, metaKey, altKey }) {
  return metaKey || (ctrlKey && !altKey);
}

/**
 * Ctrl+Z, Ctrl+Y and Ctrl+Shift+Z, with Cmd too. In a field of numbers as well: there the browser would undo what was
 * typed in another field, and the page would not hear of it.
 * @param {KeyboardEvent} event
 * @param {Element} target
 * @param {ShortcutTarget} puzzle
 * @returns {(() => void) | undefined}
 */
function undoAction({ key, shiftKey }, target, { components, session, state }) {
  const undoing = state.panel === "make" ? components.panels?.editor : session?.placement;
  if (!undoing || target.closest("dialog, input[type=text]")) return undefined;
  /** @type {Record<string, () => unknown>} */
  const actions = { z: () => (shiftKey ? undoing.redo() : undoing.undo()), y: () => undoing.redo() };
  return actions[key.toLowerCase()];
}

/**
 * @param {KeyboardEvent} event
 * @param {Element} target
 * @param {ShortcutTarget} puzzle
 * @returns {(() => unknown) | undefined}
 */
function plainAction({ key, shiftKey, repeat }, target, { components, session, state, ...puzzle }) {
  if (!leavesPlainKeys(target)) return undefined;
  // What a link for a lesson hides has no key either: no button leads away from what it shows.
  const locked = state.hide.includes("tools");
  if (key === "?") return () => !locked && puzzle.showKeys();
  // Space keeps its meaning where it has one.
  if (!session || (key === " " && target.closest("button, a, input, summary"))) return undefined;
  if (/^[1-9]$/.test(key)) {
    const panel = visibleTabs(state)[Number(key) - 1];
    return () => panel && puzzle.showPanel(panel);
  }
  /** @type {Record<string, () => unknown>} */
  const actions = {
    // A key that is held down runs once.
    " ": () => repeat || session.run(),
    ".": () => session.step(1),
    ",": () => session.step(-1),
    r: () => session.reset(),
    v: () => repeat || locked || puzzle.togglePresentation(),
    n: () => components.panels?.proposals.goToOtherOutcome(shiftKey ? -1 : 1),
  };
  return actions[key.toLowerCase()];
}
