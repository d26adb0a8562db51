// Tables as CSV: read into cells, and written from cells. A cell with a comma, a quote or a new line stands in quotes.

/** A CSV file as rows of cells, with the names of its columns. */
export function parseCsv(csv) {
  const [names, ...rows] = rowsOf(csv.trimEnd());
  return { names, rows, column: (name) => rows.map((row) => row[names.indexOf(name)]) };
}

function rowsOf(text) {
  // the tables of the program have no quotes, and thousands of rows
  if (!text.includes('"')) return text.split("\n").map((line) => line.split(","));
  const rows = [[]];
  for (const [, quoted, plain, end] of text.matchAll(/(?:"((?:[^"]|"")*)"|([^",\n]*))(,|\n|$)/g)) {
    rows.at(-1).push(plain ?? quoted.replaceAll('""', '"'));
    if (end === "\n") rows.push([]);
    // behind the last cell there is one more match, which is empty
    if (end === "") break;
  }
  return rows;
}

/** Rows of cells as a CSV file. */
export function csvOf(rows) {
  const cell = (value) => (/[",\n]/.test(value) ? `"${String(value).replaceAll('"', '""')}"` : value);
  return `${rows.map((cells) => cells.map(cell).join(",")).join("\n")}\n`;
}
