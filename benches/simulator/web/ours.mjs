// The simulator in wasm, built from ../wasm.rs. It needs nothing from outside: the imports are those of the page's
// exports, which come along in the library.

/** Times the stepping alone. */
export async function load(read) {
  const module = await WebAssembly.compile(await read("target/bench/simulator.wasm"));
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    (imports[from] ??= {})[name] = () => {
      throw new Error(`the simulator called ${name}`);
    };
  }
  const { exports } = await WebAssembly.instantiate(module, imports);
  const at = exports.final_states();
  const [text, length] = new Uint32Array(exports.memory.buffer, at, 2);
  const result = JSON.parse(new TextDecoder().decode(new Uint8Array(exports.memory.buffer, text, length)));
  const count = exports.count();
  return {
    result,
    time() {
      let milliseconds = 0;
      for (let index = 0; index < count; index += 1) {
        exports.start(index);
        const start = performance.now();
        exports.run();
        milliseconds += performance.now() - start;
      }
      return milliseconds;
    },
  };
}
