// Undo and redo of values that are replaced, not changed in place.

export interface History<Value> {
  /** Values that undo returns to, the latest last. */
  readonly past: readonly Value[];
  /** Values that redo returns to, the next one last. */
  readonly future: readonly Value[];
  /** The gesture that made the last change. Changes of one gesture are undone together. */
  readonly gesture: string | null;
}

export const NO_HISTORY: History<never> = { past: [], future: [], gesture: null };
const MOST_UNDONE = 200;

/** Records the value before a change. */
export function recorded<Value>(before: History<Value>, value: Value, gesture: string | null): History<Value> {
  const isSame = gesture !== null && gesture === before.gesture;
  return { past: isSame ? before.past : [...before.past, value].slice(-MOST_UNDONE), future: [], gesture };
}

/** Goes back or forward from the value that holds now; null if there is no value there. */
export function travelled<Value extends object>(
  { past, future }: History<Value>,
  to: "past" | "future",
  now: Value,
): (History<Value> & { readonly value: Value }) | null {
  const [from, onto] = to === "past" ? [past, future] : [future, past];
  const value = from.at(-1);
  if (!value) return null;
  const [rest, more] = [from.slice(0, -1), [...onto, now]];
  return { value, gesture: null, past: to === "past" ? rest : more, future: to === "past" ? more : rest };
}
