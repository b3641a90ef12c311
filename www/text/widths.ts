// Distances in widths of a ball, as people say them.

export interface WidthWords {
  readonly hair: string;
  readonly quarter: string;
  readonly half: string;
  readonly one: string;
  more(count: number): string;
}

/** Returns a function that puts a distance and the radius of the ball, in the same unit, into words. */
export function widthsIn(words: WidthWords): (distance: number, radius: number) => string {
  return (distance, radius) => {
    const widths = distance / (2 * radius);
    if (widths < 0.15) return words.hair;
    if (widths < 0.35) return words.quarter;
    if (widths < 0.75) return words.half;
    return widths < 1.5 ? words.one : words.more(Math.round(widths));
  };
}
