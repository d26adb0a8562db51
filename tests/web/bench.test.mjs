// The moving parts of the page: sliders, values under pointer, finger and keys, kept curves, the animation. The numbers are those of the command.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";

import { FIRST, call, callWith, runByCommand } from "./command.mjs";
import { agrees, cells, choose, field, isSeen, open, page, site, text, valueOf } from "./open.mjs";

const ready = () => page.until(`document.getElementById("results").ariaBusy === "false"`);
const aboutOf = (id) => page.value(`document.getElementById(${JSON.stringify(id)}).getAttribute("aria-label")`);
const readOf = (id) => page.value(`document.getElementById(${JSON.stringify(`${id}-read`)}).textContent`);
const summaryOf = (...words) => JSON.parse(runByCommand(...FIRST, ...words).files["summary.json"]);
const four = (number) => String(Number(number.toPrecision(4)));

/** Where a value of the logarithmic axis of e is in the window. */
async function placeOf(speed) {
  await page.value('document.getElementById("chart-restitution").scrollIntoView({ block: "center" })');
  return page.value(`(() => {
    const area = document.querySelector("#chart-restitution .area").getBoundingClientRect();
    return [area.left + area.width * (Math.log10(${speed}) + 2) / 4, area.top + area.height / 2];
  })()`);
}

const mouse = (type, [x, y]) =>
  page.tell("Input.dispatchMouseEvent", {
    type,
    x,
    y,
    button: "left",
    buttons: type === "mouseReleased" ? 0 : 1,
    clickCount: 1,
  });
const touch = (type, places) =>
  page.tell("Input.dispatchTouchEvent", { type, touchPoints: places.map(([x, y]) => ({ x, y })) });
const press = async (key, code) => {
  for (const type of ["keyDown", "keyUp"])
    await page.tell("Input.dispatchKeyEvent", { type, key, code: key, windowsVirtualKeyCode: code });
};
const focus = (id) => page.value(`document.getElementById(${JSON.stringify(id)}).focus()`);

/** Moves a slider to a value by its events, as a hand does. */
const slide = (id, value, kind) =>
  page.value(`(() => {
    const input = document.getElementById(${JSON.stringify(id)});
    input.value = ${Math.log10(value)};
    input.dispatchEvent(new Event(${JSON.stringify(kind)}));
  })()`);

test("only what the first result needs is loaded before this result", async () => {
  const source = `new MutationObserver((_, observer) => {
    if (!document.getElementById("numbers")?.textContent.includes("restitution")) return;
    window.shownAt = performance.now();
    observer.disconnect();
  }).observe(document, { childList: true, subtree: true });`;
  await page.tell("Page.enable", {});
  const { identifier } = await page.tell("Page.addScriptToEvaluateOnNewDocument", { source });
  await open();
  await page.tell("Page.removeScriptToEvaluateOnNewDocument", { identifier });
  const [shownAt, loaded, preloaded] = await page.value(`[
    window.shownAt,
    performance.getEntriesByType("resource").map(({ name, startTime }) => [name.split("/").at(-1), startTime]),
    [...document.querySelectorAll("link[rel$=preload]")].map((one) => one.getAttribute("href")),
  ]`);
  const early = new Set(loaded.filter(([, at]) => at < shownAt).map(([name]) => name));
  const needed = new Set([...preloaded, "page.css", "page.js", "worker.js", "plm_impact_bg.wasm"]);
  assert.deepEqual(
    [...early].filter((name) => !needed.has(name)),
    [],
  );
  for (const name of preloaded) assert.ok(early.has(name), name);
  for (const name of ["later.js", "bench.js", "chart.js"])
    assert.ok(loaded.some(([one]) => one === name) && !early.has(name));
});

test("a slider of speed computes what the command computes", async () => {
  await page.look(1400, 900, false);
  await open();
  await slide("slide-speed", 1, "input");
  await agrees(runByCommand(...FIRST, "--set", "impact.speed=1 m/s").stdout);
  assert.equal(await valueOf("impact.speed"), "1 m/s");
  assert.match(await text(), /^speed = "1 m\/s"/m);
  assert.ok(
    (await aboutOf("chart-restitution")).includes(
      `This impact: ${four(summaryOf("--set", "impact.speed=1").restitution)} at 1 m/s`,
    ),
  );
});

