// A scene as the text of a link, and back: its JSON, deflated, in base64url.

import type { CustomScene } from "../pkg/page/pathlight.js";

/** Maximum number of characters, more than the JSON of the largest scene. Nothing larger is unpacked. */
const MOST = 256_000;

export async function textOfScene(scene: CustomScene): Promise<string> {
  const json = new Blob([JSON.stringify(scene)]).stream();
  const deflated = new Response(json.pipeThrough(new CompressionStream("deflate-raw")));
  const bytes = new Uint8Array(await deflated.arrayBuffer());
  return btoa(String.fromCharCode(...bytes))
    .replaceAll("+", "-")
    .replaceAll("/", "_")
    .replaceAll("=", "");
}

/** Reads any value from a text; it may not be a scene. Rejects if the text is damaged. */
export async function readSceneText(text: string): Promise<unknown> {
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(binary, (character) => character.charCodeAt(0));
  const inflated = new Blob([bytes])
    .stream()
    .pipeThrough(new DecompressionStream("deflate-raw"))
    .pipeThrough(new TextDecoderStream("utf-8", { fatal: true }) as ReadableWritablePair<string, Uint8Array>);
  const reader = inflated.getReader();
  let json = "";
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return JSON.parse(json);
    json += value;
    if (json.length > MOST) throw new RangeError("more than a scene");
  }
}
