// The page in a browser: what a user sees follows from what a user does, and the numbers are those of the command.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";

import { FIRST, ROOT, SCENARIOS, call, read, runByCommand } from "./command.mjs";
import { LINKED, SHOWN, agrees, cells, choose, field, isSeen, open, page, site, text, valueOf } from "./open.mjs";

const picture = (name) => page.value(`document.querySelector("#picture-${name} svg").outerHTML`);

test("the first page shows the first scenario of `init`", async () => {
  await open();
  await page.until(`${SHOWN}.includes("0.5064")`);
  await agrees(runByCommand(...FIRST).stdout);
  assert.equal(await text(), call("init", "impact", "--out", "-").stdout);
  assert.equal(await valueOf("sphere.radius"), "5 mm");
  for (const name of ["force-indentation", "history", "restitution"]) assert.match(await picture(name), /<polyline/);
});

// tests/program/report/external_pictures.rs compares the noted numbers with those of the program
test(
  "UPDATE=1 draws src/interfaces/web/page.png and notes its numbers",
  { skip: process.env.UPDATE !== "1" },
  async () => {
    await page.look(1300, 880, false);
    await open();
    await agrees(runByCommand(...FIRST).stdout);
    writeFileSync(join(ROOT, "src/interfaces/web/page.png"), await page.picture());
    const summary = JSON.parse(runByCommand(...FIRST).files["summary.json"]);
    const names = ["restitution", "contact_time_s", "peak_force_N", "residual_indentation_m"];
    const lines = ["result,value", ...names.map((name) => `${name},${summary[name]}`), ""];
    writeFileSync(join(ROOT, "tests/reference/page_picture.csv"), lines.join("\n"));
    await page.look(1400, 900, false);
  },
);

test("a changed speed changes number, pictures, text and address", async () => {
  await open();
  const names = ["force-indentation", "history", "restitution"];
  const old = await Promise.all(names.map(picture));
  await page.type(field("impact.speed"), "1 m/s");
  await agrees(runByCommand(...FIRST, "--set", "impact.speed=1 m/s").stdout);
  for (const [at, name] of names.entries()) assert.notEqual(await picture(name), old[at]);
  const template = call("init", "impact", "--out", "-").stdout;
  assert.equal(await text(), template.replace('speed = "3 m/s"', 'speed = "1 m/s"'));
  await page.until(`(${LINKED} ?? "").includes('speed = "1 m/s"')`);
  const keys = (text) => text.split("\n").filter((line) => line && !line.startsWith("#"));
  assert.deepEqual(keys(await page.value(LINKED)), keys(await text()));
});

test("a changed text changes the form and the numbers", async () => {
  await open();
  await page.click("details:has(> #text) > summary");
  await page.type("#text", read("law-thornton.toml"));
  await agrees(runByCommand("law-thornton.toml").stdout);
  assert.equal(await valueOf("law"), "thornton");
  assert.equal(
    await page.value(`document.querySelector('${field("law.thornton.yield_pressure")}').checkVisibility()`),
    true,
  );
});

test("a text that is no TOML says where, and leaves the form", async () => {
  await open();
  await page.click("details:has(> #text) > summary");
  await page.type("#text", "[sphere\nradius = 1");
  await page.until('document.getElementById("problem").innerText.startsWith("scenario.toml:1:")');
  assert.equal(await valueOf("sphere.radius"), "5 mm");
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
  assert.deepEqual(
    labels.filter((label) => !label),
    [],
  );
  const described =
    'document.getElementById(document.querySelector(\'[id="field-sphere.radius"]\').getAttribute("aria-describedby").split(" ")[0]).textContent';
  assert.equal(await page.value(described), "Radius of the sphere (not its diameter).");
});

test("the keyboard reaches the fields, and what has the focus is marked", async () => {
  await open();
  await page.send("#begin", "\uE004");
  const focused = [];
  for (let presses = 0; presses < 8; presses += 1) {
    focused.push(await page.value("document.activeElement.id || document.activeElement.textContent"));
    assert.notEqual(await page.value("getComputedStyle(document.activeElement).outlineStyle"), "none");
    await page.tell("Input.dispatchKeyEvent", { type: "keyDown", key: "Tab", code: "Tab", windowsVirtualKeyCode: 9 });
  }
  assert.ok(focused.includes("Form") && focused.includes("field-sphere.radius"), `${focused}`);
});

