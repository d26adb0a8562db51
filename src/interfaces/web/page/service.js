// The service worker: every file comes from the network, and from what is kept where there is no network. So a new version of the page is
// seen at the next load. The files of the page are kept when its first result is there, all of them or none.

const CACHE = "plm-impact";
const DOCUMENTS = new URL("pages/", self.registration.scope).href;

self.addEventListener("install", () => self.skipWaiting());
self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));

// the files that the page has loaded, in the version of this load
self.addEventListener("message", (event) => event.waitUntil(renew(event.data)));

self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method === "GET" && request.url.startsWith(self.location.origin)) event.respondWith(answer(event));
});

async function renew(files) {
  const cache = await caches.open(CACHE);
  await cache.addAll(files);
}

async function answer(event) {
  const { request } = event;
  try {
    const reply = await fetch(request);
    // a document that was read can be read again; nobody waits until it is kept
    if (reply.ok && request.url.startsWith(DOCUMENTS)) event.waitUntil(keep(request, reply.clone()));
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
