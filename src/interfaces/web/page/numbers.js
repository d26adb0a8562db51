// Results as lists and tables of the page.

import { parseCsv } from "./csv.js";
import { element } from "./element.js";

// These lines of an impact say how exact it is, and how much work it was; they are folded.
const QUIET = ["closed form", "steps"];
// These are what most look for.
const LARGE = ["impact speed", "restitution"];

/** What the command says, as elements: sentences, lists and tables. */
export const elements = (blocks) => blocks.flatMap(elementsOf);

function elementsOf({ sentence, list, table }) {
  if (sentence) return [element("p", sentence)];
  if (list) return listOf(list);
  return [tableOf(table.rows)];
}

/** The first rows of a CSV file, its numbers with four digits. */
export function csvTable(name, csv, most) {
  const { names: head, rows } = parseCsv(csv);
  const shown = rows.slice(0, most).map((cells) => cells.map(rounded));
  const caption = rows.length > most ? `the first ${most} of ${rows.length} rows of ${name}` : name;
  return tableOf([head, ...shown], caption);
}

function rounded(cell) {
  const number = Number(cell);
  if (!cell || !Number.isFinite(number)) return cell;
  return String(Number.isInteger(number) ? number : Number(number.toPrecision(4)));
}

// Names with their values; those that few look for are folded.
function listOf(lines) {
  const isQuiet = ([name]) => QUIET.includes(name);
  const [shown, folded] = [lines.filter((line) => !isQuiet(line)), lines.filter(isQuiet)];
  const more = folded.length > 0 ? [element("details", element("summary", "Numerical accuracy"), pairs(folded))] : [];
  return [pairs(shown), ...more];
}

function pairs(lines) {
  const list = element("dl");
  for (const [name, ...values] of lines) {
    const isLarge = LARGE.includes(name);
    const parts = values
      .filter(Boolean)
      .flatMap((value, place) => [...(isLarge ? emphasised(value, place) : [element("span", value)]), " "]);
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

/** What stays in view of a run: e with its interval, the last dent or force of a slow indentation, or what comes first. */
export function headline(blocks, kind) {
  const lines = blocks.flatMap(({ sentence, list, table }) => list ?? table?.rows ?? [[sentence]]);
  const restitution = lines.find(([name]) => /^(last )?restitution/.test(name));
  if (restitution) return shortened(restitution);
  const steps = kind === "indentation" && blocks.find(({ table }) => table);
  return steps ? lastStep(steps.table.rows) : lines[0].filter(Boolean).join(" ");
}

// A line of results with its number and its interval alone.
function shortened([name, number, detail = ""]) {
  const interval = detail.slice(0, intervalEnd(detail)).replace(/([^)])$/, "$1)");
  return [name, number, interval].filter(Boolean).join(" ");
}

// The last dent of the steps, or their last force where nothing yields.
function lastStep([head, ...steps]) {
  const at = Math.max(head.indexOf("dent depth"), head.indexOf("force"));
  const last = steps.at(-1);
  return `step ${last[0]}: ${head[at]} ${last[at]}`;
}

function tableOf([head, ...rows], caption) {
  // the last cell of a short row takes the columns that are left
  const cell = (name, cells) => (text, at) =>
    element(name, { colSpan: at + 1 < cells.length ? 1 : head.length - at }, text);
  const line = (cells, name) => element("tr", ...cells.map(cell(name, cells)).flatMap((made) => [made, " "]));
  const made = element("table", ...(caption ? [element("caption", caption)] : []));
  made.append(element("thead", line(head, "th")), element("tbody", ...rows.map((cells) => line(cells, "td"))));
  for (const one of made.querySelectorAll("th")) one.scope = "col";
  // a wide table can be moved on a narrow screen, also by keys
  const frame = element("div", { className: "frame", tabIndex: 0, role: "group", ariaLabel: caption ?? "table" });
  frame.append(made);
  return frame;
}
