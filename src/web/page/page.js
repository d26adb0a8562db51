// The page: the text of the scenario is what is run; form and address follow it, and a field changes it.

import { download } from "./element.js";
import { makeForm } from "./form.js";
import { edited, fields, given, load, materials, run, templates } from "./program.js";
import { outdate, showResults } from "./results.js";

const FILE = "scenario.toml";
const DATA = "calibrate.data";
// More than this of measurements does not go into a link.
const LONGEST = 20000;

const at = (id) => document.getElementById(id);
let text = "";
let data;
let form;
let later;

/** Takes another text, shows it everywhere, and runs it. */
function take(newText) {
  text = newText;
  if (at("text").value !== text) at("text").value = text;
  const values = given(text);
  // a text that is no TOML leaves the form as it was
  at("form").toggleAttribute("inert", Boolean(values.error));
  if (!values.error) form.fill(values);
  at("measured").hidden = data === undefined;
  at("measured").firstElementChild.textContent = `measured: ${values[DATA] ?? "not used by the scenario"}`;
  run(FILE, text, data);
  // browsers take only some changes of the address a second
  clearTimeout(later);
  later = setTimeout(address, 300);
}

/** Puts the scenario into the address. */
function address() {
  clearTimeout(later);
  const link = new URLSearchParams({ scenario: text });
  if (data !== undefined && data.length < LONGEST) link.set("data", data);
  history.replaceState(null, "", `#${link}`);
}

function done(reply) {
  const { error, details } = reply;
  const isAtField = form.complain(details?.key, details?.message);
  at("problem").hidden = !error;
  at("problem").textContent = error ?? "";
  at("problem").classList.toggle("at-field", isAtField);
  if (error) outdate();
  else showResults(reply);
}

async function measure(file) {
  data = await file.text();
  take(edited(text, DATA, file.name));
}

/** The scenario of the address, or the one to begin with. */
function restore() {
  const link = new URLSearchParams(location.hash.slice(1));
  data = link.get("data") ?? undefined;
  take(link.get("scenario") ?? templates().impact);
}

function listen() {
  at("text").addEventListener("input", () => take(at("text").value));
  at("begin").addEventListener("change", () => {
    const kind = at("begin").value;
    if (!kind) return;
    // the way back leads to the scenario before
    address();
    history.pushState(null, "");
    data = undefined;
    at("data").value = "";
    take(templates()[kind]);
  });
  at("data").addEventListener("change", () => at("data").files[0] && measure(at("data").files[0]));
  at("without").addEventListener("click", () => {
    data = undefined;
    at("data").value = "";
    take(edited(text, DATA.split(".")[0], ""));
  });
  at("save").addEventListener("click", () => download(FILE, text));
  at("link").addEventListener("click", async () => {
    address();
    await navigator.clipboard.writeText(location.href);
    at("told").textContent = "copied";
  });
  const zone = at("drop");
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

try {
  await load(done);
  const kinds = Object.keys(templates());
  for (const kind of kinds) at("begin").append(new Option(kind.replace("_", " "), kind));
  const changed = (changes) => take(changes.reduce((text, [path, value]) => edited(text, path, value), text));
  form = makeForm(at("form"), { fields: fields(), materials: materials(), kinds, changed });
  listen();
  restore();
} catch (error) {
  at("state").textContent = `The program could not be loaded: ${error.message}`;
}
