// Numbers and units as written in a language.

import { GOAL_STEPS, STEPS_PER_SECOND } from "../pkg/constants.ts";

/** How long the green object has to touch its goal, s. */
export const GOAL_SECONDS = GOAL_STEPS / STEPS_PER_SECOND;

/** Simulated time, s. */
export const secondsOf = (steps: number) => steps / STEPS_PER_SECOND;

/** `rare` is a share of less than 1%, in words. */
export function formatsOf(language: string, rare: string) {
  // Creating a format takes longer than a frame.
  const numbers: Intl.NumberFormat[] = [];
  let percents: Intl.NumberFormat | null = null;
  const number = (value: number, decimals = 0) => {
    const whole = Math.round(value);
    if (decimals === 0 && Math.abs(whole) < 1000) return String(whole);
    const digits = { minimumFractionDigits: decimals, maximumFractionDigits: decimals };
    return (numbers[decimals] ??= new Intl.NumberFormat(language, digits)).format(value);
  };
  /** 0.304 as "30%". */
  const percent = (share: number) => (percents ??= new Intl.NumberFormat(language, { style: "percent" })).format(share);
  return {
    number,
    percent,
    chance: (share: number) => (share < 0.01 ? rare : percent(share)),
    /** With a no-break space before the unit: "1.4 s". */
    seconds: (value: number) => `${number(value, 1)}\u00a0s`,
    counted: (count: number, one: string, more: string) => `${number(count)} ${count === 1 ? one : more}`,
  };
}
