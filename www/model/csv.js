// Tables as comma-separated values (RFC 4180). Knows nothing of the document.

/**
 * A line for each row; null and undefined are empty.
 * @param {unknown[][]} rows
 */
export function toCsv(rows) {
  return rows.map((row) => `${row.map(field).join(",")}\r\n`).join("");
}

/** @param {unknown} value */
function field(value) {
  const text = String(value ?? "");
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
