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
  return dialog;
}

/**
 * Closes what belongs to a puzzle that is left.
 * @param {ShadowRoot} root
 */
export function closeDialogs(root) {
  for (const dialog of root.querySelectorAll("dialog")) dialog.close();
  for (const menu of root.querySelectorAll("[popover]")) /** @type {HTMLElement} */ (menu).hidePopover();
}

/**
 * Lets each button with data-opens open the dialog of this id.
 * @param {ShadowRoot} root
 */
export function connectOpeners(root) {
  for (const button of root.querySelectorAll("button[data-opens]"))
    button.addEventListener("click", () => {
      const dialog = showDialog(root, button.getAttribute("data-opens") ?? "");
      // The menu that it was in has closed, so the focus cannot go back there.
      if (button.closest("[popover]"))
        dialog.addEventListener("close", () => byId(root, "more-button").focus(), { once: true });
    });
}
