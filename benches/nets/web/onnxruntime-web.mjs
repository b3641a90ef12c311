// onnxruntime-web's wasm, which has fixed-width SIMD, on one thread.

import * as ort from "../../../target/bench/node_modules/onnxruntime-web/dist/ort.wasm.min.mjs";
import { ofMaps } from "../../web/implementation.mjs";

/** `what` is 'nets', the four nets, or 'all-nets', the dynamics net too. */
export async function load(read, what) {
  ort.env.wasm.numThreads = 1;
  ort.env.wasm.wasmBinary = await read("target/bench/node_modules/onnxruntime-web/dist/ort-wasm-simd-threaded.wasm");
  const nets = await ort.InferenceSession.create(await read(`target/bench/${what}.onnx`), {
    executionProviders: ["wasm"],
  });
  const images = {};
  for (const name of nets.inputNames) {
    const { buffer } = await read(`target/bench/${name}.f32`);
    images[name] = new ort.Tensor("float32", new Float32Array(buffer), [1, 5, 64, 64]);
  }
  return ofMaps(async () => {
    const maps = await nets.run(images);
    return nets.outputNames.map((name) => maps[name].data);
  });
}
