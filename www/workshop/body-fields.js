// The bodies of a draft as a list to select from, and the numbers of the selected one as fields.

import { Component } from "../widgets/component.js";
import { createButton, setText } from "../widgets/dom.js";
import { SIZES, sizeOf } from "./body-geometry.js";
import { degreesOf, nameOf, rounded } from "./body-words.js";

/** @typedef {import("./draft.js").Draft} Draft */

/** The largest number that is taken from a field, px or degrees. */
const FARTHEST = 1e5;

export class BodyFields extends Component {
  /** @type {Draft | null} */
  #draft = null;
  #list = this.byId("bend-bodies");
  #fields = {
    x: this.byId("bend-x", HTMLInputElement),
    y: this.byId("bend-y", HTMLInputElement),
    angle: this.byId("bend-angle", HTMLInputElement),
    size: this.byId("bend-size", HTMLInputElement),
    thickness: this.byId("bend-thickness", HTMLInputElement),
  };
  #dynamic = this.byId("bend-dynamic", HTMLInputElement);

  /** @param {import("../widgets/dom.js").Root} root */
  constructor(root) {
    super(root);
    this.byId("bend-fields").addEventListener("submit", (event) => event.preventDefault());
    for (const [name, field] of Object.entries(this.#fields)) {
      field.addEventListener("change", () => this.#onTyped(name, field.valueAsNumber));
    }
    this.#dynamic.addEventListener("change", () => this.#draft?.setDynamic(this.#dynamic.checked));
    this.byId("bend-object").addEventListener("click", () => this.#draft?.makeObject());
    this.byId("bend-goal").addEventListener("click", () => this.#draft?.makeGoal());
    this.byId("bend-duplicate").addEventListener("click", () => this.#draft?.duplicate());
    this.byId("bend-remove").addEventListener("click", () => this.#remove());
  }

  /** @param {Draft | null} draft */
  setDraft(draft) {
    this.#draft = draft;
    this.update();
  }

  update() {
    const draft = this.#draft;
    const { body = null, selected = null } = draft ?? {};
    this.#updateList(draft);
    this.byId("bend-fields").hidden = body === null;
    if (!draft || !body) return;
    const [size, second] = SIZES[body.shape];
    const values = {
      x: body.x,
      y: body.y,
      angle: degreesOf(body),
      size: sizeOf(body, size),
      thickness: sizeOf(body, "thickness"),
    };
    for (const [name, field] of Object.entries(this.#fields)) {
      const text = String(rounded(values[/** @type {keyof typeof values} */ (name)]));
      if (field.value !== text) field.value = text;
    }
    setText(this.byId("bend-size-label"), size);
    this.byId("bend-thickness-label").hidden = second === undefined;
    const { body1, body2 } = draft.scene;
    this.#dynamic.checked = body.dynamic;
    this.#dynamic.disabled = selected === body1;
    this.byId("bend-object").setAttribute("aria-pressed", String(selected === body1));
    this.byId("bend-goal").setAttribute("aria-pressed", String(selected === body2));
    this.byId("bend-duplicate", HTMLButtonElement).disabled = !draft.canAdd;
    this.byId("bend-remove", HTMLButtonElement).disabled = !draft.canRemove;
  }

  /** @param {Draft | null} draft */
  #updateList(draft) {
    const names = draft ? draft.scene.bodies.map((_, index) => nameOf(draft.scene, index)) : [];
    while (this.#list.children.length > names.length) this.#list.lastElementChild?.remove();
    while (this.#list.children.length < names.length) this.#list.append(this.#item(this.#list.children.length));
    names.forEach((name, index) => {
      const button = /** @type {HTMLButtonElement} */ (this.#list.children[index].firstElementChild);
      setText(button, name);
      button.dataset.role = name.split(" ")[0];
      button.setAttribute("aria-pressed", String(index === draft?.selected));
    });
  }

  /** @param {number} index */
  #item(index) {
    const item = document.createElement("li");
    item.append(createButton("", () => this.#draft?.select(this.#draft.selected === index ? null : index)));
    return item;
  }

  /**
   * @param {string} name
   * @param {number} value
   */
  #onTyped(name, value) {
    const draft = this.#draft;
    if (!draft?.body) return;
    const { body } = draft;
    // A field that is emptied gets its number back, and one whose number is far from any scene.
    if (!(Math.abs(value) <= FARTHEST)) this.update();
    else if (name === "x") draft.moveTo(value, body.y, null, true);
    else if (name === "y") draft.moveTo(body.x, value, null, true);
    else if (name === "angle") draft.turnTo(value, null, true);
    else draft.resizeTo(name === "thickness" ? "thickness" : SIZES[body.shape][0], value, null, true);
  }

  #remove() {
    this.#draft?.remove();
    // The button is disabled now, or hidden with the fields.
    this.#list.querySelector("button")?.focus();
  }
}
