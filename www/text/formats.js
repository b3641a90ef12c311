// Numbers, units and lists as a language writes them. For the catalogues; knows nothing of the document.

/** @param {string} language */
export function formatsOf(language) {
  /** @type {Map<string, Intl.NumberFormat>} */
  const formats = new Map();

  /**
   * A number with this many decimals: "1,234.5".
   * @param {number} value
   * @param {number} [decimals]
   * @param {Intl.NumberFormatOptions} [options]
   */
  const number = (value, decimals = 0, options = {}) => {
    const key = JSON.stringify([decimals, options]);
    const format =
      formats.get(key) ??
      new Intl.NumberFormat(language, { minimumFractionDigits: decimals, maximumFractionDigits: decimals, ...options });
    formats.set(key, format);
    return format.format(value);
  };

  return {
    number,

    /**
     * A share of 0 to 1 as "30%".
     * @param {number} share
     * @param {number} [decimals]
     */
    percent: (share, decimals = 0) => number(share, decimals, { style: "percent" }),

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
