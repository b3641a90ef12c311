// The keys of the whole page; those of the scene are in canvas.js. A field, a list and a dialog keep theirs.

const FIELDS = "input[type=number], select, dialog";

/** Listens for good. `page`: { session, scene, turn(by), panel(index), help() }; its session is null on the grid. */
export function listen(page) {
  document.addEventListener("keydown", (event) => {
    const { ctrlKey, metaKey, altKey, target } = event;
    if (event.defaultPrevented || altKey) return;
    const act = ctrlKey || metaKey ? undoing(event, page.session) : plain(event, page);
    if (act) {
      event.preventDefault();
      act();
    } else if (target === document.body && page.session) {
      // Nothing has the focus, as after a button that is disabled now: the arrows mean the ball.
      page.scene.key(event);
    }
  });
}

/** Ctrl+Z, Ctrl+Y and Ctrl+Shift+Z, with Cmd too. In a field as well: there the browser would take back what was
 * typed in another field, without a word to the page. */
function undoing({ key, shiftKey, target }, session) {
  if (!session || target.closest("dialog")) return undefined;
  return { z: () => (shiftKey ? session.redo() : session.undo()), y: () => session.redo() }[key.toLowerCase()];
}

function plain({ key, target }, page) {
  if (target.closest(FIELDS)) return undefined;
  if (key === "?") return () => page.help();
  const { session } = page;
  // Where Space has its own meaning it keeps it.
  if (!session || (key === " " && target.closest("button, a, input, summary"))) return undefined;
  const keys = {
    " ": () => session.run(),
    ".": () => session.step(1),
    ",": () => session.step(-1),
    r: () => session.reset(),
    "[": () => page.turn(-1),
    "]": () => page.turn(1),
  };
  if (/^[1-9]$/.test(key)) return () => page.panel(Number(key) - 1);
  return keys[key.toLowerCase()];
}
