// Breaks up long work, so that the page answers a person and draws in between.

/** Longest task of the event loop, ms: a phone that is four times slower still answers within a tenth of a second. */
const LONGEST = 12;

/** When the present part of the work began, ms. */
let begun = 0;

/** Goes on in a task of its own, before others that wait where the browser knows how. */
export async function nextTask() {
  // Not all browsers have it.
  const scheduler = /** @type {{ yield?: () => Promise<void> } | undefined} */ (Reflect.get(globalThis, "scheduler"));
  if (scheduler?.yield) await scheduler.yield();
  else await new Promise((resolve) => setTimeout(resolve));
  begun = performance.now();
}

/** Goes on in a task of its own if the work has taken long without one. */
export async function pauseIfLong() {
  if (performance.now() - begun > LONGEST) await nextTask();
}
