// tract, compiled from ../tract.

import { ofMaps } from "../../web/implementation.mjs";

/** `what` is 'nets', the four nets, or 'all-nets', the dynamics net too. */
export async function load(read, what) {
  const { instance } = await WebAssembly.instantiate(await read("target/bench/tract.wasm"));
  const { memory, room, load, imagine } = instance.exports;
  const put = (bytes) => {
    const at = room(bytes.length);
    new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
    return at;
  };
  const onnx = await read(`target/bench/${what}.onnx`);
  const nets = load(put(onnx), onnx.length);
  const [names, count] = what === "nets" ? [["scene"], 4] : [["scene", "coverage"], 4 + 8];
  const inputs = await Promise.all(names.map((name) => read(`target/bench/${name}.f32`)));
  const images = put(new Uint8Array(inputs.flatMap((input) => [...input])));
  const maps = room(count * 64 * 64 * 4);
  return ofMaps(() => {
    imagine(nets, images, inputs.length, maps);
    return [new Float32Array(memory.buffer, maps, count * 64 * 64).slice()];
  });
}
