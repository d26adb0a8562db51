// The parts of the page that load after its first result: experiments by name, fields for a table, the bench, and files for a time without a network.

import { makeBench } from "./bench.js";
import { element } from "./element.js";
import { EXPERIMENTS, experiment } from "./experiments.js";
import { keepOffline } from "./offline.js";
import { makeSweepFields } from "./sweep.js";

const byId = (id) => document.getElementById(id);

/**
 * Makes all of it. `change([[path, value], ...], isMoving)` is called when the user changes values; `keptChanged()` after the kept
 * curves changed.
 */
export function makeLater({ fields, materials, change, keptChanged }) {
  const choices = EXPERIMENTS.map(({ name, title }) => new Option(title, name));
  byId("begin").firstElementChild.after(element("optgroup", { label: "Experiments" }, ...choices));
  const sweep = makeSweepFields(byId("sweep"), { fields, changed: change });
  const bench = makeBench({
    fields,
    materials,
    change: (path, value) => change([[path, value]], true),
    keptChanged,
  });
  keepOffline();

  /** Shows the values that a scenario gives. */
  function fill(values) {
    bench.fill(values);
    sweep.fill(values);
  }
  return { bench, experiment, fill };
}
