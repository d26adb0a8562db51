// The form of the page in a browser: what it shows is what is computed.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";

import { FIRST, call, callWith, read, runByCommand } from "./command.mjs";
import { LINKED, SHOWN, agrees, cells, choose, field, isSeen, open, page, text, valueOf } from "./open.mjs";

const unfold = () => page.value('document.querySelectorAll("#form details").forEach((one) => one.open = true)');
const BACKSPACE = "\uE003",
  DELETE = "\uE017",
  SELECT_ALL = "\uE009a\uE000";

/** What the command prints of a scenario. */
function runText(text) {
  const folder = mkdtempSync(join(tmpdir(), "plm-impact-"));
  const { stdout } = callWith(text, "run", "-", "--verbose", "--out", folder, "--force");
  rmSync(folder, { recursive: true });
  return stdout;
}

test("a law is chosen by name", async () => {
  await open();
  await choose(field("law"), "thornton");
  await agrees(runByCommand(...FIRST, "--set", "law=thornton").stdout);
});

test("a material takes the place of numbers, and leaves its own when it is taken away", async () => {
  await open();
  await choose(field("half_space.material"), "aluminium-6061-t6");
  const sphere = read("steel-on-steel.toml").split("[half_space]")[0];
  const of = (halfSpace) =>
    runText(
      `${sphere}[half_space]\n${halfSpace}\n[impact]\nspeed = 3\n[law.plm]\nunloading_exponent = "pressure-shape"\n`,
    );
  await agrees(of('material = "aluminium-6061-t6"'));
  await choose(field("half_space.material"), "");
  assert.equal(await valueOf("half_space.youngs_modulus"), "68.9 GPa");
  assert.doesNotMatch(await text(), /material/);
  // the same numbers; without its name the band of e no longer knows the range of its hardness
  await agrees(runText(await text()));
});

test("a wrong unit is refused at its field, in the words of the command", async () => {
  await open();
  await page.type(field("impact.speed"), "3 kg");
  const error = '[id="error-field-impact.speed"]';
  await page.until(`document.querySelector('${error}').checkVisibility()`);
  const { stderr } = call("check", "steel-on-steel.toml", "--set", "impact.speed=3 kg", "--error-format", "json");
  assert.equal(await page.value(`document.querySelector('${error}').textContent`), JSON.parse(stderr).message);
  assert.equal(await page.value(`document.querySelector('${field("impact.speed")}').ariaInvalid`), "true");
  await page.type(field("impact.speed"), "3 m/s");
  await page.until(`!document.querySelector('${error}').checkVisibility()`);
  await agrees(runByCommand(...FIRST).stdout);
});

test("a key that stands in place of another one is chosen beside its field", async () => {
  await open();
  await choose('select.names:has(option[value="impact.drop_height"])', "impact.drop_height");
  await page.type(field("impact.speed"), "0.5 m");
  const speed = /^speed = .*/m;
  await agrees(runText(call("init", "impact", "--out", "-").stdout.replace(speed, 'drop_height = "0.5 m"')));
  assert.doesNotMatch(await text(), /^speed/m);
  assert.match(await text(), /^drop_height = "0.5 m"/m);
});

test("a field that is typed in and emptied before it is left takes its key away", async () => {
  await open();
  await unfold();
  const before = await text();
  const empty = await page.value(
    `[...document.querySelectorAll("#form input")].filter((one) => one.checkVisibility() && !one.value).map((one) => one.id)`,
  );
  assert.ok(empty.length > 15, `${empty}`);
  // the two ways to empty a field, in turns
  const ways = [
    ["0.1", SELECT_ALL + DELETE],
    ["75", BACKSPACE + BACKSPACE],
  ];
  for (const [at, id] of empty.entries()) {
    const css = `[id="${id}"]`;
    const [typed, emptied] = ways[at % ways.length];
    await page.send(css, typed);
    assert.match(await text(), new RegExp(`= ${typed}\n`), id);
    await page.send(css, emptied);
    assert.equal(await text(), before, id);
    await page.send(css, "\uE004");
    assert.equal(await text(), before, id);
    assert.equal(await page.value(`document.querySelector('${css}').value`), "", id);
  }
  await agrees(runByCommand(...FIRST).stdout);
});

test("a field that is emptied and typed in again leaves its key and the comments where they were", async () => {
  const commented = read("steel-on-steel.toml").replace('radius = "5 mm"', 'radius = "5 mm"  # a bearing ball');
  await open(commented);
  await page.send(field("sphere.radius"), SELECT_ALL + DELETE);
  await page.until('document.getElementById("problem").innerText.includes("radius")');
  await page.send(field("sphere.radius"), "2 mm");
  assert.equal(await text(), commented.replace('"5 mm"', '"2 mm"'));
});

