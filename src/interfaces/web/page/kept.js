// The curves that a user keeps: scenarios as text, with what the program says of each. They stand beside the curve of the scenario of
// the page, which has the number 0.

import { csvOf } from "./csv.js";
import { download, element } from "./element.js";
import { csvTable } from "./numbers.js";

/** The largest number of curves that are kept: as many as have a colour. */
export const MOST = 6;
const FILE = "kept.csv";
// The columns of the table: names of results with their units.
const RESULTS = ["restitution", "contact_time_s", "peak_force_N", "peak_indentation_m", "residual_indentation_m"];
// These keys say nothing of the impact.
const SILENT = ["output", "solver"];

/** The keys in which scenarios differ, in the order of the first that gives each. */
export function differingKeys(scenarios) {
  const keys = [...new Set(scenarios.flatMap((values) => Object.keys(values)))];
  const differs = (key) => new Set(scenarios.map((values) => values[key] ?? "")).size > 1;
  return keys.filter((key) => !SILENT.includes(key.split(".")[0]) && differs(key));
}

/** The name of a scenario among others: its values of the keys in which they differ. */
export function nameOf(values, keys) {
  const words = (key) => key.replaceAll(/[._]/g, " ").replace("half space", "half-space");
  const named = keys.filter((key) => values[key] !== undefined).map((key) => `${words(key)} ${values[key]}`);
  return named.length > 0 ? named.join(", ") : "the same values";
}

/** The kept curves as a table: a row for each, with the keys in which they differ, as they are written, and the main results. */
export function keptCsv(kept) {
  const keys = differingKeys(kept.map(({ values }) => values));
  const row = ({ values, curves }, at) => [
    at + 1,
    ...keys.map((key) => values[key] ?? ""),
    ...RESULTS.map((name) => curves.summary[name] ?? ""),
  ];
  return csvOf([["curve", ...keys, ...RESULTS], ...kept.map(row)]);
}

/** Shows the key of the curves and the table of the kept ones; `changed()` is called after a curve is removed. */
export function showKept({ key, table }, kept, values, changed) {
  const keys = differingKeys([values, ...kept.map((one) => one.values)]);
  const entries = [{ values, name: "This scenario" }, ...kept].map((one, number) => {
    const sample = element("span", { className: `sample c${number}` });
    const name = one.name ?? nameOf(one.values, keys);
    const label = number === 0 && kept.length > 0 ? `${name}: ${nameOf(values, keys)}` : name;
    const line = element("li", sample, label);
    if (number > 0) {
      const button = element("button", { type: "button", ariaLabel: `Remove ${name}` }, "Remove");
      button.addEventListener("click", () => {
        kept.splice(number - 1, 1);
        changed();
      });
      line.append(" ", button);
    }
    return line;
  });
  key.replaceChildren(...entries);
  key.hidden = kept.length === 0;
  const done = kept.filter(({ curves }) => curves);
  table.hidden = done.length === 0;
  if (done.length === 0) return;
  const save = element("button", { type: "button", id: "save-kept" }, `Download ${FILE}`);
  save.addEventListener("click", () => download(FILE, keptCsv(done)));
  table.replaceChildren(csvTable("Kept curves", keptCsv(done), MOST), save);
}
