// The program of the page, without a browser: for every scenario the files, texts and warnings of the command, to the last bit.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { PAGE, SCENARIOS, call, callWith, read, runByCommand, withoutCommand } from "./command.mjs";

const glue = readFileSync(join(PAGE, "plm_impact.js"), "utf8");
const program = await import(`data:text/javascript;base64,${Buffer.from(glue).toString("base64")}`);
program.initSync({ module: readFileSync(join(PAGE, "plm_impact_bg.wasm")) });

const run = (name, text, data) => JSON.parse(program.run(name, text, data));

const scenarios = readdirSync(SCENARIOS).filter((name) => name.endsWith(".toml"));

test("the page has the licences that the command prints", () => {
  const { stdout } = call("--licenses");
  const licences = readFileSync(join(PAGE, "licenses.txt"), "utf8");
  assert.ok(licences.length > 10_000 && stdout.endsWith(licences));
  assert.match(readFileSync(join(PAGE, "index.html"), "utf8"), /href="licenses.txt"/);
});

test("there are scenarios", () => assert.ok(scenarios.length > 30, `${scenarios.length}`));

for (const name of scenarios) {
  test(`${name}: the files of the command`, () => {
    const text = read(name);
    const data = JSON.parse(program.given(text))["calibrate.data"];
    const reply = run(name, text, data && read(data));
    const { status, stdout, stderr, files } = runByCommand(name);
    assert.equal(status, 0, stderr);
    assert.equal(reply.text, stdout);
    assert.deepEqual(Object.keys(reply.files).sort(), Object.keys(files).sort());
    for (const file of Object.keys(files)) {
      assert.ok(withoutCommand(reply.files[file]) === withoutCommand(files[file]), `${file} differs`);
    }
    const said = stderr.split("\n").filter((line) => line.startsWith("warning: "));
    assert.deepEqual(reply.warnings.map((warning) => `warning: ${warning}`), said);
    assert.equal(reply.curve !== null, reply.kind === "impact");
  });
}

test("a check says what the command says", () => {
  const { text } = JSON.parse(program.check("steel-on-steel.toml", read("steel-on-steel.toml")));
  assert.equal(text, call("check", "steel-on-steel.toml").stdout);
});

const WRONG = [
  ["a wrong unit", 'speed = "0.1 m/s"', 'speed = "3 kg"'],
  ["an unknown key", "speed =", "sped ="],
  ["no TOML", 'speed = "0.1 m/s"', 'speed = "'],
  ["a value beyond its range", "poissons_ratio = 0.3", "poissons_ratio = 0.7"],
];
for (const [what, right, wrong] of WRONG) {
  test(`an error is that of the command: ${what}`, () => {
    const text = read("elastic.toml").replace(right, wrong);
    const { error, exit_code, details } = run("stdin", text);
    const { stderr, status } = callWith(text, "check", "-", "--error-format", "json");
    const { level, message, ...said } = JSON.parse(stderr);
    assert.equal(level, "error");
    assert.equal(details.message ?? error, message);
    delete details.message;
    assert.deepEqual({ exit_code, ...details }, said);
    assert.equal(exit_code, status);
  });
}

test("schema, materials and first scenarios are those of the command", () => {
  assert.deepEqual(JSON.parse(program.schema()), JSON.parse(call("schema").stdout));
  const materials = JSON.parse(program.materials());
  assert.equal(materials[0].page, call("materials", materials[0].name).stdout);
  for (const [kind, text] of Object.entries(JSON.parse(program.init()))) {
    assert.equal(text, call("init", kind, "--out", "-").stdout);
  }
});

test("every field is a key of the schema", () => {
  const schema = JSON.parse(program.schema());
  const fields = JSON.parse(program.fields());
  assert.ok(fields.length > 60, `${fields.length}`);
  for (const { path } of fields) {
    const found = path.split(".").reduce((table, key) => table?.properties?.[key], schema);
    assert.ok(found, path);
  }
});

test("a table that is too long for a page is refused in words", () => {
  const text = read("steel-on-steel.toml") + '[sweep]\n"impact.speed" = { linspace = [1, 2], points = 100001 }\n';
  const { error, details } = run("long.toml", text);
  assert.match(error, /^long\.toml:\d+:\d+: sweep: a table of 100001 rows: a page computes at most 100000;/);
  assert.equal(details.key, "sweep");
});

test("e against speed as CSV is the table of the command", () => {
  const { curve } = run("steel-on-steel.toml", read("steel-on-steel.toml"));
  const axis = 'sweep."impact.speed"={ logspace = [1e-2, 1e2], points = 601 }';
  const { files } = runByCommand("steel-on-steel.toml", "--set", axis, "--set", 'output.columns=["restitution"]');
  assert.equal(curve["restitution.csv"], files["table.csv"]);
});

test("command and page are looked for where cargo builds", () => {
  const script = `import("${new URL("command.mjs", import.meta.url)}").then(({ COMMAND }) => console.log(COMMAND))`;
  const env = { ...process.env, CARGO_TARGET_DIR: "/elsewhere" };
  const { stdout, stderr } = spawnSync(process.execPath, ["-e", script], { env, encoding: "utf8" });
  assert.equal(stdout.trim(), "/elsewhere/debug/plm-impact", stderr);
});