test("on a phone keys reach the results before the form, as they are seen", async () => {
  for (const [width, names] of [
    [1400, ["scenario", "results"]],
    [360, ["results", "scenario"]],
  ]) {
    await page.look(width, 800, false);
    await open();
    await page.until(`[...document.querySelectorAll("main > section")].map((one) => one.id).join() === "${names}"`);
    const boxes = await page.value(
      `${JSON.stringify(names)}.map((id) => document.getElementById(id).getBoundingClientRect()).map(({ left, top }) => left + top)`,
    );
    assert.ok(boxes[0] < boxes[1], `${width}: ${boxes}`);
  }
  // a window that becomes wide
  await page.look(1400, 900, false);
  await page.until('document.querySelector("main > section").id === "scenario"');
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
  for (const [width, isDark] of [
    [360, false],
    [1400, false],
    [360, true],
    [1400, true],
  ]) {
    await page.look(width, 900, isDark);
    await open();
    await page.until(`${SHOWN}.includes("0.5064")`);
    assert.equal(await page.value('matchMedia("(prefers-color-scheme: dark)").matches'), isDark);
    assert.ok((await page.value(contrast)) > 4.5, `${width} ${isDark}`);
    assert.ok((await page.value("document.documentElement.scrollWidth")) <= width, `${width}`);
  }
  // the longest names of results
  await page.look(360, 900, false);
  await open(read("ball-on-plate.toml"));
  await page.until(`${SHOWN}.includes("restitution without waves")`);
  assert.ok((await page.value("document.documentElement.scrollWidth")) <= 360);
});

test("no request leaves the page, and nothing is complained about", async () => {
  await page.log("browser");
  await page.log("performance");
  await open();
  await page.until(`${SHOWN}.includes("0.5064")`);
  const events = (await page.log("performance")).map((entry) => JSON.parse(entry.message).message);
  const sent = events
    .filter((event) => event.method === "Network.requestWillBeSent")
    .map((event) => event.params.request.url);
  assert.ok(
    sent.some((url) => url.endsWith("plm_impact_bg.wasm")),
    `${sent}`,
  );
  assert.deepEqual(
    sent.filter((url) => !url.startsWith(site.address) && !/^(data|blob|about):/.test(url)),
    [],
  );
  assert.deepEqual(
    (await page.log("browser")).map((entry) => entry.message),
    [],
  );
});

test("measurements of drops find a strength on the first page, as it stands", async () => {
  await open();
  await page.send("#data", join(SCENARIOS, "drops.csv"));
  await page.until('document.getElementById("state").textContent.startsWith("calibrate half_space.yield_strength")');
});

test("steps and impacts are tables", async () => {
  const names = ["indentation-cycles.toml", "bouncing-fresh-spot.toml", "indentation-ti-nb.toml"];
  for (const name of names) {
    await open(read(name));
    const { stdout } = runByCommand(name);
    await agrees(stdout);
    // two blanks and more separate the cells of a line
    const lines = stdout.split("\n").map((line) => line.trim().split(/ {2,}/));
    const head = lines.find((line) => ["step", "impact"].includes(line[0]));
    const heads = lines.filter((line) => line[0] === head[0] && line.length === head.length).length;
    assert.equal((await cells("#numbers table")).length, heads, name);
    assert.deepEqual((await cells("#numbers th")).slice(0, head.length), head);
    const rows = lines.filter((line) => line.length === head.length && line[0] !== head[0]);
    // dots stand for rows that are left out
    assert.deepEqual(
      (await cells("#numbers td")).filter((cell) => cell !== "..."),
      rows.flat(),
      name,
    );
  }
});

test("the laws that a calibration compares are a table", async () => {
  const [name, laws] = ["calibrate-ball-drop.toml", 'laws = ["plm", "hertz", "thornton"]'];
  await open(`${read(name)}${laws}\n`, read("drops.csv"));
  await agrees(runByCommand(name, "--set", `calibrate.${laws}`).stdout);
  assert.deepEqual(await cells("#numbers th"), ["law", "AIC", "above the best", "half_space.yield_strength"]);
  assert.equal((await cells("#numbers tbody tr")).length, 3);
});

