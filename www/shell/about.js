// What stands behind the page, one click away: how the model that is loaded was trained, as its card tells.

const at = (id) => document.getElementById(id);
const number = (value) => value.toLocaleString("en");

/** What an entry of the card is called, and how it is said, in order; others follow as they stand. */
const ENTRIES = {
  samples: ["Learned from", (samples, { tasks }) => `${number(samples)} solutions of ${number(tasks)} puzzles`],
  epochs: ["Looked at each", (epochs) => `${epochs} times`],
  setup: ["Kinds of puzzles", (setup) => (setup === "within" ? "the same kinds that it is tested on, but other puzzles (“within”)" : "other kinds than those that it is tested on (“cross”)")],
  fold: ["Fold", (fold) => `${fold}, one of ten ways to part the puzzles into those to learn from and those to test on`],
  batch: ["At a time (batch)", number],
  learning_rate: ["Learning rate (Adam)", String],
  decay_epochs: ["Rate falling to nothing in the last", (cool) => `${cool} of the passes`],
  mirror: ["Mirrored", (mirror) => (mirror ? "half of the time, left to right" : "never")],
  judge: ["The judge learned from", ({ balls, epochs }) => `${number(balls)} balls with their outcome, ${epochs} times over`],
  simulator: ["Version of the simulator", String],
  seed: ["Seed of all chance", String],
};

export class About {
  #model;

  constructor(model) {
    this.#model = model;
    model.addEventListener("change", () => this.#update());
  }

  #update() {
    const { loaded } = this.#model;
    at("card").textContent = loaded ? `The model “${loaded.name}”:` : "No model is loaded.";
    at("card-entries").replaceChildren(...(loaded ? entries(loaded.card) : []));
  }
}

/** The card as terms and what they are. */
function entries(card) {
  const known = Object.keys(ENTRIES).filter((key) => key in card);
  const others = Object.keys(card).filter((key) => !(key in ENTRIES) && key !== "tasks");
  return [...known, ...others].flatMap((key) => {
    const [name, say] = ENTRIES[key] ?? [key, String];
    const [term, said] = [document.createElement("dt"), document.createElement("dd")];
    term.textContent = name;
    said.textContent = say(card[key], card);
    return [term, said];
  });
}
