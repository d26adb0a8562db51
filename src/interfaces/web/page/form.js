// The form: a group for every table of a scenario, a field for every key that is one value. Keys, examples, words and materials
// come from the program.

import { element } from "./element.js";
import { makeRow } from "./row.js";

// These groups are open, and there for every kind of scenario.
const MAIN = ["sphere", "half_space", "impact"];

/**
 * Fills `form` with the fields; `changed([[path, value], ...])` is called when the user changes some. Keys of the main groups
 * that are not `usual` are folded. `openText()` shows the text, for keys that have no field.
 */
export function makeForm(form, { fields, materials, kinds, usual, changed, openText }) {
  const rows = new Map();
  const groups = new Map();
  let values = {};

  const keys = element("span");
  const open = element("button", { type: "button" }, "Open the scenario file");
  open.addEventListener("click", openText);
  const elsewhere = element("p", { id: "elsewhere", hidden: true }, "Keys without a form field: ", keys, ". ", open);
  form.append(elsewhere);

  // a material takes the place of the numbers that it has; a material that is taken away leaves its numbers
  function setMaterial([[path, name]]) {
    const table = path.split(".")[0];
    const known = (name) => Object.entries(materials.find((one) => one.name === name)?.values ?? {});
    const of = (name) => known(name).filter(([key]) => key.split(".")[0] === table);
    const instead = (key) => fields.find((field) => field.path === key)?.instead;
    const group = (key) => fields.filter((field) => (field.instead ?? field.path) === (instead(key) ?? key));
    const out = of(name)
      .flatMap(([key]) => [key, instead(key)])
      .filter((key) => values[key]);
    const back = name ? [] : of(values[path]).filter(([key]) => group(key).every((field) => !values[field.path]));
    changed([[path, name], ...out.map((key) => [key, ""]), ...back]);
  }

  function makeGroup(table) {
    const main = MAIN.includes(table);
    const name = table.replace("_", "-");
    const error = element("p", { className: "error", id: `error-${table}`, hidden: true });
    const more = element(
      "details",
      { className: "more" },
      element("summary", { ariaLabel: `More of ${name}` }, "More"),
    );
    const group = element("details", { open: main, className: "group" }, element("summary", name), error);
    form.append(group);
    return { group, error, more, main, isKind: !main && kinds.includes(table) };
  }

  // where the row of a field stands: the material first, what is seldom needed folded at the end
  function place(row, path, { group, error, more, main }) {
    const isUsual = !main || path.endsWith(".material") || usual.includes(path);
    if (path.endsWith(".material")) error.after(row.line);
    else if (isUsual) more.isConnected ? more.before(row.line) : group.append(row.line);
    else more.append(row.line);
    if (!isUsual) group.append(more);
  }

  for (const field of fields) {
    const table = field.path.split(".")[0];
    if (!groups.has(table)) groups.set(table, makeGroup(table));
    const beside = field.instead && rows.get(field.instead);
    if (beside) beside.add(field);
    const row = beside || makeRow(field, materials, field.path === `${table}.material` ? setMaterial : changed);
    rows.set(field.path, row);
    if (!beside) place(row, field.path, groups.get(table));
  }
  const unique = new Set(rows.values());
  form.addEventListener("submit", (event) => event.preventDefault());

  /** Shows the values that a scenario gives. */
  function fill(givenValues) {
    for (const row of unique) row.fill(givenValues);
    values = givenValues;
    for (const [table, { group, main, isKind }] of groups) {
      const isGiven = Object.keys(givenValues).some((path) => path === table || path.startsWith(`${table}.`));
      if (!main && isGiven) group.open = true;
      group.hidden = isKind && !isGiven;
    }
    for (const row of unique) if (row.isGiven(givenValues)) unfold(row);
    for (const [path, row] of rows) {
      const [table, law] = path.split(".");
      if (table === "law" && law) row.line.hidden = law !== (givenValues.law ?? "plm");
    }
    const others = Object.keys(givenValues).filter((path) => !rows.has(path));
    elsewhere.hidden = others.length === 0;
    keys.textContent = others.join(", ");
  }

  function unfold(row) {
    const more = row.line.closest(".more");
    if (more) more.open = true;
  }

  /** Shows what is wrong at its field or group, with a button that cures it, if there is one; says whether there is a place. */
  function showError(key, message, cure) {
    for (const row of unique) row.showError(null);
    for (const { error } of groups.values()) error.hidden = true;
    if (!key) return false;
    const row = rows.get(key);
    const group = groups.get(key.split(".")[0]);
    if (!group || (!row && key !== key.split(".")[0])) return false;
    group.group.open = true;
    if (row) {
      unfold(row);
      row.showError(message, key, cure);
    } else {
      group.error.replaceChildren(message, ...(cure ? [" ", cure] : []));
      group.error.hidden = false;
    }
    return true;
  }

  return { fill, showError, focus: (path) => rows.get(path)?.input.focus() };
}
