// Maps a key to an action, from its event alone.

export type KeyFacts = Pick<KeyboardEvent, "key" | "code" | "ctrlKey" | "metaKey" | "altKey" | "shiftKey">;

/**
 * `move`, `resize` and `next` apply in the scene, the other actions anywhere. In the presentation of the walkthrough,
 * `move` turns pages outside the scene, and `page` turns them anywhere: clickers send it.
 */
export type KeyAction =
  | { readonly kind: "move"; readonly dx: number; readonly dy: number }
  | { readonly kind: "resize"; readonly dr: number }
  | { readonly kind: "next" | "toggle" | "leave" | "again" | "undo" | "redo" | "previousPuzzle" | "nextPuzzle" }
  | { readonly kind: "stepBy"; readonly steps: number }
  | { readonly kind: "page"; readonly by: 1 | -1 }
  | { readonly kind: "panel"; readonly index: number };

/** Actions in a scene that is being changed. */
export type MakingKey =
  | { readonly kind: "select"; readonly by: 1 | -1 }
  | { readonly kind: "turn"; readonly degrees: number }
  | { readonly kind: "duplicate" | "remove" | "leave" };

/** Distance of an arrow key with Shift, px. */
const FAR = 10;

const ARROWS: Record<string, readonly [dx: number, dy: number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
const PLAIN: Record<string, KeyAction> = {
  "+": { kind: "resize", dr: 1 },
  "=": { kind: "resize", dr: 1 },
  "-": { kind: "resize", dr: -1 },
  "−": { kind: "resize", dr: -1 },
  Enter: { kind: "next" },
  " ": { kind: "toggle" },
  r: { kind: "again" },
  ",": { kind: "stepBy", steps: -1 },
  ".": { kind: "stepBy", steps: 1 },
  PageDown: { kind: "page", by: 1 },
  PageUp: { kind: "page", by: -1 },
  Escape: { kind: "leave" },
  "[": { kind: "previousPuzzle" },
  "]": { kind: "nextPuzzle" },
};
/** Names of keys on layouts that give them another letter. */
const CODES: Record<string, string> = {
  BracketLeft: "[",
  BracketRight: "]",
  Comma: ",",
  Period: ".",
  Minus: "-",
  Equal: "=",
  NumpadAdd: "+",
  NumpadSubtract: "-",
};

export function keyAction(facts: KeyFacts): KeyAction | null {
  const names = namesOf(facts);
  if (facts.ctrlKey || facts.metaKey) return facts.altKey ? null : withControl(names, facts.shiftKey);
  if (facts.altKey) return null;
  const arrow = ARROWS[facts.key];
  const far = facts.shiftKey ? FAR : 1;
  if (arrow) return { kind: "move", dx: arrow[0] * far, dy: arrow[1] * far };
  for (const name of names) {
    const action = PLAIN[name] ?? (/^[1-9]$/.test(name) ? { kind: "panel" as const, index: Number(name) - 1 } : null);
    if (action) return action;
  }
  return null;
}

/** Angles by which keys turn a body, degrees; the larger with Shift. */
const TURNS = [1, 15];

export function makingKey(facts: KeyFacts): MakingKey | null {
  if (facts.ctrlKey || facts.metaKey || facts.altKey) return null;
  const degrees = TURNS[Number(facts.shiftKey)]!;
  for (const name of namesOf(facts)) {
    switch (name) {
      case "n":
        return { kind: "select", by: 1 };
      case "p":
        return { kind: "select", by: -1 };
      // < and > are , and . with Shift on many keyboards.
      case ",":
      case "<":
        return { kind: "turn", degrees };
      case ".":
      case ">":
        return { kind: "turn", degrees: -degrees };
      case "d":
        return { kind: "duplicate" };
      case "Delete":
      case "Backspace":
        return { kind: "remove" };
      case "Escape":
        return { kind: "leave" };
    }
  }
  return null;
}

function withControl(names: string[], shift: boolean): KeyAction | null {
  if (names.includes("y")) return { kind: "redo" };
  return names.includes("z") ? { kind: shift ? "redo" : "undo" } : null;
}

/** Names of a key: the character that it types, and its position unless that character is a Latin letter. */
function namesOf({ key, code }: KeyFacts): string[] {
  const written = key.length === 1 ? key.toLowerCase() : key;
  if (/^\p{Script=Latin}$/u.test(written)) return [written];
  const place = /^Key[A-Z]$/.test(code)
    ? code.slice(3).toLowerCase()
    : /^Digit\d$/.test(code)
      ? code.slice(5)
      : CODES[code];
  return place === undefined ? [written] : [written, place];
}
