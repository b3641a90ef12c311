// An implementation in wasm, in Node or in a page: a module named by its path from `benches`, the folder or that of
// another checkout.

/**
 * `read` returns the bytes of a file of the repository; `what` selects the work that is timed. The module's `load`
 * returns the result to compare and `time()`, which does the work once and returns its duration, ms.
 */
export async function implementation([module, what], read, benches = "..") {
  const { load } = await import(`${benches}/${module}`);
  const { result, time } = await load(read, what);
  return {
    result,
    async times(repetitions) {
      const times = [];
      for (let done = 0; done < repetitions; done += 1) times.push(await time());
      return times;
    },
  };
}

/** The same for work that returns maps. */
export async function ofMaps(work) {
  const maps = await work();
  return {
    result: maps.flatMap((map) => [...map]),
    async time() {
      const start = performance.now();
      await work();
      return performance.now() - start;
    },
  };
}
