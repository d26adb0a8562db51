// The page: the text of the scenario is what is run; form and address follow it, and a field changes it.

import { makeBench } from "./bench.js";
import { download, element } from "./element.js";
import { EXPERIMENTS, experiment } from "./experiments.js";
import { makeForm } from "./form.js";
import { keepOffline } from "./offline.js";
import { isNarrow, onRoom } from "./picture.js";
import { fields, givenValues, load, materials, run, templates, withValue } from "./program.js";
import { markStale, showResults } from "./results.js";
import { makeSweepFields } from "./sweep.js";

const FILE = "scenario.toml";
const DATA = "calibrate.data";
// More characters of measurements than this do not go into a link.
const LONGEST = 20000;
const isTooLong = () => data !== undefined && data.length >= LONGEST;

const byId = (id) => document.getElementById(id);
let text = "";
let data;
let form;
let bench;
let sweep;
let later;
// A value that moves is computed without pictures; the pictures follow when it rests so long.
const REST_MS = 350;
let rest = null;
// whether the files of the page are being kept for a time without a network
let isOffline = false;
// a key that was emptied, with the text before and after
let emptied = null;

/** Takes another text, shows it everywhere, and runs it; without pictures while a value moves. */
function setScenario(newText, isMoving = false) {
  text = newText;
  if (byId("text").value !== text) byId("text").value = text;
  const values = givenValues(text);
  // a text that is no TOML leaves the form as it was
  byId("form").toggleAttribute("inert", Boolean(values.error));
  if (!values.error) {
    form.fill(values);
    bench.fill(values);
    sweep.fill(values);
  }
  byId("measured").hidden = data === undefined;
  byId("measured").firstElementChild.textContent = `measured: ${values[DATA] ?? "not used by the scenario"}`;
  // what was copied is not this scenario
  byId("told").textContent = "";
  byId("address").hidden = true;
  compute(isMoving);
  // browsers take only some changes of the address a second
  clearTimeout(later);
  later = setTimeout(address, 300);
}

function compute(isMoving = false) {
  clearTimeout(rest);
  rest = isMoving ? setTimeout(compute, REST_MS) : null;
  byId("results").ariaBusy = "true";
  run(FILE, text, data, isMoving ? "none" : isNarrow(byId("pictures")) ? "narrow-svg" : "svg");
}

/** Takes other values of keys, as they are typed or moved. */
function change(changes, isMoving = false) {
  const [[path, value]] = changes;
  // a field that is emptied and typed in again leaves its key where it was, with its comments
  const from = emptied?.path === path && emptied.after === text ? emptied.before : text;
  const after = changes.reduce((text, [path, value]) => withValue(text, path, value), from);
  emptied = changes.length === 1 && value === "" ? { path, before: from, after } : null;
  setScenario(after, isMoving);
}

/** The text without the comments of the first scenarios, which explain keys. */
function withoutTemplateComments(text) {
  const comments = new Set(
    Object.values(templates())
      .flatMap((text) => text.split("\n"))
      .filter((line) => line.startsWith("#")),
  );
  const lines = text.split("\n").filter((line) => !comments.has(line));
  return lines
    .join("\n")
    .replace(/\n{3,}/g, "\n\n")
    .replace(/^\n+/, "");
}

/** Puts the scenario into the address. The text with all comments, and long measurements, stay in the history of this browser. */
function address() {
  clearTimeout(later);
  const link = new URLSearchParams({ scenario: withoutTemplateComments(text) });
  if (data !== undefined && !isTooLong()) link.set("data", data);
  for (const kept of bench.texts()) link.append("kept", withoutTemplateComments(kept));
  const kept = isTooLong() ? { text, data } : { text };
  try {
    history.replaceState(kept, "", `#${link}`);
  } catch {
    // a browser keeps some megabytes at most
    history.replaceState({ text }, "", `#${link}`);
  }
}

/** The scenario of the address, or the one to begin with. */
function restore() {
  const link = new URLSearchParams(location.hash.slice(1));
  const linked = link.get("scenario");
  const { text: whole, data: measured } = history.state ?? {};
  const isOfThisBrowser = whole !== undefined && withoutTemplateComments(whole) === linked;
  data = link.get("data") ?? (isOfThisBrowser ? measured : undefined);
  setScenario(isOfThisBrowser ? whole : (linked ?? templates().impact));
  // the kept curves wait until the first result is there
  bench.restore(link.getAll("kept"));
}