test("a link is copied, or shown where a page may not copy, until the scenario changes", async () => {
  const told = () => page.value('document.getElementById("told").textContent');
  await open(undefined, undefined, site.address.replace("127.0.0.1", "plain.test"));
  assert.equal(await page.value("navigator.clipboard === undefined"), true);
  await page.click("#link");
  await page.until('document.getElementById("told").textContent');
  assert.match(await told(), /Clipboard access was denied/);
  assert.equal(await page.value('document.getElementById("address").value === location.href'), true);
  await page.type(field("impact.speed"), "1 m/s");
  assert.deepEqual([await told(), await isSeen("#address")], ["", false]);
  await open();
  await page.tell("Browser.grantPermissions", {
    permissions: ["clipboardReadWrite", "clipboardSanitizedWrite"],
    origin: site.address.slice(0, -1),
  });
  await page.click("#link");
  await page.until('document.getElementById("told").textContent === "copied"');
  await page.type(field("impact.speed"), "1 m/s");
  assert.equal(await told(), "");
});

test("measurements that are too long for a link are said to be missing, and a reload keeps them", async () => {
  const folder = mkdtempSync(join(tmpdir(), "plm-impact-"));
  const long = join(folder, "drops.csv");
  writeFileSync(
    long,
    `${"# a comment of fifty letters, a thousand times over\n".repeat(1000)}${readFileSync(join(SCENARIOS, "drops.csv"))}`,
  );
  await open(read("calibrate-ball-drop.toml"));
  await page.send("#data", long);
  const { stdout } = runByCommand("calibrate-ball-drop.toml");
  await agrees(stdout);
  const told = () => page.value('document.getElementById("told").textContent');
  await page.tell("Browser.grantPermissions", {
    permissions: ["clipboardReadWrite", "clipboardSanitizedWrite"],
    origin: site.address.slice(0, -1),
  });
  await page.click("#link");
  await page.until('document.getElementById("told").textContent');
  assert.equal(await told(), "copied without the measurements, which are too long for a link: send their file too");
  assert.equal(await page.value('new URLSearchParams(location.hash.slice(1)).has("data")'), false);
  await page.value("location.reload()");
  await page.until(
    'document.readyState === "complete" && document.getElementById("state").textContent !== "Loading …"',
  );
  await agrees(stdout);
  // so does the way back from another scenario
  await choose("#begin", "repeat");
  await page.until(`document.getElementById("text").value.includes("[repeat]")`);
  await page.back();
  await agrees(stdout);
  rmSync(folder, { recursive: true });
});

test("only a number and its interval are large, and a slow indentation has its last dent in view", async () => {
  await open(read("ball-on-plate.toml"));
  await agrees(runByCommand("ball-on-plate.toml").stdout);
  const large = await page.value(`(() => {
    const sizes = [...document.querySelectorAll("#numbers dd, #numbers dd *")].map((one) => [parseFloat(getComputedStyle(one).fontSize), one.textContent]);
    const usual = Math.min(...sizes.map(([size]) => size));
    return sizes.filter(([size]) => size > usual).map(([, text]) => text).filter(Boolean);
  })()`);
  assert.ok(large.length >= 2, `${large}`);
  for (const text of large) assert.match(text, /^[\d.]+( m\/s)?$|^\([\d.]+ to [\d.]+\)?$/);
  assert.match(
    await page.value('document.getElementById("state").textContent'),
    /^impact restitution [\d.]+( \([\d.]+ to [\d.]+\))?$/,
  );
  await open(read("indentation-cycles.toml"));
  await page.until(
    '/^indentation step \\d+: dent depth [\\d.]+ µm$/.test(document.getElementById("state").textContent)',
  );
});

