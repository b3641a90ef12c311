// Which puzzle comes next: one that is new to person and model, of another kind, and a little harder.

/** What is known of the benchmark's tasks, in one order. */
export interface Benchmark {
  readonly tasks: readonly string[];
  /** The share of uniform valid balls that solve each. */
  readonly rates: Float64Array;
  /** Those that the model was neither trained on nor chosen by. */
  readonly unseen: ReadonlySet<string>;
}

/** How much harder the next puzzle is: its share of solving balls by that of the present one. */
const HARDER = 0.8;

/**
 * The puzzle with which the home page begins. The model imagines it well and misses it all the same, so whoever has
 * watched can win, and has not seen the answer. What it imagines has been recorded.
 */
export const FIRST_TASK = "00013:193";

/** The next puzzle after one; `tried`: has the person played it? */
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

/** The task some places further in the list, which is a ring. */
export function neighbour({ tasks }: Pick<Benchmark, "tasks">, from: string | null, places: number): string {
  const here = from === null ? 0 : tasks.indexOf(from);
  return tasks.at((here + places) % tasks.length)!;
}

export function kindOf(task: string): string {
  return task.slice(0, 5);
}

/** The id of a task as people write it: "7:8" for "00007:008"; null if it is none. */
export function taskOf(text: string): string | null {
  const [, kind, number] = /^\s*(\d{1,5})\s*[:./ -]\s*(\d{1,3})\s*$/.exec(text) ?? [];
  return kind && number ? `${kind.padStart(5, "0")}:${number.padStart(3, "0")}` : null;
}
