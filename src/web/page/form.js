// The form: a group for every table of a scenario, a field for every key that is one value. Keys, examples, words and materials
// come from the program.

import { element } from "./element.js";

// These groups are open, and there for every kind of scenario.
const MAIN = ["sphere", "half_space", "impact"];

/** Fills `form` with the fields; `changed([[path, value], ...])` is called when the user changes some. */
export function makeForm(form, { fields, materials, kinds, changed }) {
  const rows = new Map();
  const groups = new Map();
  let values = {};

  // a material takes the place of the numbers that it has; a material that is taken away leaves its numbers
  function take([[path, name]]) {
    const table = path.split(".")[0];
    const known = (name) => Object.entries(materials.find((one) => one.name === name)?.values ?? {});
    const of = (name) => known(name).filter(([key]) => key.split(".")[0] === table);
    const instead = (key) => fields.find((field) => field.path === key)?.instead;
    const pair = (key) => instead(key) ?? fields.find((field) => field.instead === key)?.path;
    const out = of(name).flatMap(([key]) => [key, instead(key)]).filter((key) => values[key]);
    const back = name ? [] : of(values[path]).filter(([key]) => !values[key] && !values[pair(key)]);
    changed([[path, name], ...out.map((key) => [key, ""]), ...back]);
  }

  for (const field of fields) {
    const table = field.path.split(".")[0];
    if (!groups.has(table)) {
      const main = MAIN.includes(table);
      const legend = element("summary", table.replace("_", "-"));
      const error = element("p", { className: "error", id: `error-${table}`, hidden: true });
      const group = element("details", { open: main, className: "group" }, legend, error);
      groups.set(table, { group, error, main, isKind: !main && kinds.includes(table) });
      form.append(group);
    }
    const place = field.instead && rows.get(field.instead);
    if (place) {
      place.add(field);
      rows.set(field.path, place);
    } else {
      const row = makeRow(field, materials, field.path === `${table}.material` ? take : changed);
      rows.set(field.path, row);
      const { group, error } = groups.get(table);
      if (field.path === `${table}.material`) error.after(row.line);
      else group.append(row.line);
    }
  }
  form.addEventListener("submit", (event) => event.preventDefault());

  /** Shows the values that a scenario gives. */
  function fill(given) {
    const unique = new Set(rows.values());
    for (const row of unique) row.fill(given);
    values = given;
    for (const [table, { group, main, isKind }] of groups) {
      const isGiven = Object.keys(given).some((path) => path === table || path.startsWith(`${table}.`));
      if (!main && isGiven) group.open = true;
      group.hidden = isKind && !isGiven;
    }
    for (const [path, row] of rows) {
      const [table, law] = path.split(".");
      if (table === "law" && law) row.line.hidden = law !== (given.law ?? "plm");
    }
  }

  /** Shows what is wrong at its field or group; says whether there is one. */
  function complain(key, message) {
    for (const row of new Set(rows.values())) row.complain(null);
    for (const { error } of groups.values()) error.hidden = true;
    if (!key) return false;
    const row = rows.get(key);
    const group = groups.get(key.split(".")[0]);
    if (!group || (!row && key !== key.split(".")[0])) return false;
    group.group.open = true;
    if (row) row.complain(message, key);
    else Object.assign(group.error, { textContent: message, hidden: false });
    return true;
  }

  return { fill, complain };
}

function makeRow(first, materials, changed) {
  const fields = [first];
  let field = first;
  const id = `field-${first.path}`;
  const input = first.words ? choice(first) : element("input", { type: "text", spellcheck: false });
  input.id = id;
  input.setAttribute("aria-describedby", `about-${id} error-${id}`);
  const label = element("label", { htmlFor: id, textContent: short(first) });
  input.setAttribute("aria-label", first.title);
  const about = element("p", { id: `about-${id}`, className: "about", textContent: first.about });
  const error = element("p", { id: `error-${id}`, className: "error", hidden: true });
  const line = element("div", { className: "row" }, label, input, about, error);
  // an empty field takes its key away, but not while somebody is typing in it
  input.addEventListener("input", () => (input.value.trim() || first.words) && changed([[field.path, input.value]]));
  input.addEventListener("change", () => input.value.trim() || first.words || changed([[field.path, ""]]));
  let names = null;

  // the key that the row is about, of two that stand in place of each other
  function show(other) {
    field = other;
    about.textContent = field.about;
    if (names) names.value = field.path;
    input.setAttribute("aria-label", field.title);
  }

  function add(other) {
    fields.push(other);
    if (!names) {
      names = element("select", { className: "names", ariaLabel: `${first.title}, or what stands in its place` });
      names.append(new Option(short(first), first.path));
      label.replaceWith(names);
      names.addEventListener("change", () => {
        const before = field;
        show(fields.find((one) => one.path === names.value));
        const value = before.example === field.example ? input.value : field.example;
        changed([[field.path, value], [before.path, ""]]);
      });
    }
    names.append(new Option(short(other), other.path));
    show(field);
  }

  function fill(given) {
    const there = fields.find((one) => given[one.path] !== undefined);
    if (there && !(given[field.path] !== undefined)) show(there);
    const value = given[field.path] ?? "";
    const isTyped = input === document.activeElement && input.tagName === "INPUT";
    if (!isTyped && input.value !== value) {
      if (field.words && value && ![...input.options].some((one) => one.value === value)) input.append(new Option(value));
      input.value = value;
    }
    const [table, key] = field.path.split(".");
    const material = materials.find((one) => one.name === given[`${table}.material`]);
    if (key === "material") about.textContent = material ? material.title : field.about;
    if (!field.words) input.placeholder = material?.values[field.path] ?? (field.default || `such as ${field.example}`);
  }

  function complain(message, key) {
    if (key) show(fields.find((one) => one.path === key));
    error.hidden = !message;
    error.textContent = message ?? "";
    input.setAttribute("aria-invalid", String(Boolean(message)));
  }

  return { line, add, fill, complain };
}

// The title without the name of the group in which it stands.
function short({ path, title }) {
  const group = path.split(".")[0].replace("_", "-");
  const rest = title.toLowerCase().startsWith(`${group} `) ? title.slice(group.length + 1) : title;
  return rest[0].toUpperCase() + rest.slice(1);
}

function choice({ words, default: otherwise }) {
  const select = element("select");
  select.append(new Option(otherwise ? `${otherwise} (if nothing is chosen)` : "–", ""));
  for (const word of words) select.append(new Option(word));
  return select;
}