test("on a phone and a tablet e stays in view, and pictures fit", async () => {
  for (const width of [390, 800]) {
    await page.look(width, 844, false);
    await open();
    await page.until(`${SHOWN}.includes("0.5064")`);
    await page.type(field("impact.speed"), "1 m/s");
    await page.until('document.getElementById("state").textContent.includes("0.6225")');
    const seen = (css) =>
      page.value(`(() => {
      const { top, bottom } = document.querySelector(${JSON.stringify(css)}).getBoundingClientRect();
      return top >= 0 && bottom <= innerHeight;
    })()`);
    assert.equal(await seen("#state"), true);
    assert.equal(await seen(field("impact.speed")), true);
    await page.value("scrollTo(0, document.body.scrollHeight)");
    assert.equal(await seen("#state"), true);
    const widest = await page.value(
      'Math.max(...[...document.querySelectorAll("#pictures svg")].map((one) => one.getBoundingClientRect().right))',
    );
    assert.ok(widest <= width, `${widest}`);
    // drawn for this width: the letters can be read, and the key is below the axes
    const [smallest, key, axes] = await page.value(`(() => {
      const texts = [...document.querySelectorAll("#picture-restitution text")];
      const of = (text) => texts.find((one) => one.textContent.includes(text)).getBoundingClientRect();
      const scale = document.querySelector("#picture-restitution svg").getScreenCTM().a;
      const sizes = texts.map((one) => scale * one.getAttribute("font-size"));
      return [Math.min(...sizes), of("this impact").top, of("Impact speed").bottom];
    })()`);
    assert.ok(smallest > 9 && key > axes, `${smallest} ${key} ${axes}`);
  }
  await page.look(1400, 900, false);
  await page.until('document.querySelector("#picture-restitution svg").getAttribute("width") === "1600"');
});

test("a bad link at the first load says that it is refused, and of no results", async () => {
  await page.go("about:blank");
  await page.go(`${site.address}#scenario=%25zz`);
  await page.until('!document.getElementById("problem").hidden');
  assert.equal(await page.value('document.getElementById("state").textContent'), "Invalid scenario.");
});

test("how exact the numbers are is folded, and e against speed can be had as CSV", async () => {
  await open();
  await page.until(`${SHOWN}.includes("0.5064")`);
  assert.deepEqual([await isSeen("#numbers details"), await isSeen("#numbers details dl")], [true, false]);
  assert.match(await page.value('document.querySelector("#numbers details").textContent'), /closed form.*steps/s);
  assert.ok((await cells("#files button")).includes("restitution.csv"));
});

test("a link has the keys without the comments of the first scenarios, which a reload keeps", async () => {
  await open();
  await page.type(field("impact.speed"), "1 m/s");
  await page.until(`${LINKED}?.includes('speed = "1 m/s"')`);
  assert.ok((await page.value("location.href.length")) < 600, await page.value("location.href"));
  const before = await text();
  assert.match(before, /^# Impact speed/m);
  await page.value("location.reload()");
  await page.until(
    `document.readyState === "complete" && document.getElementById("text").value === ${JSON.stringify(before)}`,
  );
  // a comment of the user is a part of the scenario
  const own = `# measured on 3 May\n${read("elastic.toml")}`;
  await open(own);
  await page.until(`${LINKED} === ${JSON.stringify(own)}`);
});

test("guide, citation, source and licences are beside the page, and every link of theirs leads somewhere", async () => {
  await open();
  const links = await page.value('[...document.querySelectorAll("nav a")].map((one) => one.getAttribute("href"))');
  assert.equal(links.length, 8);
  const seen = new Set();
  const follow = async (address) => {
    const [path, anchor] = address.split("#");
    if (!seen.has(path)) {
      const answer = await fetch(path);
      assert.equal(answer.status, 200, path);
      const body = path.endsWith(".html") ? await answer.text() : "";
      if (!body) await answer.arrayBuffer();
      seen.add(path);
      pages.set(path, body);
      for (const [, href] of body.matchAll(/(?:href|src)="([^"]+)"/g)) {
        const link = new URL(href.replaceAll("&amp;", "&"), path).href;
        // the documentation of other codes is on other sites
        if (link.startsWith(site.address)) await follow(link);
      }
    }
    if (anchor && pages.get(path)) assert.ok(pages.get(path).includes(`id="${decodeURIComponent(anchor)}"`), address);
  };
  const pages = new Map();
  for (const link of links) await follow(site.address + link);
  assert.ok(seen.size > 20, `${seen.size}`);
  assert.match(pages.get(`${site.address}pages/README.html`), /Xie et al\. \(2024\)/);
  const citation = `${site.address}pages/CITATION.cff`;
  assert.ok(seen.has(citation));
  assert.match(await (await fetch(citation)).text(), /family-names: Xie\b/);
});
