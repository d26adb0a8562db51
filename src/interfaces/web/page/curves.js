// The curves of an impact, read from the files of the program: e against the speed, and force against indentation.

import { parseCsv } from "./csv.js";

/** What is drawn of the reply to one impact; `null` for a reply of another kind. */
export function curvesOf({ kind, files, curve }) {
  if (kind !== "impact" || !files?.["trace.csv"]) return null;
  const summary = JSON.parse(files["summary.json"]);
  const trace = parseCsv(files["trace.csv"]);
  const numbers = (name) => trace.column(name).map(Number);
  const [time, indentation, force] = ["time_s", "indentation_m", "force_N"].map(numbers);
  const dent = numbers("half_space_indentation_m");
  const branch = trace.column("branch");
  const rows = time.map((t, at) => ({
    time: t,
    indentation: indentation[at],
    force: force[at],
    dent: dent[at],
    branch: branch[at],
  }));
  return {
    summary,
    rows,
    loop: rows.map((row) => [row.indentation, row.force]),
    restitution: restitutionOf(curve, summary),
  };
}

// e against speed or drop height, whose column is between the number of the case and the result
function restitutionOf(curve, summary) {
  if (!curve) return null;
  const { names, column } = parseCsv(curve["restitution.csv"]);
  const axis = names.find((name) => /^impact_(speed|drop_height)_/.test(name));
  const [at, e] = [column(axis).map(Number), column("restitution")];
  const points = at
    .map((value, row) => [value, e[row] === "" ? NaN : Number(e[row])])
    .filter(([, e]) => Number.isFinite(e));
  const isHeight = axis.includes("drop_height");
  return { points, isHeight, here: [summary.inputs[axis], summary.restitution] };
}
