// Hides the parts that a link hides: elements with data-hideable="name …", which names what they belong to. Something
// that belongs to several parts is hidden only if all of them are. The names are HIDEABLE's in url-state.js.

/**
 * @param {import("./dom.js").Root} root
 * @param {readonly string[]} hide
 */
export function hideParts(root, hide) {
  for (const element of root.querySelectorAll("[data-hideable]")) {
    const parts = element.getAttribute("data-hideable")?.split(" ") ?? [];
    element.classList.toggle(
      "hidden-by-link",
      parts.every((part) => hide.includes(part)),
    );
  }
}
