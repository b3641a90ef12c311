// tract, compiled from ../tract.

import { ofMaps } from '../../web/contender.mjs';

export async function load(read) {
  const { instance } = await WebAssembly.instantiate(await read('target/bench/tract.wasm'));
  const { memory, room, load, imagine } = instance.exports;
  const put = (bytes) => {
    const at = room(bytes.length);
    new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
    return at;
  };
  const onnx = await read('target/bench/nets.onnx');
  const nets = load(put(onnx), onnx.length);
  const scene = put(await read('target/bench/scene.f32'));
  const maps = room(4 * 64 * 64 * 4);
  return ofMaps(() => {
    imagine(nets, scene, maps);
    return [0, 1, 2, 3].map((map) => new Float32Array(memory.buffer, maps, 4 * 64 * 64).slice(map * 64 * 64, (map + 1) * 64 * 64));
  });
}
