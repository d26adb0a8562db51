// The page: the text of the scenario is what is run; form and address follow it, and a field changes it.

import { download, element } from "./element.js";
import { makeForm } from "./form.js";
import { isNarrow, onRoom } from "./picture.js";
import { fields, givenValues, load, materials, run, templates, withValue } from "./program.js";
import { markStale, showResults } from "./results.js";

const FILE = "scenario.toml";
const DATA = "calibrate.data";
// More characters of measurements than this do not go into a link.
const LONGEST = 20000;
const isTooLong = () => data !== undefined && data.length >= LONGEST;

const byId = (id) => document.getElementById(id);
let text = "";
let data;
let form;
// what comes after the first result, and the promise of it
let later = null;
let loading = null;
// the kept curves of the address, until the bench has them
let linked = [];
let addressing;
// A value that moves is computed without pictures; the pictures follow when it rests so long.
const REST_MS = 350;
let rest = null;
// how many runs were asked for
let runs = 0;
// a key that was emptied, with the text before and after
let emptied = null;

/** Takes another text, runs it, and shows it everywhere; without pictures while a value moves. */
function setScenario(newText, isMoving = false) {
  text = newText;
  // the program works beside the page
  compute(isMoving);
  if (byId("text").value !== text) byId("text").value = text;
  const values = fill();
  byId("measured").hidden = data === undefined;
  byId("measured").firstElementChild.textContent = `measured: ${values[DATA] ?? "not used by the scenario"}`;
  // what was copied is not this scenario
  byId("told").textContent = "";
  byId("address").hidden = true;
  // browsers take only some changes of the address a second
  clearTimeout(addressing);
  addressing = setTimeout(address, 300);
}

/** Shows the values that the text gives. A text that is no TOML leaves the form as it was. */
function fill() {
  const values = givenValues(text);
  byId("form").toggleAttribute("inert", Boolean(values.error));
  if (!values.error) {
    form.fill(values);
    later?.fill(values);
  }
  return values;
}

function compute(isMoving = false) {
  clearTimeout(rest);
  rest = isMoving ? setTimeout(compute, REST_MS) : null;
  runs += 1;
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
  clearTimeout(addressing);
  const link = new URLSearchParams({ scenario: withoutTemplateComments(text) });
  if (data !== undefined && !isTooLong()) link.set("data", data);
  for (const kept of later?.bench.texts() ?? linked) link.append("kept", withoutTemplateComments(kept));
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
  const scenario = link.get("scenario");
  const { text: whole, data: measured } = history.state ?? {};
  const isOfThisBrowser = whole !== undefined && withoutTemplateComments(whole) === scenario;
  data = link.get("data") ?? (isOfThisBrowser ? measured : undefined);
  linked = link.getAll("kept");
  setScenario(isOfThisBrowser ? whole : (scenario ?? templates().impact));
  later?.bench.restore(linked);
}

function done(reply, [, computed, , pictures]) {
  const isMoving = pictures === "none";
  const { error, details } = reply;
  const cure = details?.missing_key ? cureOf(details.missing_key) : null;
  const isAtField = form.showError(details?.key, details?.message, cure);
  byId("problem").hidden = !error;
  byId("problem").replaceChildren(error ?? "", ...(cure && !isAtField ? ["\n", cure] : []));
  byId("problem").classList.toggle("at-field", isAtField);
  if (error) markStale();
  else showResults(reply, isMoving);
  // the numbers are seen first
  if (isMoving) follow(reply, computed);
  else setTimeout(follow, 0, reply, computed, runs);
}

/** Shows the bench of a result; then the results are complete, unless another run was asked for. */
async function follow(reply, computed, number) {
  try {
    const { bench } = await loadLater();
    if (!reply.error) bench.show(reply, computed);
  } catch (error) {
    refuse(error);
  }
  if (number === runs) byId("results").ariaBusy = "false";
}

// loads it once; what failed is tried again at the next result
function loadLater() {
  const start = ({ makeLater }) => {
    later = makeLater({ fields: fields(), materials: materials(), change, keptChanged: address });
    fill();
    later.bench.restore(linked);
    return later;
  };
  const fail = (error) => {
    loading = null;
    throw error;
  };
  loading ??= import("./later.js").then(start).catch(fail);
  return loading;
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

// On a phone, the widths of page.css, the results come first: for the eye, for keys and for a screen reader. What has the focus is not moved.
const PHONE = matchMedia("(max-width: 44rem)");
function order() {
  const [first, second] = PHONE.matches ? ["results", "scenario"] : ["scenario", "results"];
  if (byId(first).contains(document.activeElement)) byId(first).after(byId(second));
  else byId(second).before(byId(first));
}

function listen() {
  byId("text").addEventListener("input", () => setScenario(byId("text").value));
  byId("begin").addEventListener("change", async () => {
    const name = byId("begin").value;
    if (!name) return;
    const begun = templates()[name] ?? (await later.experiment(name).catch(refuse));
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
}

function refuse(error) {
  byId("problem").hidden = false;
  byId("problem").textContent = error.message;
}

function openText() {
  byId("source").open = true;
  byId("text").focus();
}

order();
PHONE.addEventListener("change", order);
try {
  await load(done);
  onRoom(byId("pictures"), compute);
  const kinds = Object.keys(templates());
  const choices = kinds.map((kind) => new Option(kind.replace("_", " "), kind));
  byId("begin").append(element("optgroup", { label: "Empty forms" }, ...choices));
  const usual = Object.keys(givenValues(templates().impact));
  form = makeForm(byId("form"), { fields: fields(), materials: materials(), kinds, usual, changed: change, openText });
  listen();
  restore();
} catch (error) {
  byId("state").textContent = `The program could not be loaded: ${error.message}`;
}
