// The person's progress as the page tells it: a line above the grid, a note on each of its templates, a mark on each
// puzzle of the picker. Saves it to a file, and clears it when the person is sure.

const at = (id) => document.getElementById(id);

export class Record {
  #progress;
  #templates;
  #gallery;

  /** `progress`: a Progress. `templates`: as the wasm lists them. */
  constructor(progress, templates, gallery) {
    this.#progress = progress;
    this.#templates = templates;
    this.#gallery = gallery;
    at("save").addEventListener("click", () => this.#save());
    at("forgetting").addEventListener("close", () => {
      if (at("forgetting").returnValue === "forget") progress.clear();
    });
    progress.addEventListener("change", () => this.#update());
    this.#update();
  }

  #update() {
    const all = this.#progress.sum(this.#templates.flatMap(({ tasks }) => tasks));
    at("record").hidden = all.tried === 0;
    at("record-words").textContent = total(all) + (this.#progress.kept ? "" : " This browser keeps nothing for the page: it is forgotten when you close it.");
    for (const { id, tasks } of this.#templates) this.#gallery.mark(id, part(this.#progress.sum(tasks), tasks.length));
    for (const option of at("task").options) option.textContent = this.label(option.value);
  }

  /** A puzzle as the picker names it, with what came of it. */
  label(task) {
    const { attempts, solved } = this.#progress.of(task);
    if (solved) return `${task} ✓ in ${solved}`;
    return attempts ? `${task} × ${attempts}` : task;
  }

  #save() {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([this.#progress.text()], { type: "application/json" }));
    link.download = "pathlight-progress.json";
    link.click();
    // The browser may not have begun to read it.
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  }
}

const counted = (count, what) => `${count} ${what}${count === 1 ? "" : "s"}`;

function total({ tried, solved, attempts }) {
  return `So far you have tried ${counted(tried, "puzzle")} and solved ${solved}, in ${counted(attempts, "attempt")}.`;
}

/** The progress on one template. */
function part({ tried, solved, attempts }, of) {
  if (tried === 0) return "";
  return `${solved ? "✓" : "×"} ${solved} of ${of} solved, in ${counted(attempts, "attempt")}`;
}
