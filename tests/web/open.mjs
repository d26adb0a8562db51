// The page, opened in a browser, and what is seen of it. Browser and server end after the last test.

import { after } from "node:test";

import { browse, serve } from "./browser.mjs";
import { PAGE } from "./command.mjs";

export const site = await serve(PAGE);
export const page = await browse();

after(async () => {
  await page.end();
  site.end();
});

export const SHOWN =
  '[...document.querySelectorAll("#numbers :is(p, dt, dd, th, td):not(table:has(caption) *)")].map((one) => one.textContent).join(" ")';
export const field = (path) => `[id="field-${path}"]`;
export const valueOf = (path) => page.value(`document.querySelector('${field(path)}').value`);
export const text = () => page.value('document.getElementById("text").value');

export const LINKED = 'new URLSearchParams(location.hash.slice(1)).get("scenario")';

/** Opens the page with a scenario in its address, or with the first one, and waits until all of its results are there. */
export async function open(scenario, data, address = site.address) {
  const link = scenario ? `#${new URLSearchParams({ scenario, ...(data && { data }) })}` : "";
  // the address alone would not load the page anew
  await page.go("about:blank");
  await page.go(address + link);
  await page.until('document.getElementById("results").ariaBusy === "false"');
}

/** Waits until the numbers are those that the command prints. */
export async function agrees(stdout) {
  const words = stdout.split(/\s+/).filter(Boolean).join(" ");
  await page.until(`${SHOWN}.split(/\\s+/).filter(Boolean).join(" ") === ${JSON.stringify(words)}`);
}

/** Chooses from a list, and waits for the answer. */
export async function choose(css, value) {
  await page.value(`(() => {
    const list = document.querySelector(${JSON.stringify(css)});
    list.value = ${JSON.stringify(value)};
    for (const kind of ["input", "change"]) list.dispatchEvent(new Event(kind));
  })()`);
  await page.until('document.getElementById("results").ariaBusy !== "true"');
}

export const cells = (css) =>
  page.value(`[...document.querySelectorAll(${JSON.stringify(css)})].map((one) => one.textContent)`);

export const isSeen = (css) => page.value(`document.querySelector(${JSON.stringify(css)})?.checkVisibility() ?? false`);