test("curves follow a slider before it rests, and pictures after", async () => {
  await open();
  const loop = () => page.value('document.querySelector("#chart-loop .curve").getAttribute("points")');
  const still = () => page.value('document.querySelector("#picture-force-indentation svg").outerHTML');
  const [before, picture] = [await aboutOf("chart-loop"), await still()];
  // the slider moves on and on, so that it never rests
  await page.value(`(() => {
    const input = document.getElementById("slide-size");
    window.moving = setInterval(() => {
      input.value = Number(input.value) + 0.005;
      input.dispatchEvent(new Event("input"));
    }, 100);
  })()`);
  await page.until(`document.getElementById("chart-loop").getAttribute("aria-label") !== ${JSON.stringify(before)}`);
  assert.equal(await still(), picture);
  await page.value("clearInterval(window.moving)");
  const moved = await loop();
  assert.ok(moved);
  await ready();
  assert.notEqual(await still(), picture);
});

test("keys move speed, size and strength on sliders and in fields", async () => {
  await open();
  for (const [id, path] of [
    ["slide-speed", "impact.speed"],
    ["slide-size", "sphere.radius"],
    ["slide-strength", "half_space.yield_strength"],
  ]) {
    const before = await valueOf(path);
    await focus(id);
    await press("ArrowUp", 38);
    await page.until(`document.querySelector('${field(path)}').value !== ${JSON.stringify(before)}`);
    const [was, is] = [parseFloat(before), parseFloat(await valueOf(path))];
    assert.ok(is > was && is < 1.03 * was, `${path} ${was} ${is}`);
  }
  await open();
  await focus("field-impact.speed");
  await press("ArrowUp", 38);
  assert.equal(await valueOf("impact.speed"), "3.1 m/s");
  await press("ArrowDown", 40);
  await press("ArrowDown", 40);
  assert.equal(await valueOf("impact.speed"), "2.9 m/s");
  await agrees(runByCommand(...FIRST, "--set", "impact.speed=2.9 m/s").stdout);
});

test("the value under the pointer is that of the table of the command", async () => {
  await open();
  await mouse("mouseMoved", await placeOf(1));
  await page.until('document.getElementById("chart-restitution-read").textContent.includes("at impact speed 1 m/s")');
  assert.equal(
    await readOf("chart-restitution"),
    `Restitution ${four(summaryOf("--set", "impact.speed=1").restitution)} at impact speed 1 m/s`,
  );
  // the whole curve, in the link's words: every point is a row of the CSV file
  const points = await page.value(
    'document.querySelector("#chart-restitution .curve").getAttribute("points").split(" ").length',
  );
  assert.equal(points, 601);
});

test("a click on e sets the speed, and a drag moves it", async () => {
  await open();
  const at = await placeOf(0.1);
  await mouse("mousePressed", at);
  await mouse("mouseReleased", at);
  await page.until(`/^0\\.(09\\d*|1|10\\d*) m\\/s$/.test(document.querySelector('${field("impact.speed")}').value)`);
  await ready();
  await mouse("mousePressed", await placeOf(0.1));
  await mouse("mouseMoved", await placeOf(1));
  await mouse("mouseMoved", await placeOf(5));
  await mouse("mouseReleased", await placeOf(5));
  await page.until(`Math.abs(parseFloat(document.querySelector('${field("impact.speed")}').value) - 5) < 0.2`);
  await ready();
  await agrees(runByCommand(...FIRST, "--set", `impact.speed=${await valueOf("impact.speed")}`).stdout);
});

test("a finger reads e and sets the speed", async () => {
  await page.look(360, 740, false);
  await open();
  await touch("touchStart", [await placeOf(0.3)]);
  await touch("touchMove", [await placeOf(1)]);
  assert.match(await readOf("chart-restitution"), /^Restitution 0\.\d+ at impact speed/);
  await touch("touchEnd", []);
  await page.until(`Math.abs(parseFloat(document.querySelector('${field("impact.speed")}').value) - 1) < 0.1`);
  await page.look(1400, 900, false);
});

test("keys read both curves and set the speed", async () => {
  await open();
  await focus("chart-restitution");
  await press("ArrowRight", 39);
  const said = await readOf("chart-restitution");
  assert.match(said, /^Restitution 0\.\d+ at impact speed 1\.\d+ m\/s$/);
  await press("Enter", 13);
  const speed = Number(said.match(/([\d.]+) m\/s/)[1]);
  await page.until(
    `Math.abs(parseFloat(document.querySelector('${field("impact.speed")}').value) / ${speed} - 1) < 0.006`,
  );
  await focus("chart-loop");
  await press("PageUp", 33);
  assert.match(await readOf("chart-loop"), /^Force [\d.]+ k?N at indentation [\d.]+ µm$/);
});

