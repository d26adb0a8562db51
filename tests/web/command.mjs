// The command, which says what is right, and the folder of the page. .ci/run makes both.

import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

export const ROOT = resolve(import.meta.dirname, "../..");
export const SCENARIOS = join(ROOT, "scenarios");
export const PAGE = join(ROOT, "target/web-test");
// where cargo builds: target, or what a variable or a configuration file says
const said = spawnSync("cargo", ["metadata", "--format-version", "1", "--no-deps"], {
  cwd: ROOT,
  encoding: "utf8",
  maxBuffer: 1 << 28,
});
export const COMMAND = join(JSON.parse(said.stdout).target_directory, "debug/plm-impact");

/** Calls the command in the folder of the scenarios, with a text as standard input. */
export function callWith(input, ...words) {
  const { status, stdout, stderr } = spawnSync(COMMAND, words, {
    input,
    cwd: SCENARIOS,
    encoding: "utf8",
    maxBuffer: 1 << 28,
  });
  return { status, stdout, stderr };
}

/** Calls it without. */
export const call = (...words) => callWith("", ...words);

/** What the command writes and says of a scenario, with pictures as SVG. */
export function runByCommand(name, ...words) {
  const folder = mkdtempSync(join(tmpdir(), "plm-impact-"));
  const said = call("run", name, "--verbose", "--pictures", "svg", "--out", folder, ...words);
  const files = Object.fromEntries(readdirSync(folder).map((file) => [file, readFileSync(join(folder, file), "utf8")]));
  rmSync(folder, { recursive: true });
  return { ...said, files };
}

/** The scenario that the page begins with: an example, without the kind of its strength. */
export const FIRST = ["steel-on-steel.toml", "--set", "half_space.strength_kind=none"];

/** A scenario as text. */
export const read = (name) => readFileSync(join(SCENARIOS, name), "utf8");

/** A summary without the command line and the way from the results to the scenario, which differ. */
export const withoutCommand = (summary) => summary.replace(/\n *"(command|scenario_path)": .*/g, "");
