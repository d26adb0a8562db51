// The service worker: every file of the page comes from the network, and from what is kept where there is no network. So a new version
// of the page is seen at the next load.

const CACHE = "plm-impact";

self.addEventListener("install", () => self.skipWaiting());
self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));

// the files that the page loaded before this worker was there
self.addEventListener("message", ({ data, source }) => {
  const kept = caches.open(CACHE).then((cache) => cache.addAll(data));
  kept.then(() => source.postMessage("kept"));
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method === "GET" && request.url.startsWith(self.location.origin)) event.respondWith(answer(request));
});

async function answer(request) {
  const cache = await caches.open(CACHE);
  try {
    const reply = await fetch(request);
    if (reply.ok) await cache.put(request, reply.clone());
    return reply;
  } catch (error) {
    const kept = await cache.match(request, { ignoreSearch: true });
    if (kept) return kept;
    throw error;
  }
}
