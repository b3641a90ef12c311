// The progress of the player, or of a model in its own turns.

export class AuthorProgress {
  #progress;
  #by;

  /**
   * @param {import("./progress.js").Progress} progress
   * @param {string} by
   */
  constructor(progress, by) {
    this.#progress = progress;
    this.#by = by;
  }

  /**
   * The progress on a task; no attempts if it was never tried.
   * @param {string} task
   */
  of(task) {
    return this.#progress.of(this.#by, task);
  }

  /** The tasks that were tried, sorted. */
  get tasks() {
    return this.#progress.tasksOf(this.#by);
  }

  /**
   * Of some tasks: how many were tried, how many are solved, and the attempts on all of them.
   * @param {string[]} tasks
   */
  sum(tasks) {
    const tried = tasks.map((task) => this.of(task)).filter(({ attempts }) => attempts > 0);
    const attempts = tried.reduce((sum, one) => sum + one.attempts, 0);
    return { tried: tried.length, solved: tried.filter(({ solved }) => solved !== null).length, attempts };
  }
}