function done(reply, [, computed, , pictures]) {
  const isMoving = pictures === "none";
  if (!isMoving) byId("results").ariaBusy = "false";
  const { error, details } = reply;
  const cure = details?.missing_key ? cureOf(details.missing_key) : null;
  const isAtField = form.showError(details?.key, details?.message, cure);
  byId("problem").hidden = !error;
  byId("problem").replaceChildren(error ?? "", ...(cure && !isAtField ? ["\n", cure] : []));
  byId("problem").classList.toggle("at-field", isAtField);
  if (error) markStale();
  else {
    showResults(reply, isMoving);
    // the numbers are seen first
    if (isMoving) bench.show(reply, computed);
    else setTimeout(() => bench.show(reply, computed));
    if (!isOffline) keepOffline();
    isOffline = true;
  }
}

/** A button that adds a key which is asked for; none for a key without an example. */
function cureOf(key) {
  const field = fields().find((field) => field.path === key);
  if (!field?.example) return null;
  const button = element(
    "button",
    { type: "button" },
    `Add ${field.title[0].toLowerCase()}${field.title.slice(1)} = ${field.example}`,
  );
  button.addEventListener("click", () => {
    change([[key, field.example]]);
    form.focus(key);
  });
  return button;
}

async function measure(file) {
  data = await file.text();
  setScenario(withValue(text, DATA, file.name));
}

async function copyLink() {
  address();
  try {
    await navigator.clipboard.writeText(location.href);
    byId("told").textContent = isTooLong()
      ? "copied without the measurements, which are too long for a link: send their file too"
      : "copied";
  } catch {
    // a page that is not sent over https has no clipboard, and a user may refuse it
    const missing = isTooLong() ? " The measurements are too long for a link: send their file too." : "";
    byId("told").textContent = `Clipboard access was denied. Copy the link here:${missing}`;
    Object.assign(byId("address"), { hidden: false, value: location.href }).select();
  }
}

function listen() {
  byId("text").addEventListener("input", () => setScenario(byId("text").value));
  byId("begin").addEventListener("change", async () => {
    const name = byId("begin").value;
    if (!name) return;
    const begun = templates()[name] ?? (await experiment(name).catch(refuse));
    if (!begun) return;
    // the way back leads to the scenario before
    address();
    history.pushState(null, "");
    data = undefined;
    byId("data").value = "";
    setScenario(begun);
  });
  byId("full").addEventListener("click", () =>
    document.fullscreenElement ? document.exitFullscreen() : byId("results").requestFullscreen(),
  );
  byId("to-values").addEventListener("click", () => byId("begin").focus());
  byId("print").addEventListener("click", () => window.print());
  byId("data").addEventListener("change", () => byId("data").files[0] && measure(byId("data").files[0]));
  byId("without").addEventListener("click", () => {
    data = undefined;
    byId("data").value = "";
    setScenario(withValue(text, DATA.split(".")[0], ""));
  });
  byId("save").addEventListener("click", () => download(FILE, text));
  byId("link").addEventListener("click", copyLink);
  const zone = byId("drop");
  const over = (event) => {
    event.preventDefault();
    zone.classList.toggle("over", event.type === "dragover");
  };
  zone.addEventListener("dragover", over);
  zone.addEventListener("dragleave", over);
  zone.addEventListener("drop", (event) => {
    over(event);
    if (event.dataTransfer.files[0]) measure(event.dataTransfer.files[0]);
  });
  window.addEventListener("popstate", restore);
  onRoom(byId("pictures"), compute);
}

function refuse(error) {
  byId("problem").hidden = false;
  byId("problem").textContent = error.message;
}

function addChoices(label, choices) {
  byId("begin").append(element("optgroup", { label }, ...choices.map(({ name, title }) => new Option(title, name))));
}

function openText() {
  byId("source").open = true;
  byId("text").focus();
}

try {
  await load(done);
  const kinds = Object.keys(templates());
  addChoices("Experiments", EXPERIMENTS);
  addChoices(
    "Empty forms",
    kinds.map((kind) => ({ name: kind, title: kind.replace("_", " ") })),
  );
  const [keys, known] = [fields(), materials()];
  const usual = Object.keys(givenValues(templates().impact));
  form = makeForm(byId("form"), { fields: keys, materials: known, kinds, usual, changed: change, openText });
  sweep = makeSweepFields(byId("sweep"), { fields: keys, changed: change });
  bench = makeBench({
    fields: keys,
    materials: known,
    change: (path, value) => change([[path, value]], true),
    keptChanged: address,
  });
  listen();
  restore();
} catch (error) {
  byId("state").textContent = `The program could not be loaded: ${error.message}`;
}
