// After the first load the page works without a network: a service worker keeps its files.

import { EXPERIMENTS, fileOf } from "./experiments.js";

/** Starts the service worker, and tells it the files that the page has loaded. A page that is not sent over https has none. */
export async function keepOffline() {
  if (!navigator.serviceWorker) return;
  try {
    await navigator.serviceWorker.register(new URL("service.js", import.meta.url));
    const { active } = await navigator.serviceWorker.ready;
    const loaded = performance.getEntriesByType("resource").map(({ name }) => name);
    const own = loaded.filter((name) => name.startsWith(location.origin));
    const experiments = EXPERIMENTS.map(({ name }) => fileOf(name).href);
    const files = [
      location.origin + location.pathname,
      new URL("worker.js", import.meta.url).href,
      ...own,
      ...experiments,
    ];
    active.postMessage([...new Set(files)]);
  } catch {
    // a browser may refuse; the page then needs the network
  }
}
