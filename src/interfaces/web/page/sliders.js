// Sliders of speed, size and strength: each is the key that the scenario or its material gives, of those that stand in place of each other.

import { element } from "./element.js";
import { parts, written } from "./value.js";

const SLIDERS = [
  { name: "Speed", id: "speed", keys: ["impact.speed", "impact.drop_height"] },
  { name: "Size", id: "size", keys: ["sphere.radius", "sphere.diameter"] },
  {
    name: "Strength",
    id: "strength",
    keys: ["half_space.yield_strength", "half_space.hardness", "sphere.yield_strength", "sphere.hardness"],
  },
];
// Steps of a decade: 1.2 % a step, as an arrow key makes it.
const STEP = 0.005;

/** Makes the sliders in `place`; `changed(path, value)` is called while one moves. */
export function makeSliders(place, { fields, materials, changed }) {
  const titles = new Map(fields.map(({ path, title }) => [path, title]));
  const shown = SLIDERS.map(makeSlider);
  place.append(...shown.map(({ line }) => line));

  function makeSlider({ name, id, keys }) {
    const input = element("input", { type: "range", id: `slide-${id}`, step: STEP });
    const value = element("output");
    const label = element("label", { htmlFor: input.id }, name);
    const line = element("div", { className: "slider" }, label, input, value);
    let path = null;
    let unit = "";
    // a range stays while its value is moved, and is laid anew for a value from elsewhere
    let known = null;

    const typed = () => `${written(10 ** input.valueAsNumber)} ${unit}`.trim();
    function tell() {
      known = typed();
      say(known);
      changed(path, known);
    }
    input.addEventListener("input", tell);

    function say(text) {
      value.textContent = text;
      input.setAttribute("aria-valuetext", `${titles.get(path)} ${text}`);
    }

    function fill(values) {
      const brought = Object.assign(
        {},
        ...["sphere", "half_space"].map((body) => {
          const material = materials.find((one) => one.name === values[`${body}.material`]);
          const own = Object.entries(material?.values ?? {}).filter(([key]) => key.startsWith(`${body}.`));
          return Object.fromEntries(own);
        }),
      );
      const given = keys.find((key) => values[key] !== undefined) ?? keys.find((key) => brought[key] !== undefined);
      const found = parts(values[given] ?? brought[given]);
      line.hidden = !found;
      if (!found) return;
      const text = values[given] ?? brought[given];
      if (given === path && text === known) return;
      [path, unit, known] = [given, found.unit, text];
      const at = Math.log10(found.number);
      const isInside = input.min !== "" && at > Number(input.min) + 0.3 && at < Number(input.max) - 0.3;
      if (!isInside || input.dataset.of !== `${path} ${unit}`) {
        Object.assign(input, { min: Math.floor(at) - 1, max: Math.floor(at) + 2 });
        input.dataset.of = `${path} ${unit}`;
      }
      input.value = at;
      say(text);
    }
    return { line, fill };
  }

  return { fill: (values) => shown.forEach(({ fill }) => fill(values)) };
}
