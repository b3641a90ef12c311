// A contender in wasm, in Node or in a page: the module NAME.mjs in this folder, and a stopwatch.

/** `read` returns the bytes of a file of the repository. */
export async function contender(name, read) {
  const { load } = await import(`./${name}.mjs`);
  const forward = await load(read);
  const maps = await forward();
  return {
    result: maps.flatMap((map) => [...map]),
    async times(repetitions) {
      const times = [];
      for (let done = 0; done < repetitions; done += 1) {
        const start = performance.now();
        await forward();
        times.push(performance.now() - start);
      }
      return times;
    },
  };
}
