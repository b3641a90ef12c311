// What this device remembers of the person's own attempts: for each puzzle how many there were, and which solved it
// first. Kept in the browser's storage as JSON. A store that is forbidden, full or damaged costs the memory, never
// the page. Knows nothing of the document.
//
// { "tasks": { "00007:013": { "attempts": 4, "solved": 3 } } }   "solved" is null as long as none did

const KEY = "pathlight.progress";
const TASK = /^\d{5}:\d{3}$/;

export class Progress extends EventTarget {
  /** Does it outlast the page? */
  kept = true;
  #key;
  #tasks = {};

  /** Fires "change" whenever there is something else to tell, also when another tab has noted it. */
  constructor(key = KEY) {
    super();
    this.#key = key;
    this.#read();
    addEventListener("storage", ({ key }) => {
      if (key !== this.#key && key !== null) return;
      this.#read();
      this.#changed();
    });
  }

  /** { attempts, solved } of a task; no attempts if it was never tried. */
  of(task) {
    return Object.hasOwn(this.#tasks, task) ? this.#tasks[task] : { attempts: 0, solved: null };
  }

  /** The tasks that were tried. */
  get tasks() {
    return Object.keys(this.#tasks).sort();
  }

  /** Of some tasks: how many were tried, how many are solved, and how many attempts that took in all. */
  sum(tasks) {
    const tried = tasks.map((task) => this.of(task)).filter(({ attempts }) => attempts > 0);
    const attempts = tried.reduce((sum, one) => sum + one.attempts, 0);
    return { tried: tried.length, solved: tried.filter(({ solved }) => solved !== null).length, attempts };
  }

  /** Takes note of one more attempt at a task. */
  note(task, solves) {
    // Another tab may have noted something meanwhile.
    if (this.kept) this.#read();
    const { attempts, solved } = this.of(task);
    this.#tasks[task] = { attempts: attempts + 1, solved: solved ?? (solves ? attempts + 1 : null) };
    this.#keep();
  }

  /** Takes note of how far someone has come at a task. */
  keep(task, attempts, solved) {
    if (this.kept) this.#read();
    this.#tasks[task] = { attempts, solved };
    this.#keep();
  }

  clear() {
    this.#tasks = {};
    this.#write((store) => store.removeItem(this.#key));
  }

  /** All of it as JSON. */
  text() {
    return JSON.stringify({ tasks: this.#tasks }, null, 1);
  }

  #read() {
    try {
      this.#tasks = sound(JSON.parse(localStorage.getItem(this.#key) ?? "null"));
    } catch (error) {
      // What is no JSON is forgotten; a store that may not even be asked is never asked again.
      this.#tasks = {};
      if (!(error instanceof SyntaxError)) this.kept = false;
    }
  }

  #keep() {
    this.#write((store) => store.setItem(this.#key, this.text()));
  }

  #write(change) {
    try {
      if (this.kept) change(localStorage);
    } catch {
      this.kept = false;
    }
    this.#changed();
  }

  #changed() {
    this.dispatchEvent(new Event("change"));
  }
}

/** What makes sense of what was kept. */
function sound(kept) {
  const counts = (value, most) => Number.isSafeInteger(value) && value >= 1 && value <= most;
  const entries = Object.entries(kept?.tasks ?? {}).filter(
    ([task, one]) => TASK.test(task) && counts(one?.attempts, 1e6) && (one.solved === null || counts(one.solved, one.attempts)),
  );
  return Object.fromEntries(entries.map(([task, { attempts, solved }]) => [task, { attempts, solved }]));
}
