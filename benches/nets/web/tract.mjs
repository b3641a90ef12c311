// tract, compiled from ../tract.

import { ofMaps } from "../../web/implementation.mjs";

/** `what` is 'nets', the four nets, or 'all-nets', the success net too. */
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
  const scene = put(await read("target/bench/scene.f32"));
  const count = what === "nets" ? 4 : 4 + 8;
  const maps = room(count * 64 * 64 * 4);
  return ofMaps(() => {
    imagine(nets, scene, maps);
    return [new Float32Array(memory.buffer, maps, count * 64 * 64).slice()];
  });
}
