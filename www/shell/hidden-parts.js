// Hides the parts of the page that the link hides: elements with data-hideable="name …", which names what they belong to.
// Something that belongs to several parts is hidden with the last of them. The names are HIDEABLE's in url-state.js.

import { Component } from "./component.js";
import { byId } from "./dom.js";
import { hrefOf } from "./url-state.js";

export class HiddenParts extends Component {
  /** @param {import("./url-state.js").View} view */
  setState(view) {
    const hidden = /** @type {string[]} */ (view.hide);
    for (const element of document.querySelectorAll("[data-hideable]")) {
      const parts = element.getAttribute("data-hideable")?.split(" ") ?? [];
      element.classList.toggle("hidden-by-link", parts.every((part) => hidden.includes(part)));
    }
    const home = byId("home", HTMLAnchorElement);
    const gallery = hrefOf(view, null);
    if (gallery) home.href = gallery;
    else home.removeAttribute("href");
  }
}
