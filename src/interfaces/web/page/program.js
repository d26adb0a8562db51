// The program: quick questions are answered at once, runs go to a worker. Of runs that are asked for while one is at work only
// the last is done.

import init, * as program from "./plm_impact.js";

export const withValue = program.with_value;
export const givenValues = (text) => JSON.parse(program.given_values(text));
export const fields = () => JSON.parse(program.fields());
export const materials = () => JSON.parse(program.materials());
export const templates = () => JSON.parse(program.templates());

// A run that takes longer than this gives way to the next one.
const TAKEOVER_MS = 1000;
// After so many errors without a reply between them no new worker is made.
const MAX_FAILURES = 3;

// the place of the format of pictures in what is asked
const PICTURES = 3;

let module;
let worker = null;
let startedAt = null;
let next = null;
// runs beside those of the page, which wait until the worker is free, and the one that is at work
const asked = [];
let current = null;
let atWork = null;
let failures = 0;
let onReply;

/**
 * Loads the program; `whenDone` is called with the reply to every run and with what was asked. A run whose result is no more wanted has no
 * reply, except one without pictures: this is a value that moves, and its curves move with it.
 */
export async function load(whenDone) {
  const file = await fetch(new URL("plm_impact_bg.wasm", import.meta.url));
  module = await WebAssembly.compile(await file.arrayBuffer());
  onReply = whenDone;
  startWorker();
  await init({ module_or_path: module });
}

/** Runs a scenario; `data` are measurements, or nothing; `pictures` is their format. */
export function run(name, text, data, pictures) {
  next = [name, text, data, pictures];
  // what a user asks for after the last failure is one more attempt
  if (worker === null || (startedAt !== null && performance.now() - startedAt > TAKEOVER_MS)) {
    startWorker();
    giveUp();
  }
  if (startedAt === null) send();
}

/** The reply to a run beside those of the page. */
export function ask(...message) {
  return new Promise((resolve) => {
    asked.push({ message, resolve });
    if (startedAt === null && worker) send();
  });
}

function giveUp() {
  current?.resolve({ error: "the run was stopped" });
  current = null;
}

// A new worker: a program that was stopped, or has stopped by itself, is of no use any more.
function startWorker() {
  worker?.terminate();
  startedAt = null;
  worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
  worker.onmessage = ({ data }) => {
    failures = 0;
    done(JSON.parse(data));
  };
  worker.onerror = (event) => {
    event.preventDefault();
    failures += 1;
    // a file that cannot be loaded has no message
    const error = `internal error: ${event.message ?? "its files cannot be loaded; is the server there?"}`;
    if (failures < MAX_FAILURES) {
      startWorker();
      done({ error, details: {} });
    } else {
      worker.terminate();
      worker = null;
      startedAt = next = null;
      giveUp();
      onReply({ error: `${error} (${failures} times in a row); load the page again`, details: {} }, []);
    }
  };
  worker.postMessage(module);
}

function send() {
  if (!next && asked.length > 0) current = asked.shift();
  const message = next ?? current?.message;
  next = null;
  if (!message) return;
  startedAt = performance.now();
  atWork = message;
  worker.postMessage(message);
}

function done(reply) {
  startedAt = null;
  if (current) {
    current.resolve(reply);
    current = null;
  } else if (!next || atWork?.[PICTURES] === "none") onReply(reply, atWork ?? []);
  if (startedAt === null) send();
}
