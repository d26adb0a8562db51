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

let module;
let worker = null;
let startedAt = null;
let next = null;
let failures = 0;
let onReply;

/** Loads the program; `whenDone` is called with the reply to every run. */
export async function load(whenDone) {
  const file = await fetch(new URL("plm_impact_bg.wasm", import.meta.url));
  module = await WebAssembly.compile(await file.arrayBuffer());
  onReply = whenDone;
  startWorker();
  await init({ module_or_path: module });
}

/** Runs a scenario; `data` are measurements, or nothing. */
export function run(name, text, data, isNarrow) {
  next = [name, text, data, isNarrow];
  // what a user asks for after the last failure is one more attempt
  if (worker === null || (startedAt !== null && performance.now() - startedAt > TAKEOVER_MS)) startWorker();
  if (startedAt === null) send();
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
      onReply({ error: `${error} (${failures} times in a row); load the page again`, details: {} });
    }
  };
  worker.postMessage(module);
}

function send() {
  startedAt = performance.now();
  worker.postMessage(next);
  next = null;
}

function done(reply) {
  startedAt = null;
  if (next) send();
  else onReply(reply);
}
