// The page in a browser: what a user sees follows from what a user does, and the numbers are those of the command.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { browse, serve } from "./browser.mjs";
import { PAGE, SCENARIOS, call, callWith, read, runByCommand } from "./command.mjs";

let site, page;
before(async () => {
  site = await serve(PAGE);
  page = await browse();
});
after(async () => {
  await page?.end();
  site?.end();
});

const SHOWN = 'document.getElementById("numbers").innerText';
const field = (path) => `[id="field-${path}"]`;
const valueOf = (path) => page.value(`document.querySelector('${field(path)}').value`);
const text = () => page.value('document.getElementById("text").value');

/** Opens the page with a scenario in its address, or with the first one. */
async function open(scenario, data) {
  const link = scenario ? `#${new URLSearchParams({ scenario, ...(data && { data }) })}` : "";
  // the address alone would not load the page anew
  await page.go("about:blank");
  await page.go(site.address + link);
  await page.until('document.getElementById("state").textContent !== "Loading …"');
}

/** Waits until the numbers are those that the command prints. */
async function agrees(stdout) {
  const words = stdout.split(/\s+/).filter(Boolean).join(" ");
  await page.until(`${SHOWN}.split(/\\s+/).filter(Boolean).join(" ") === ${JSON.stringify(words)}`);
}

const picture = (name) => page.value(`document.querySelector("#picture-${name} svg").outerHTML`);

test("the first page shows the example of README.md", async () => {
  await open();
  await page.until(`${SHOWN}.includes("0.4925")`);
  await agrees(runByCommand("steel-on-steel.toml").stdout);
  assert.equal(await text(), call("init", "impact", "--out", "-").stdout);
  assert.equal(await valueOf("sphere.radius"), "5 mm");
  for (const name of ["force-indentation", "history", "restitution"]) assert.match(await picture(name), /<polyline/);
});

test("a changed speed changes number, pictures, text and address", async () => {
  await open();
  const names = ["force-indentation", "history", "restitution"];
  const old = await Promise.all(names.map(picture));
  await page.type(field("impact.speed"), "1 m/s");
  await agrees(runByCommand("steel-on-steel.toml", "--set", "impact.speed=1 m/s").stdout);
  for (const [at, name] of names.entries()) assert.notEqual(await picture(name), old[at]);
  const template = call("init", "impact", "--out", "-").stdout;
  assert.equal(await text(), template.replace('speed = "3 m/s"', 'speed = "1 m/s"'));
  await page.until('new URLSearchParams(location.hash.slice(1)).get("scenario") === document.getElementById("text").value');
});

test("a changed text changes the form and the numbers", async () => {
  await open();
  await page.click("details:has(> #text) > summary");
  await page.type("#text", read("law-thornton.toml"));
  await agrees(runByCommand("law-thornton.toml").stdout);
  assert.equal(await valueOf("law"), "thornton");
  assert.equal(await page.value(`document.querySelector('${field("law.thornton.yield_pressure")}').checkVisibility()`), true);
});

/** Chooses from a list. */
const choose = (css, value) =>
  page.value(`(() => {
    const list = document.querySelector(${JSON.stringify(css)});
    list.value = ${JSON.stringify(value)};
    for (const kind of ["input", "change"]) list.dispatchEvent(new Event(kind));
  })()`);

test("a law is chosen by name", async () => {
  await open();
  await choose(field("law"), "thornton");
  await agrees(runByCommand("steel-on-steel.toml", "--set", "law=thornton").stdout);
});

test("a material takes the place of numbers, and leaves its own when it is taken away", async () => {
  await open();
  await choose(field("half_space.material"), "aluminium-6061-t6");
  const sphere = read("steel-on-steel.toml").split("[half_space]")[0];
  const of = (halfSpace) => callWith(`${sphere}[half_space]\n${halfSpace}\n[impact]\nspeed = 3\n`, "run", "-", "--out", folder, "--force").stdout;
  const folder = mkdtempSync(join(tmpdir(), "plm-impact-"));
  await agrees(of('material = "aluminium-6061-t6"'));
  await choose(field("half_space.material"), "");
  assert.equal(await valueOf("half_space.youngs_modulus"), "68.9 GPa");
  assert.doesNotMatch(await text(), /material/);
  await agrees(of('material = "aluminium-6061-t6"'));
  rmSync(folder, { recursive: true });
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
  await agrees(runByCommand("steel-on-steel.toml").stdout);
});

test("a text that is no TOML says where, and leaves the form", async () => {
  await open();
  await page.click("details:has(> #text) > summary");
  await page.type("#text", "[sphere\nradius = 1");
  await page.until('document.getElementById("problem").innerText.startsWith("scenario.toml:1:")');
  assert.equal(await valueOf("sphere.radius"), "5 mm");
});

