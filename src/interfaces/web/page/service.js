// The service worker: every file of the page comes from the network, and from what is kept where there is no network. So a new version
// of the page is seen at the next load.

const CACHE = "plm-impact";

self.addEventListener("install", () => self.skipWaiting());
self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));

// the files that the page loaded before this worker was there
self.addEventListener("message", ({ data, source }) => {
  const kept = caches.open(CACHE).then((cache) => addMissing(cache, data));
  kept.then(() => source.postMessage("kept"));
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method === "GET" && request.url.startsWith(self.location.origin)) event.respondWith(answer(event));
});

async function addMissing(cache, files) {
  const known = await Promise.all(files.map((file) => cache.match(file)));
  await cache.addAll(files.filter((_, at) => !known[at]));
}

async function answer(event) {
  const { request } = event;
  try {
    const reply = await fetch(request);
    // the page does not wait until the file is kept
    if (reply.ok) event.waitUntil(keep(request, reply.clone()));
    return reply;
  } catch (error) {
    const kept = await caches.match(request, { ignoreSearch: true });
    if (kept) return kept;
    throw error;
  }
}

async function keep(request, reply) {
  const cache = await caches.open(CACHE);
  await cache.put(request, reply);
}
