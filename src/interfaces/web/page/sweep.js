// Fields for a table: a key that varies over a range, and perhaps a second one with a list of values.

import { element } from "./element.js";
import { parts } from "./value.js";

const AXIS = "sweep";
const POINTS = 61;

/**
 * Makes the fields in `place`; `changed([[path, value], ...])` is called with another table of axes, or with an empty one when the
 * table is taken away.
 */
export function makeSweepFields(place, { fields, changed }) {
  const numeric = fields.filter(
    ({ unit, words, path }) => unit !== undefined && !words && !/^(output|solver|repeat|calibrate)\b/.test(path),
  );
  let values = {};
  const first = keyList("sweep-key", "Key that varies");
  const second = keyList("sweep-second", "Second key");
  second.prepend(new Option("none", ""));
  const low = text("sweep-low");
  const high = text("sweep-high");
  const points = Object.assign(text("sweep-points"), { inputMode: "numeric", value: String(POINTS) });
  const spacing = element(
    "select",
    { id: "sweep-spacing" },
    new Option("equal ratios", "logspace"),
    new Option("equal steps", "linspace"),
  );
  const list = Object.assign(text("sweep-list"), { placeholder: "such as 200 MPa, 345 MPa" });
  const make = element("button", { type: "button", id: "sweep-make" }, "Make the table");
  const remove = element("button", { type: "button", id: "sweep-remove", hidden: true }, "Back to one impact");
  const listed = labelled("Its values, with commas", list);
  place.append(
    labelled("Key that varies", first),
    labelled("From", low),
    labelled("To", high),
    labelled("Points", points),
    labelled("Spacing", spacing),
    labelled("Second key", second),
    listed,
    element("p", make, " ", remove),
  );

  function keyList(id, ariaLabel) {
    const select = element("select", { id, ariaLabel });
    for (const { path, title } of numeric) select.append(new Option(title, path));
    return select;
  }

  function text(id) {
    return element("input", { type: "text", id, spellcheck: false, autocomplete: "off" });
  }

  function labelled(name, input) {
    return element("div", { className: "row" }, element("label", { htmlFor: input.id }, name), input);
  }

  // a range about the value of the key: two decades, as wide as a curve is worth to be looked at
  function propose() {
    const found = parts(values[first.value] ?? numeric.find(({ path }) => path === first.value)?.example);
    if (!found) return;
    const around = (factor) => `${Number((found.number * factor).toPrecision(2))} ${found.unit}`.trim();
    [low.value, high.value] = [around(0.1), around(10)];
  }

  function axes() {
    const range = `${JSON.stringify(first.value)} = { ${spacing.value} = [${toml(low.value)}, ${toml(high.value)}], points = ${points.value.trim() || POINTS} }`;
    const many = list.value.split(/[,;]/).filter((one) => one.trim());
    const other =
      second.value && many.length > 0 ? `, ${JSON.stringify(second.value)} = [${many.map(toml).join(", ")}]` : "";
    return `{ ${range}${other} }`;
  }

  // a number as it is, and a number with a unit in quotes
  function toml(value) {
    const typed = value.trim();
    return typed && Number.isFinite(Number(typed)) ? String(Number(typed)) : JSON.stringify(typed);
  }

  first.value = "impact.speed";
  first.addEventListener("change", propose);
  second.addEventListener("change", () => (listed.hidden = !second.value));
  listed.hidden = true;
  make.addEventListener("click", () =>
    changed([
      [AXIS, ""],
      [AXIS, axes()],
    ]),
  );
  remove.addEventListener("click", () => changed([[AXIS, ""]]));

  /** Shows whether the scenario is a table. */
  function fill(newValues) {
    values = newValues;
    remove.hidden = !Object.keys(values).some((path) => path === AXIS || path.startsWith(`${AXIS}.`));
    if (!low.value) propose();
  }
  return { fill };
}