test("what the form shows is what is computed, also when a field has the focus on the way back", async () => {
  await open();
  await choose("#begin", "impact");
  await page.type(field("impact.speed"), "1 m/s");
  await page.until(`${LINKED}.includes('speed = "1 m/s"')`);
  await page.back();
  await page.until('document.getElementById("text").value.includes(\'speed = "3 m/s"\')');
  assert.equal(await valueOf("impact.speed"), "3 m/s");
});

test("the first click below a field that has the focus is not lost", async () => {
  await page.look(1400, 1600, false);
  await open();
  const summaries = ["friction", "gravity", "damping"].map((table) => `.group:has([id="error-${table}"]) > summary`);
  for (const name of ["impact.speed", "sphere.radius", "half_space.yield_strength"]) {
    for (const below of summaries) {
      await page.click(field(name));
      assert.equal(await isSeen(`[id="about-field-${name}"]`), true);
      await page.click(below);
      assert.equal(
        await page.value(`document.querySelector('${below}').parentElement.open`),
        true,
        `${name}, ${below}`,
      );
      await page.click(below);
    }
    await page.type(field(name), "4 m");
    await page.value('document.getElementById("told").textContent = "not clicked"');
    await page.click("#link");
    await page.until('document.getElementById("told").textContent !== "not clicked"');
  }
});

test("a message that asks for another key has a button that adds it", async () => {
  const cases = [
    ["impact.angle", "45 deg", "friction.coefficient", "0.1"],
    ["half_space.thickness", "20 mm", "half_space.density", "7850 kg/m^3"],
  ];
  for (const [path, value, needed, added] of cases) {
    await open();
    await unfold();
    await page.type(field(path), value);
    const button = `[id="error-field-${path}"] button`;
    await page.until(`document.querySelector('${button}')`);
    await page.click(button);
    await page.until('document.getElementById("problem").hidden');
    assert.equal(await valueOf(needed), added);
    assert.equal(await page.value("document.activeElement.id"), `field-${needed}`);
    await agrees(runByCommand(...FIRST, "--set", `${path}=${value}`, "--set", `${needed}=${added}`).stdout);
  }
  // a body without what it needs says so at its group
  await open(read("steel-on-steel.toml").replace(/speed = .*/, ""));
  await page.until(`document.querySelector('[id="error-impact"] button')`);
  await page.click('[id="error-impact"] button');
  await agrees(runByCommand("steel-on-steel.toml").stdout);
});

test("keys that few need are folded, and unfolded where they are given or refused", async () => {
  await open();
  assert.deepEqual(
    [await isSeen(field("half_space.yield_strength")), await isSeen(field("half_space.thickness"))],
    [true, false],
  );
  await open(read("ball-on-plate.toml"));
  assert.equal(await isSeen(field("half_space.thickness")), true);
});

test("a number without a unit shows the unit that it is taken in", async () => {
  await open();
  const unit = (path) => page.value(`document.getElementById("unit-field-${path}").textContent`);
  assert.equal(await unit("half_space.yield_strength"), "");
  await page.type(field("half_space.yield_strength"), "345");
  assert.equal(await unit("half_space.yield_strength"), "Pa");
  await page.type(field("half_space.yield_strength"), "3.45e8");
  assert.equal(await unit("half_space.yield_strength"), "Pa");
  await page.type(field("half_space.yield_strength"), "345 MPa");
  assert.equal(await unit("half_space.yield_strength"), "");
  assert.equal(await unit("sphere.poissons_ratio"), "");
});

test("a choice counts with one event alone", async () => {
  for (const kind of ["input", "change"]) {
    await open();
    await page.value(`(() => {
      const list = document.querySelector('${field("law")}');
      list.value = "thornton";
      list.dispatchEvent(new Event("${kind}"));
    })()`);
    assert.match(await text(), /^\[law\.thornton\]/m, kind);
  }
});

test("keys without a field are named, and the numbers of a table are shown", async () => {
  await open(call("init", "sweep", "--out", "-").stdout);
  await page.until(`${SHOWN}.includes("183 rows")`);
  assert.match(await page.value('document.getElementById("elsewhere").innerText'), /sweep\.impact\.speed\.logspace/);
  await page.click("#elsewhere button");
  assert.equal(await page.value("document.activeElement.id"), "text");
  const shown = await cells("#numbers tbody tr");
  assert.equal(shown.length, 10);
  assert.match(shown[0], /^0 0\.001 200000000 1 0\.0001376 /);
});

test("a material shows the hardness that it brings", async () => {
  await open();
  await choose(field("half_space.material"), "aluminium-6061-t6");
  const { stdout } = call("materials", "aluminium-6061-t6");
  const shown = await page.value(`document.querySelector('${field("half_space.yield_strength")}').placeholder`);
  assert.match(shown, /HV$/);
  assert.ok(stdout.includes(shown), shown);
  await page.until(
    `document.querySelector('.row:has(${field("half_space.yield_strength")}) .names').value === "half_space.hardness"`,
  );
});
