// The keyboard shortcuts of the whole page; those of the scene are in play/canvas.js. A number field, a list and a dialog
// keep their own keys.

/** @typedef {import("../play/session.js").Session} Session */

/**
 * What the shortcuts act on. The session is null on the grid.
 * @typedef {object} ShortcutTarget
 * @property {Session | null} session
 * @property {{ onKeydown(event: KeyboardEvent): void }} scene
 * @property {(offset: number) => void} stepPuzzle
 * @property {(index: number) => void} showPanel
 * @property {() => void} showKeys
 */

const OWN_KEYS = "input[type=number], select, dialog";

/**
 * Listens for as long as the page lives.
 * @param {ShortcutTarget} page
 */
export function listenForShortcuts(page) {
  document.addEventListener("keydown", (event) => {
    const { ctrlKey, metaKey, altKey, target } = event;
    if (event.defaultPrevented || altKey || !(target instanceof Element)) return;
    const act = ctrlKey || metaKey ? undoAction(event, target, page.session) : plainAction(event, target, page);
    if (act) {
      event.preventDefault();
      act();
    } else if (target === document.body && page.session) {
      // Nothing has the focus, as after a button that is disabled now: the arrows mean the ball.
      page.scene.onKeydown(event);
    }
  });
}

/**
 * Ctrl+Z, Ctrl+Y and Ctrl+Shift+Z, with Cmd too. In a field as well: there the browser would undo what was typed in
 * another field, and the page would not hear of it.
 * @param {KeyboardEvent} event
 * @param {Element} target
 * @param {Session | null} session
 * @returns {(() => void) | undefined}
 */
function undoAction({ key, shiftKey }, target, session) {
  if (!session || target.closest("dialog")) return undefined;
  /** @type {Record<string, () => void>} */
  const actions = { z: () => (shiftKey ? session.redo() : session.undo()), y: () => session.redo() };
  return actions[key.toLowerCase()];
}

/**
 * @param {KeyboardEvent} event
 * @param {Element} target
 * @param {ShortcutTarget} page
 * @returns {(() => void) | undefined}
 */
function plainAction({ key }, target, page) {
  if (target.closest(OWN_KEYS)) return undefined;
  if (key === "?") return () => page.showKeys();
  const { session } = page;
  // Space keeps its meaning where it has one.
  if (!session || (key === " " && target.closest("button, a, input, summary"))) return undefined;
  if (/^[1-9]$/.test(key)) return () => page.showPanel(Number(key) - 1);
  /** @type {Record<string, () => void>} */
  const actions = {
    " ": () => session.run(),
    ".": () => session.step(1),
    ",": () => session.step(-1),
    r: () => session.reset(),
    "[": () => page.stepPuzzle(-1),
    "]": () => page.stepPuzzle(1),
  };
  return actions[key.toLowerCase()];
}
