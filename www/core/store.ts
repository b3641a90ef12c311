// Holds the state and runs effects: outside work that depends on parts of the state. Independent of the type of the
// state and of the browser.

export interface Effect<State> {
  /** Dependencies of the work, which runs again whenever one of them changes. Null if there is nothing to do. */
  needs(state: State): readonly unknown[] | null;
  /** Does the work. The signal is aborted once the needs have changed; short work may ignore it. */
  run(store: Store<State>, signal: AbortSignal): void | Promise<void>;
}

export class Store<State> {
  #state: State;
  #runners: Runner<State>[];
  #onChange: () => void = () => {};
  #stopped = false;

  constructor(state: State, effects: readonly Effect<State>[]) {
    this.#state = state;
    this.#runners = effects.map((effect) => new Runner(effect, this));
  }

  get state(): State {
    return this.#state;
  }

  /** Starts running effects, and calls back after each change. */
  start(onChange: () => void): void {
    this.#onChange = onChange;
    this.#changed();
  }

  /** Replaces the state by the result of a pure function of it. */
  change<Args extends unknown[]>(next: (state: State, ...args: Args) => State, ...args: Args): void {
    if (this.#stopped) return;
    const before = this.#state;
    this.#state = next(before, ...args);
    if (this.#state !== before) this.#changed();
  }

  /** Aborts running effects. Later answers change nothing. */
  stop(): void {
    this.#stopped = true;
    for (const runner of this.#runners) runner.stop();
  }

  #changed(): void {
    for (const runner of this.#runners) runner.follow();
    this.#onChange();
  }
}

/** Runs one effect, one run at a time; then again only for the newest needs, however many changes there were. */
class Runner<State> {
  #effect: Effect<State>;
  #store: Store<State>;
  #needs: readonly unknown[] | null = null;
  #running: AbortController | null = null;
  #outdated = false;

  constructor(effect: Effect<State>, store: Store<State>) {
    this.#effect = effect;
    this.#store = store;
  }

  follow(): void {
    const needs = this.#effect.needs(this.#store.state);
    if (sameNeeds(needs, this.#needs)) return;
    this.#needs = needs;
    this.#outdated = true;
    if (this.#running) this.#running.abort();
    else void this.#run();
  }

  stop(): void {
    this.#needs = null;
    this.#running?.abort();
  }

  async #run(): Promise<void> {
    while (this.#outdated) {
      this.#outdated = false;
      if (!this.#needs) continue;
      const { signal } = (this.#running = new AbortController());
      try {
        await this.#effect.run(this.#store, signal);
      } catch (error) {
        if (!signal.aborted) reportError(error);
      }
      this.#running = null;
    }
  }
}

function sameNeeds(one: readonly unknown[] | null, other: readonly unknown[] | null): boolean {
  if (one === null || other === null) return one === other;
  return one.length === other.length && one.every((need, index) => Object.is(need, other[index]));
}
