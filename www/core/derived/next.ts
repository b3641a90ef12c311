// Chooses the next puzzle: new to person and model, of another kind, and a little harder.

/** Facts about the benchmark's tasks, all in the same order. */
export interface Benchmark {
  readonly tasks: readonly string[];
  /** Share of uniform valid balls that solve each task. */
  readonly rates: Float64Array;
  /** Tasks that the model was neither trained nor selected on. */
  readonly unseen: ReadonlySet<string>;
}

/** Difficulty of the next puzzle: its share of solving balls relative to that of the current one. */
const HARDER = 0.8;

/**
 * The first puzzle of the home page. The first model imagines it well and still misses, so whoever has watched can win
 * without having seen the answer. Its show has been recorded.
 */
export const FIRST_TASK = "00013:193";

/** Returns the next puzzle after one; `tried` tells whether the person has played a puzzle. */
export function nextTask(
  { tasks, rates, unseen }: Benchmark,
  from: string | null,
  tried: (task: string) => boolean,
): string {
  const here = from === null ? -1 : tasks.indexOf(from);
  const aim = here < 0 ? Math.max(...rates) : (rates[here] ?? 0) * HARDER;
  const distance = (index: number) => Math.abs(Math.log((rates[index]! + 1e-6) / (aim + 1e-6)));
  const isOther = (task: string) => kindOf(task) !== (from && kindOf(from));
  const indices = [...tasks.keys()].filter((index) => tasks[index] !== from);
  const wishes = [
    (task: string) => unseen.has(task) && !tried(task) && isOther(task),
    (task: string) => unseen.has(task) && !tried(task),
    (task: string) => !tried(task),
    () => true,
  ];
  for (const wish of wishes) {
    const fitting = indices.filter((index) => wish(tasks[index]!));
    if (fitting.length) return tasks[fitting.reduce((best, one) => (distance(one) < distance(best) ? one : best))]!;
  }
  return from ?? tasks[0]!;
}

/** The puzzle some places further in a list; a list that does not wrap around ends. */
export function neighbour(
  tasks: readonly string[],
  from: string | null,
  places: number,
  wraps: boolean,
): string | undefined {
  const there = (from === null ? 0 : tasks.indexOf(from)) + places;
  return wraps ? tasks.at(there % tasks.length) : tasks[there];
}

export function kindOf(task: string): string {
  return task.slice(0, 5);
}

/** Reads the id of a task as people write it: "7:8" for "00007:008"; null if it is not one. */
export function taskOf(text: string): string | null {
  const [, kind, number] = /^\s*(\d{1,5})\s*[:./ -]\s*(\d{1,3})\s*$/.exec(text) ?? [];
  return kind && number ? `${kind.padStart(5, "0")}:${number.padStart(3, "0")}` : null;
}
