// The bodies of the edited scene as a list to select from, and the numbers of the selected one as fields.

import { text } from "../text/text.js";
import { Component } from "../widgets/component.js";
import { createButton, setText } from "../widgets/dom.js";
import { SIZES, sizeOf } from "./body-geometry.js";
import { degreesOf, nameOf, roleOf, rounded } from "./body-words.js";

/** @typedef {import("./edited-scene.js").EditedScene} EditedScene */

/** The largest number that is taken from a field, px or degrees. */
const FARTHEST = 1e5;

export class BodyFields extends Component {
  /** @type {EditedScene | null} */
  #edited = null;
  #list = this.byId("make-bodies");
  #fields = {
    x: this.byId("make-x", HTMLInputElement),
    y: this.byId("make-y", HTMLInputElement),
    angle: this.byId("make-angle", HTMLInputElement),
    size: this.byId("make-size", HTMLInputElement),
    thickness: this.byId("make-thickness", HTMLInputElement),
  };
  #dynamic = this.byId("make-dynamic", HTMLInputElement);

  /** @param {import("../widgets/dom.js").Root} root */
  constructor(root) {
    super(root);
    this.byId("make-fields").addEventListener("submit", (event) => event.preventDefault());
    for (const [name, field] of Object.entries(this.#fields)) {
      field.addEventListener("change", () => this.#onTyped(name, field.valueAsNumber));
    }
    this.#dynamic.addEventListener("change", () => this.#edited?.setDynamic(this.#dynamic.checked));
    this.byId("make-object").addEventListener("click", () => this.#edited?.makeObject());
    this.byId("make-goal").addEventListener("click", () => this.#edited?.makeGoal());
    this.byId("make-duplicate").addEventListener("click", () => this.#edited?.duplicate());
    this.byId("make-remove").addEventListener("click", () => this.#remove());
  }

  /** @param {EditedScene | null} edited */
  setEdited(edited) {
    this.#edited = edited;
    this.update();
  }

  update() {
    const edited = this.#edited;
    const { body = null, selected = null } = edited ?? {};
    this.#updateList(edited);
    this.byId("make-fields").hidden = body === null;
    if (!edited || !body) return;
    const [size, second] = SIZES[body.shape];
    const values = {
      x: body.x,
      y: body.y,
      angle: degreesOf(body),
      size: sizeOf(body, size),
      thickness: sizeOf(body, "thickness"),
    };
    for (const [name, field] of Object.entries(this.#fields)) {
      const typed = String(rounded(values[/** @type {keyof typeof values} */ (name)]));
      if (field.value !== typed) field.value = typed;
    }
    setText(this.byId("make-size-label"), text.editor.sizes[size]);
    this.byId("make-thickness-label").hidden = second === undefined;
    const { body1, body2 } = edited.scene;
    this.#dynamic.checked = body.dynamic;
    this.#dynamic.disabled = selected === body1;
    this.byId("make-object").setAttribute("aria-pressed", String(selected === body1));
    this.byId("make-goal").setAttribute("aria-pressed", String(selected === body2));
    this.byId("make-duplicate", HTMLButtonElement).disabled = !edited.canAdd;
    this.byId("make-remove", HTMLButtonElement).disabled = !edited.canRemove;
  }

  /** @param {EditedScene | null} edited */
  #updateList(edited) {
    const count = edited?.scene.bodies.length ?? 0;
    while (this.#list.children.length > count) this.#list.lastElementChild?.remove();
    while (this.#list.children.length < count) this.#list.append(this.#item(this.#list.children.length));
    edited?.scene.bodies.forEach((_, index) => {
      const button = /** @type {HTMLButtonElement} */ (this.#list.children[index].firstElementChild);
      setText(button, nameOf(edited.scene, index));
      button.dataset.role = roleOf(edited.scene, index);
      button.setAttribute("aria-pressed", String(index === edited.selected));
    });
  }

  /** @param {number} index */
  #item(index) {
    const item = document.createElement("li");
    item.append(createButton("", () => this.#edited?.select(this.#edited.selected === index ? null : index)));
    return item;
  }

  /**
   * @param {string} name
   * @param {number} value
   */
  #onTyped(name, value) {
    const edited = this.#edited;
    if (!edited?.body) return;
    const { body } = edited;
    // A field that is emptied gets its number back, and one whose number is far from any scene.
    if (!(Math.abs(value) <= FARTHEST)) this.update();
    else if (name === "x") edited.moveTo(value, body.y, null, true);
    else if (name === "y") edited.moveTo(body.x, value, null, true);
    else if (name === "angle") edited.turnTo(value, null, true);
    else edited.resizeTo(name === "thickness" ? "thickness" : SIZES[body.shape][0], value, null, true);
  }

  #remove() {
    this.#edited?.remove();
    // The button is disabled now, or hidden with the fields.
    this.#list.querySelector("button")?.focus();
  }
}