test("a kept curve stands beside another strength, in the key, table and link", async () => {
  await open();
  await page.click("#keep");
  await page.type(field("half_space.yield_strength"), "700 MPa");
  await ready();
  assert.deepEqual(await cells("#key li"), [
    "This scenario: half-space yield strength 700 MPa",
    "half-space yield strength 345 MPa Remove",
  ]);
  for (const chart of ["chart-restitution", "chart-loop"])
    assert.equal(await page.value(`document.querySelectorAll("#${chart} .curve").length`), 2, chart);
  await page.click("#keep");
  const rows = await cells("#kept td");
  const strengths = ["345 MPa", "700 MPa"];
  const expected = strengths.map((strength) =>
    four(summaryOf("--set", `half_space.yield_strength=${strength}`).restitution),
  );
  assert.deepEqual([rows[1], rows[8]], strengths);
  assert.deepEqual([rows[2], rows[9]], expected);
  // the link restores the kept ones
  await page.until('new URLSearchParams(location.hash.slice(1)).getAll("kept").length === 2');
  const link = await page.value("location.href");
  await page.go("about:blank");
  await page.go(link);
  await page.until('document.querySelectorAll("#chart-loop .curve").length === 3');
  assert.deepEqual((await cells("#kept td")).slice(0, 3), rows.slice(0, 3));
  await page.click("#key button");
  await page.until('document.querySelectorAll("#chart-loop .curve").length === 2');
});

test("a kept value with commas and quotes stays one cell", async () => {
  const first = call("init", "impact", "--out", "-").stdout;
  const scenario = (stress) =>
    `${first}\n[half_space.flow_stress]\npoints = [[0.002, "345 MPa"], [0.1, "${stress}"]]\n`;
  await open(scenario("500 MPa"));
  await ready();
  await page.click("#keep");
  await page.value(`(() => {
    const text = document.getElementById("text");
    text.value = ${JSON.stringify(scenario("600 MPa"))};
    text.dispatchEvent(new Event("input"));
  })()`);
  await ready();
  await page.value('document.getElementById("keep").click()');
  const [head, rows] = [await cells("#kept th"), await cells("#kept tbody tr:last-child td")];
  assert.deepEqual(head.slice(0, 3), ["curve", "half_space.flow_stress.points", "restitution"]);
  assert.equal(rows.length, head.length);
  assert.equal(rows[1], '[[0.002, "345 MPa"], [0.1, "600 MPa"]]');
  assert.match(rows[2], /^0\.\d+$/);
});

test("a kept curve of another law is named by the law", async () => {
  await open();
  await page.click("#keep");
  await choose(field("law"), "thornton");
  await ready();
  assert.match((await cells("#key li"))[0], /law thornton/);
});

test("the animation steps, plays and shows where the loop is", async () => {
  await open();
  const moment = () => page.value('document.querySelector(".moment").textContent');
  const { peak_indentation_m: peak } = summaryOf();
  assert.ok((await moment()).includes(`indentation ${four(peak * 1e6)} µm`), await moment());
  const at = () => page.value('Number(document.getElementById("moment").value)');
  const before = await at();
  await page.click("#step-forth");
  assert.equal(await at(), before + 1);
  await focus("moment");
  await press("ArrowLeft", 37);
  assert.equal(await at(), before);
  assert.equal(await page.value('document.querySelectorAll("#chart-loop .mark").length'), 1);
  // from the start, so that the motion is stopped before its end
  await press("Home", 36);
  await page.click("#play");
  await page.until('Number(document.getElementById("moment").value) > 5');
  await page.value('document.getElementById("play").click()');
  const paused = await at();
  await new Promise((later) => setTimeout(later, 300));
  assert.equal(await at(), paused);
});

test("with less motion the animation goes in few steps", async () => {
  await page.tell("Emulation.setEmulatedMedia", { features: [{ name: "prefers-reduced-motion", value: "reduce" }] });
  await open();
  await page.value(`(() => {
    window.seen = new Set();
    document.getElementById("moment").value = 0;
    new MutationObserver(() => window.seen.add(document.getElementById("moment").value)).observe(document.querySelector(".moment"), { childList: true, characterData: true, subtree: true });
  })()`);
  await page.click("#play");
  await page.until('document.getElementById("play").textContent === "Play" && window.seen.size > 1');
  assert.ok((await page.value("window.seen.size")) <= 10);
  await page.look(1400, 900, false);
});

test("every experiment runs, with what the command prints", async () => {
  await open();
  const names = await page.value(
    `[...document.querySelectorAll("#begin optgroup:first-of-type option")].map((one) => one.value)`,
  );
  assert.ok(names.length >= 5);
  for (const name of names) {
    const file = readFileSync(
      new URL(`../../src/interfaces/web/page/experiments/${name}.toml`, import.meta.url),
      "utf8",
    );
    await choose("#begin", name);
    await page.until(`document.getElementById("text").value === ${JSON.stringify(file)}`);
    const folder = mkdtempSync(join(tmpdir(), "plm-impact-"));
    const { status, stdout, stderr } = callWith(file, "run", "-", "--verbose", "--pictures", "none", "--out", folder);
    rmSync(folder, { recursive: true });
    assert.equal(status, 0, stderr);
    await agrees(stdout);
  }
});

