// Numbers, units and lists as a language writes them. For the catalogues; knows nothing of the document. Most numbers
// are written by hand: the first Intl.NumberFormat loads the data of a language, some 20 ms of the first picture.

/**
 * How a language writes numbers: the decimal sign, what stands between thousands, and before the sign for percent.
 * @typedef {{ point: string, group: string, percent: string }} Signs
 */

/**
 * @param {string} language
 * @param {Signs} signs
 */
export function formatsOf(language, { point, group, percent }) {
  /** @type {Map<string, Intl.NumberFormat>} */
  const formats = new Map();

  /**
   * A number with this many decimals: "1,234.5"; with options as the browser writes it.
   * @param {number} value
   * @param {number} [decimals]
   * @param {Intl.NumberFormatOptions} [options]
   */
  const number = (value, decimals = 0, options) => {
    if (options || !Number.isFinite(value)) return written(value, decimals, options);
    const [whole, part] = rounded(Math.abs(value), decimals).split(".");
    const sign = value < 0 ? "-" : "";
    return sign + whole.replace(/\B(?=(\d{3})+$)/g, group) + (part ? point + part : "");
  };

  /**
   * @param {number} value
   * @param {number} decimals
   * @param {Intl.NumberFormatOptions} [options]
   */
  function written(value, decimals, options) {
    const key = JSON.stringify([decimals, options]);
    const digits = { minimumFractionDigits: decimals, maximumFractionDigits: decimals };
    const format = formats.get(key) ?? new Intl.NumberFormat(language, { ...digits, ...options });
    formats.set(key, format);
    return format.format(value);
  }

  return {
    number,

    /**
     * A share of 0 to 1 as "30%".
     * @param {number} share
     * @param {number} [decimals]
     */
    percent: (share, decimals = 0) => `${number(times(share, 2), decimals)}${percent}%`,

    /**
     * "1.4 s".
     * @param {number} value
     * @param {number} [decimals]
     */
    seconds: (value, decimals = 1) => `${number(value, decimals)} s`,

    /**
     * "1 ball", "12 balls".
     * @param {number} count
     * @param {string} one
     * @param {string} more
     */
    counted: (count, one, more) => `${number(count)} ${count === 1 ? one : more}`,

    /**
     * "left, middle and right".
     * @param {string[]} words
     */
    list: (words) => new Intl.ListFormat(language).format(words),
  };
}

/**
 * A value times a power of ten, exactly as its decimal digits say: 1.005 · 100 is 100.5, which floating point misses.
 * @param {number} value
 * @param {number} power
 */
function times(value, power) {
  const moved = Number(`${value}e${power}`);
  // What is tiny or huge has an exponent already.
  return Number.isNaN(moved) ? value * 10 ** power : moved;
}

/**
 * Rounded to decimals, halves up.
 * @param {number} value not negative
 * @param {number} decimals
 */
function rounded(value, decimals) {
  return (Math.round(times(value, decimals)) / 10 ** decimals).toFixed(decimals);
}