test("a key that stands in place of another one is chosen beside its field", async () => {
  await open();
  await choose('select.names:has(option[value="impact.drop_height"])', "impact.drop_height");
  await page.type(field("impact.speed"), "0.5 m");
  await page.until('document.getElementById("problem").innerText.includes("gravity")');
  await page.value(`document.querySelector('.group:has(${field("gravity.acceleration")})').open = true`);
  await page.type(field("gravity.acceleration"), "9.81 m/s^2");
  await page.until(`document.getElementById("problem").hidden && ${SHOWN}.includes("restitution")`);
  assert.doesNotMatch(await text(), /^speed/m);
  assert.match(await text(), /^drop_height = "0.5 m"/m);
});

test("the link restores a scenario, and the way back the one before", async () => {
  await open(read("hardening-steels.toml"));
  const before = await text();
  assert.equal(before, read("hardening-steels.toml"));
  await agrees(runByCommand("hardening-steels.toml").stdout);
  await choose("#begin", "repeat");
  await page.until(`document.getElementById("text").value.includes("[repeat]")`);
  await page.back();
  await page.until(`document.getElementById("text").value === ${JSON.stringify(before)}`);
});

test("measurements are calibrated with the digits of the command", async () => {
  await open(read("calibrate-ball-drop.toml"));
  await page.until('document.getElementById("problem").innerText.includes("drops.csv")');
  await page.send("#data", join(SCENARIOS, "drops.csv"));
  await agrees(runByCommand("calibrate-ball-drop.toml").stdout);
  await page.click("#without");
  await page.until('document.getElementById("state").textContent.startsWith("impact ")');
});

test("every control has a name for a screen reader, and every field explains itself", async () => {
  await open();
  const labels = await page.labels("input, select, textarea, button, [tabindex='0']");
  assert.ok(labels.length > 20, `${labels.length}`);
  assert.deepEqual(labels.filter((label) => !label), []);
  const described = 'document.getElementById(document.querySelector(\'[id="field-sphere.radius"]\').getAttribute("aria-describedby").split(" ")[0]).textContent';
  assert.equal(await page.value(described), "Radius of the sphere (not its diameter).");
});

test("the keyboard reaches the fields, and what has the focus is marked", async () => {
  await open();
  await page.send("#begin", "\uE004");
  const focused = [];
  for (let presses = 0; presses < 8; presses += 1) {
    focused.push(await page.value("document.activeElement.id || document.activeElement.textContent"));
    assert.notEqual(await page.value('getComputedStyle(document.activeElement).outlineStyle'), "none");
    await page.tell("Input.dispatchKeyEvent", { type: "keyDown", key: "Tab", code: "Tab", windowsVirtualKeyCode: 9 });
  }
  assert.ok(focused.includes("Form") && focused.includes("field-sphere.radius"), `${focused}`);
});

test("light and dark have contrast, and a narrow page is not wider than its window", async () => {
  // relative luminance and contrast of WCAG 2
  const contrast = `(() => {
    const light = (color) => {
      const [r, g, b] = color.match(/[\\d.]+/g).map((c) => c / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const paper = light(getComputedStyle(document.querySelector("section")).backgroundColor);
    const ink = (css) => light(getComputedStyle(document.querySelector(css)).color);
    const all = ["h2", "dt", "dd", ".about", ".error", "#problem", "button", "#state"].map(ink);
    return Math.min(...all.map((ink) => (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05)));
  })()`;
  for (const [width, isDark] of [[360, false], [1400, false], [360, true], [1400, true]]) {
    await page.look(width, 900, isDark);
    await open();
    await page.until(`${SHOWN}.includes("0.4925")`);
    assert.equal(await page.value('matchMedia("(prefers-color-scheme: dark)").matches'), isDark);
    assert.ok((await page.value(contrast)) > 4.5, `${width} ${isDark}`);
    assert.ok((await page.value("document.documentElement.scrollWidth")) <= width, `${width}`);
  }
});

test("no request leaves the page, and nothing is complained about", async () => {
  await page.log("browser");
  await page.log("performance");
  await open();
  await page.until(`${SHOWN}.includes("0.4925")`);
  const events = (await page.log("performance")).map((entry) => JSON.parse(entry.message).message);
  const sent = events.filter((event) => event.method === "Network.requestWillBeSent").map((event) => event.params.request.url);
  assert.ok(sent.some((url) => url.endsWith("plm_impact_bg.wasm")), `${sent}`);
  assert.deepEqual(sent.filter((url) => !url.startsWith(site.address) && !/^(data|blob|about):/.test(url)), []);
  assert.deepEqual((await page.log("browser")).map((entry) => entry.message), []);
});