test("fields of a table make the axes that are typed", async () => {
  await open();
  await page.click("#sweep > summary");
  await page.type("#sweep-low", "1 m/s");
  await page.type("#sweep-high", "4 m/s");
  await page.type("#sweep-points", "3");
  await choose("#sweep-second", "half_space.yield_strength");
  await page.type("#sweep-list", "200 MPa, 345 MPa");
  await page.click("#sweep-make");
  await page.until('document.getElementById("state").textContent.startsWith("sweep")');
  assert.ok((await text()).includes('"impact.speed" = { logspace = ["1 m/s", "4 m/s"], points = 3 }'));
  const rows = await cells("#numbers table:has(caption) tbody tr");
  assert.equal(rows.length, 6);
  assert.equal(await isSeen("#bench"), false);
  await page.click("#sweep-remove");
  await page.until('document.getElementById("state").textContent.startsWith("impact")');
});

test("the bench fits its window, with letters that can be read", async () => {
  for (const width of [360, 800, 1400]) {
    await page.look(width, 800, false);
    await open();
    await ready();
    assert.ok((await page.value("document.documentElement.scrollWidth")) <= width, `${width}`);
    const [smallest, gaps] = await page.value(`(() => {
      const texts = [...document.querySelectorAll(".chart text")];
      const scale = document.querySelector(".chart").getScreenCTM().a;
      const ticks = [...document.querySelectorAll("#chart-restitution .tick-x")].map((one) => one.getBoundingClientRect());
      const size = parseFloat(document.querySelector(".chart").getAttribute("font-size")) * scale;
      return [texts.length && size, ticks.slice(1).map((one, at) => one.left - ticks[at].right)];
    })()`);
    assert.ok(smallest > 11, `${width}: ${smallest}`);
    assert.ok(gaps.length >= 2 && Math.min(...gaps) > 4, `${width}: ${gaps}`);
  }
  assert.deepEqual(await cells("#chart-restitution .tick-x"), ["0.01", "0.1", "1", "10", "100"]);
});

test("on paper the results stand alone, in black on white", async () => {
  await page.look(1400, 900, true);
  await open();
  await page.tell("Emulation.setEmulatedMedia", {
    media: "print",
    features: [{ name: "prefers-color-scheme", value: "dark" }],
  });
  for (const css of ["#form", "header", "#keep", "#slide-speed", "#files"]) assert.equal(await isSeen(css), false, css);
  for (const css of ["#numbers dl", "#chart-restitution", "#picture-history"])
    assert.equal(await isSeen(css), true, css);
  const colors = await page.value(
    `[document.body, document.querySelector("section#results")].map((one) => [getComputedStyle(one).color, getComputedStyle(one).backgroundColor]).flat()`,
  );
  assert.deepEqual(colors, ["rgb(0, 0, 0)", "rgb(255, 255, 255)", "rgb(0, 0, 0)", "rgb(255, 255, 255)"]);
  await page.tell("Emulation.setEmulatedMedia", { media: "", features: [] });
  await page.look(1400, 900, false);
});

test("full screen has large letters", async () => {
  await open();
  const size = () => page.value('parseFloat(getComputedStyle(document.querySelector("#results")).fontSize)');
  const before = await size();
  await page.click("#full");
  await page.until("document.fullscreenElement !== null");
  assert.ok((await size()) >= 1.5 * before);
  await page.value("document.exitFullscreen()");
  await page.until("document.fullscreenElement === null");
});

test("pictures say in words what they show", async () => {
  await open();
  const { peak_force_N: force, restitution } = summaryOf();
  assert.ok((await aboutOf("chart-loop")).includes(`${four(force / 1e3)} kN`));
  const label = await page.value('document.querySelector("#picture-force-indentation svg").getAttribute("aria-label")');
  assert.ok(label.includes(`restitution e = ${four(restitution)}`) && label.includes("Force"), label);
});

test("after the first load the page works without a network", async () => {
  await open();
  await page.until(`navigator.serviceWorker.controller !== null`);
  await page.until(
    `(window.cachedFiles ??= 0, caches.open("plm-impact").then((cache) => cache.keys()).then((keys) => (window.cachedFiles = keys.length)), window.cachedFiles > 15)`,
  );
  await site.stop();
  try {
    await page.go("about:blank");
    await page.go(site.address);
    await agrees(runByCommand(...FIRST).stdout);
    await ready();
    await choose("#begin", "leeb-hardness");
    await page.until('document.getElementById("text").value.includes("Leeb")');
    await ready();
    assert.equal(await isSeen("#bench"), true);
  } finally {
    await site.start();
  }
});
