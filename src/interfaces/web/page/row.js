// A row of the form: the field of a key, or of two keys that stand in place of each other.

import { element } from "./element.js";
import { parts, stepped } from "./value.js";

/** Makes the row of a field; `changed([[path, value], ...])` is called when the user changes it. */
export function makeRow(first, materials, changed) {
  const fields = [first];
  let field = first;
  const id = `field-${first.path}`;
  const input = first.words ? choice(first) : element("input", { type: "text", spellcheck: false });
  input.id = id;
  input.setAttribute("aria-describedby", `about-${id} unit-${id} error-${id}`);
  const label = element("label", { htmlFor: id, textContent: short(first) });
  input.setAttribute("aria-label", first.title);
  const unit = element("span", { id: `unit-${id}`, className: "unit" });
  const about = element("p", { id: `about-${id}`, className: "about", textContent: first.description });
  const error = element("p", { id: `error-${id}`, className: "error", hidden: true });
  const line = element(
    "div",
    { className: "row" },
    label,
    element("div", { className: "field" }, input, unit),
    about,
    error,
  );
  let names = null;
  // what the scenario is known to give
  let known = "";
  let isTyping = false;

  // some browsers and tools send only one of the two events
  for (const kind of ["input", "change"]) input.addEventListener(kind, tell);
  if (!first.words) input.addEventListener("keydown", turn);

  // the keys up and down change a number by one in its second digit
  function turn(event) {
    const found = { ArrowUp: 1, ArrowDown: -1 }[event.key] && parts(input.value);
    if (!found) return;
    event.preventDefault();
    input.value = `${stepped(found.number, event.key === "ArrowUp" ? 1 : -1)} ${found.unit}`.trim();
    tell();
  }

  function tell() {
    const value = input.value.trim();
    if (value === known) return;
    isTyping = true;
    changed([[field.path, value]]);
    isTyping = false;
    known = value;
    showUnit();
  }

  // a number that is written alone is in SI, which is said beside it
  function showUnit() {
    const value = input.value.trim();
    unit.textContent = value && Number.isFinite(Number(value.replaceAll("_", ""))) ? (field.unit ?? "") : "";
  }

  // the key that the row is about, of those that stand in place of each other
  function show(other) {
    field = other;
    about.textContent = field.description;
    if (names) names.value = field.path;
    input.setAttribute("aria-label", field.title);
  }

  function add(other) {
    fields.push(other);
    if (!names) {
      names = element("select", { className: "names", ariaLabel: `${first.title}, or alternative key` });
      names.append(new Option(short(first), first.path));
      label.replaceWith(names);
      names.addEventListener("change", () => {
        const before = field;
        show(fields.find((one) => one.path === names.value));
        const value = before.example === field.example ? input.value : field.example;
        changed([
          [field.path, value],
          [before.path, ""],
        ]);
      });
    }
    names.append(new Option(short(other), other.path));
    show(field);
  }

  const isGiven = (givenValues) => fields.some((one) => givenValues[one.path] !== undefined);

  /** Shows the value that a scenario gives, or that a material brings. */
  function fill(givenValues) {
    const [table, key] = field.path.split(".");
    const material = materials.find((one) => one.name === givenValues[`${table}.material`]);
    const here = (values) => fields.find((one) => values?.[one.path] !== undefined);
    if (givenValues[field.path] === undefined) show(here(givenValues) ?? here(material?.values) ?? field);
    known = givenValues[field.path] ?? "";
    if (!isTyping && input.value !== known) {
      if (field.words && known && ![...input.options].some((one) => one.value === known))
        input.append(new Option(known));
      input.value = known;
    }
    if (key === "material") about.textContent = material ? material.title : field.description;
    if (!field.words) input.placeholder = material?.values[field.path] ?? (field.default || `such as ${field.example}`);
    showUnit();
  }

  /** Shows what is wrong, with a button that cures it, if there is one. */
  function showError(message, key, cure) {
    if (key) show(fields.find((one) => one.path === key));
    error.hidden = !message;
    error.replaceChildren(message ?? "", ...(cure ? [" ", cure] : []));
    input.setAttribute("aria-invalid", String(Boolean(message)));
  }

  return { line, input, add, fill, isGiven, showError };
}

// The title without the name of the group in which it stands.
function short({ path, title }) {
  const group = path.split(".")[0].replace("_", "-");
  const rest = title.toLowerCase().startsWith(`${group} `) ? title.slice(group.length + 1) : title;
  return rest[0].toUpperCase() + rest.slice(1);
}

function choice({ words, default: otherwise }) {
  const select = element("select");
  select.append(new Option(otherwise ? `${otherwise} (default)` : "–", ""));
  for (const word of words) select.append(new Option(word));
  return select;
}
