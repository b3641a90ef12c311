// The dialogs of a puzzle, and the buttons that open them.

import { byId } from "../widgets/dom.js";

/**
 * @param {ShadowRoot} root
 * @param {string} id
 */
export function showDialog(root, id) {
  const dialog = byId(root, id, HTMLDialogElement);
  dialog.showModal();
  // Its heading, so that it is read from the beginning. In frames browsers refuse the attribute autofocus.
  dialog.querySelector("h2")?.focus();
}

/**
 * Lets each button with data-opens open the dialog of this id.
 * @param {ShadowRoot} root
 */
export function connectOpeners(root) {
  for (const button of root.querySelectorAll("button[data-opens]"))
    button.addEventListener("click", () => showDialog(root, button.getAttribute("data-opens") ?? ""));
}
