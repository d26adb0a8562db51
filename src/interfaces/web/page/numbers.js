// Texts and tables of results as lists and tables of the page.

import { parseCsv } from "./csv.js";
import { element } from "./element.js";

// These lines of an impact say how exact it is, and how much work it was; they are folded.
const QUIET = ["closed form", "steps"];
// These are what most look for.
const LARGE = ["impact speed", "restitution"];

/** The text of the command: a list or a table for every paragraph that is one, any other as it is printed. */
export function blocks(text) {
  return text
    .trimEnd()
    .split(/\n\n+/)
    .flatMap((paragraph) => {
      const lines = paragraph.split("\n").map((line) => line.trim().split(/ {2,}/));
      // sentences before a table
      const first = lines.findIndex((cells) => cells.length > 1);
      const [before, rest] = first < 0 ? [lines, []] : [lines.slice(0, first), lines.slice(first)];
      const said = before.map(([sentence]) => element("p", sentence));
      if (rest.length === 0) return said;
      const [head, ...rows] = rest;
      // a line of dots stands for rows that are left out
      if (
        head.length > 2 &&
        rows.length > 0 &&
        rows.every((cells) => cells.length === head.length || cells[0] === "...")
      ) {
        return [...said, table(head, rows)];
      }
      return rest.every((cells) => cells.length > 1)
        ? [...said, ...list(rest)]
        : [element("pre", { tabIndex: 0 }, paragraph)];
    });
}

/** The first rows of a CSV file, its numbers with four digits. */
export function csvTable(name, csv, most) {
  const { names: head, rows } = parseCsv(csv);
  const shown = rows.slice(0, most).map((cells) => cells.map(rounded));
  const caption = rows.length > most ? `the first ${most} of ${rows.length} rows of ${name}` : name;
  return table(head, shown, caption);
}

function rounded(cell) {
  const number = Number(cell);
  if (!cell || !Number.isFinite(number)) return cell;
  return String(Number.isInteger(number) ? number : Number(number.toPrecision(4)));
}

// Names with their values; those that few look for are folded.
function list(lines) {
  const is =
    (quiet) =>
    ([name]) =>
      QUIET.includes(name) === quiet;
  const [shown, folded] = [false, true].map((quiet) => lines.filter(is(quiet)));
  const more = folded.length > 0 ? [element("details", element("summary", "Numerical accuracy"), pairs(folded))] : [];
  return [pairs(shown), ...more];
}

function pairs(lines) {
  const list = element("dl");
  for (const [name, ...values] of lines) {
    const isLarge = LARGE.includes(name);
    const parts = values.flatMap((value, place) => [
      ...(isLarge ? emphasised(value, place) : [element("span", value)]),
      " ",
    ]);
    const className = isLarge ? "large" : "";
    list.append(element("dt", { className }, name), " ", element("dd", { className }, ...parts));
  }
  return list;
}

// A number and its interval are large, and the sentences after them are not.
function emphasised(value, place) {
  const end = place === 0 ? value.length : intervalEnd(value);
  // without a blank between them, as the text has none
  return [element("span", element("b", value.slice(0, end)), value.slice(end))];
}

// Where "(0.61 to 0.65" ends at the begin of a text; 0 for another text.
const intervalEnd = (text) => text.match(/^\([-\d.e]+ to [-\d.e]+\)?/)?.[0].length ?? 0;

/** A line of results with its number and its interval alone. */
export function shortened(line) {
  const [name, number, detail = ""] = line.trim().split(/ {2,}/);
  const interval = detail.slice(0, intervalEnd(detail)).replace(/([^)])$/, "$1)");
  return [name, number, interval].filter(Boolean).join(" ");
}

/** The last dent of a slow indentation, or its last force where nothing yields. */
export function lastStep(text) {
  const lines = text
    .split(/\n\n+/)[0]
    .split("\n")
    .map((line) => line.trim().split(/ {2,}/));
  const first = lines.findIndex(([cell]) => cell === "step");
  const [head, last] = [
    lines[first] ?? [],
    lines
      .slice(first)
      .filter((cells) => /^\d+$/.test(cells[0]))
      .at(-1) ?? [],
  ];
  const at = Math.max(head.indexOf("dent depth"), head.indexOf("force"));
  return at < 0 ? "" : `step ${last[0]}: ${head[at]} ${last[at]}`;
}

function table(head, rows, caption) {
  const cell = (name) => (text) => element(name, text);
  const line = (cells, name) => element("tr", ...cells.flatMap((text) => [cell(name)(text), " "]));
  const made = element("table", ...(caption ? [element("caption", caption)] : []));
  made.append(element("thead", line(head, "th")), element("tbody", ...rows.map((cells) => line(cells, "td"))));
  for (const one of made.querySelectorAll("th")) one.scope = "col";
  // a wide table can be moved on a narrow screen, also by keys
  const frame = element("div", { className: "frame", tabIndex: 0, role: "group", ariaLabel: caption ?? "table" });
  frame.append(made);
  return frame;
}
