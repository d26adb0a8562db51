// The program of the page, without a browser: for a scenario of every kind the files, texts and warnings of the command, to the last bit.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

import { PAGE, SCENARIOS, call, callWith, read, runByCommand, withoutCommand } from "./command.mjs";

const glue = readFileSync(join(PAGE, "plm_impact.js"), "utf8");
const program = await import(`data:text/javascript;base64,${Buffer.from(glue).toString("base64")}`);
program.initSync({ module: readFileSync(join(PAGE, "plm_impact_bg.wasm")) });

const run = (name, text, data) => JSON.parse(program.run(name, text, data, "svg"));

// the cells and sentences of blocks, in the order of the text
const wordsOf = (blocks) =>
  blocks
    .flatMap(({ sentence, list, table }) => list ?? table?.rows ?? [sentence])
    .flat()
    .join(" ")
    .split(/\s+/)
    .filter(Boolean)
    .join(" ");

// scenarios that have all tables together, none of which has only tables that others before it have; and that of all laws
const scenarios = ["restitution-of-all-laws.toml"];
const known = new Set();
for (const name of readdirSync(SCENARIOS)
  .filter((name) => name.endsWith(".toml"))
  .sort()) {
  const tables = [...read(name).matchAll(/^\[(\w+)/gm)].map(([, table]) => table);
  if (tables.some((table) => !known.has(table))) scenarios.push(name);
  tables.forEach((table) => known.add(table));
}

test("the page has the licences that the command prints", () => {
  const { stdout } = call("--licenses");
  const licences = readFileSync(join(PAGE, "licenses.txt"), "utf8");
  assert.ok(licences.length > 10_000 && stdout.endsWith(licences));
  assert.match(readFileSync(join(PAGE, "index.html"), "utf8"), /href="licenses.txt"/);
});

test("there are scenarios of every kind", () => {
  // an impact has none of these tables
  const kinds = ["sweep", "monte_carlo", "repeat", "indentation", "calibrate"];
  assert.deepEqual(
    kinds.filter((kind) => !known.has(kind)),
    [],
  );
});

for (const name of scenarios) {
  test(`${name}: the files of the command`, () => {
    const text = read(name);
    const data = JSON.parse(program.given_values(text))["calibrate.data"];
    const reply = run(name, text, data && read(data));
    const { status, stdout, stderr, files } = runByCommand(name);
    assert.equal(status, 0, stderr);
    assert.equal(wordsOf(reply.blocks), stdout.split(/\s+/).filter(Boolean).join(" "));
    assert.deepEqual(Object.keys(reply.files).sort(), Object.keys(files).sort());
    for (const file of Object.keys(files)) {
      assert.ok(withoutCommand(reply.files[file]) === withoutCommand(files[file]), `${file} differs`);
    }
    const said = stderr.split("\n").filter((line) => line.startsWith("warning: "));
    assert.deepEqual(
      reply.warnings.map((warning) => `warning: ${warning}`),
      said,
    );
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
  for (const [kind, text] of Object.entries(JSON.parse(program.templates()))) {
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
  assert.match(error, /^long\.toml:\d+:\d+: sweep: the page is limited to 100000 rows, and 100001 are requested\./);
  assert.equal(details.key, "sweep");
});

test("e against speed as CSV is the table of the command", () => {
  const { curve } = run("steel-on-steel.toml", read("steel-on-steel.toml"));
  const axis = 'sweep."impact.speed"={ logspace = [1e-2, 1e2], points = 601 }';
  const { files } = runByCommand("steel-on-steel.toml", "--set", axis, "--set", 'output.columns=["restitution"]');
  assert.equal(curve["restitution.csv"], files["table.csv"]);
});

test("e against drop height as CSV is the table of the command", () => {
  const text =
    read("steel-on-steel.toml").replace(/^speed = .*/m, 'drop_height = "0.5 m"') + "[gravity]\nacceleration = 9.81\n";
  const { curve } = run("drop.toml", text);
  const folder = mkdtempSync(join(tmpdir(), "plm-impact-"));
  const axis = 'sweep."impact.drop_height"={ logspace = [1e-3, 1e1], points = 601 }';
  const keys = ["--set", axis, "--set", 'output.columns=["restitution"]'];
  const { status, stderr } = callWith(text, "run", "-", "--pictures", "none", "--out", folder, ...keys);
  assert.equal(status, 0, stderr);
  assert.equal(curve["restitution.csv"], readFileSync(join(folder, "table.csv"), "utf8"));
  rmSync(folder, { recursive: true });
});

// the worker is played by this test
test("a run of more than a second gives way to the next, and a program that has an error is replaced", async (context) => {
  const workers = [];
  globalThis.Worker = class {
    sent = [];
    constructor() {
      workers.push(this);
    }
    postMessage(message) {
      this.sent.push(message);
    }
    terminate() {
      this.isOver = true;
    }
  };
  globalThis.fetch = async () => ({ arrayBuffer: async () => readFileSync(join(PAGE, "plm_impact_bg.wasm")) });
  let now = 0;
  context.mock.method(performance, "now", () => now);
  const { load, run } = await import(pathToFileURL(join(PAGE, "program.js")));
  const replies = [];
  await load((reply) => replies.push(reply));
  // within the second the next run waits, and of those that wait the last is done
  ["one", "two", "three"].forEach((name) => run(name));
  assert.deepEqual(
    workers[0].sent.slice(1).map(([name]) => name),
    ["one"],
  );
  workers[0].onmessage({ data: "{}" });
  assert.deepEqual(
    workers[0].sent.slice(1).map(([name]) => name),
    ["one", "three"],
  );
  assert.deepEqual(replies, []);
  // beyond it the worker is ended
  now = 1001;
  run("four");
  assert.ok(workers[0].isOver && workers.length === 2);
  assert.deepEqual(
    workers[1].sent.slice(1).map(([name]) => name),
    ["four"],
  );
  workers[1].onerror({ preventDefault() {}, message: "unreachable" });
  assert.match(replies[0].error, /^internal error: unreachable/);
  run("five");
  assert.deepEqual(
    workers[2].sent.slice(1).map(([name]) => name),
    ["five"],
  );
  assert.ok(workers[2].sent[0] instanceof WebAssembly.Module);
  workers[2].onmessage({ data: '{"text":"done"}' });
  assert.equal(replies[1].text, "done");
});

test("a worker that never starts is not replaced for ever", async () => {
  const workers = [];
  globalThis.Worker = class {
    constructor() {
      workers.push(this);
    }
    postMessage() {}
    terminate() {}
  };
  globalThis.fetch = async () => ({ arrayBuffer: async () => readFileSync(join(PAGE, "plm_impact_bg.wasm")) });
  // a module of its own, with no worker from the test before
  const { load, run } = await import(`${pathToFileURL(join(PAGE, "program.js"))}?failing`);
  const replies = [];
  await load((reply) => replies.push(reply));
  run("one");
  for (let count = 0; count < 3; count += 1) workers.at(-1).onerror({ preventDefault() {} });
  assert.equal(workers.length, 3);
  assert.match(replies.at(-1).error, /cannot be loaded.*\(3 times in a row\); load the page again/);
  // what a user asks for is one more attempt, and a reply begins to count anew
  run("two");
  assert.equal(workers.length, 4);
  workers[3].onmessage({ data: '{"text":"done"}' });
  assert.equal(replies.at(-1).text, "done");
  workers[3].onerror({ preventDefault() {}, message: "unreachable" });
  assert.equal(workers.length, 5);
});

test("only the number and its interval are in the line that stays in view", async () => {
  const source = readFileSync(join(PAGE, "numbers.js"), "utf8").replace(/^import .*$/gm, "");
  const { headline } = await import(`data:text/javascript;base64,${Buffer.from(source).toString("base64")}`);
  const headlineOf = (name) => {
    const { blocks, kind } = run(name, read(name));
    return headline(blocks, kind);
  };
  assert.match(headlineOf("ball-on-plate.toml"), /^restitution 0\.\d+( \([\d.]+ to [\d.]+\))?$/);
  assert.match(headlineOf("indentation-cycles.toml"), /^step \d+: dent depth [\d.]+ µm$/);
  const first = { list: [["impact speed", "3 m/s", ""]] };
  assert.equal(headline([first], "impact"), "impact speed 3 m/s");
  assert.equal(headline([{ sentence: "2 rows" }, { table: { rows: [["name"], ["force"]] } }], "sweep"), "2 rows");
});

test("command and page are looked for where cargo builds", () => {
  const script = `import("${new URL("command.mjs", import.meta.url)}").then(({ COMMAND }) => console.log(COMMAND))`;
  const env = { ...process.env, CARGO_TARGET_DIR: "/elsewhere" };
  const { stdout, stderr } = spawnSync(process.execPath, ["-e", script], { env, encoding: "utf8" });
  assert.equal(stdout.trim(), "/elsewhere/debug/plm-impact", stderr);
});
