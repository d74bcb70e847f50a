// SPDX-License-Identifier: MIT
// The service worker: keeps all files of the built page, and answers with them, so that it works without the network.
// A newer one waits until nobody has the page open, or until a person asks for it.
declare const self: ServiceWorkerGlobalScope;

/** Of these files' contents, by the build. */
declare const kVersion: string;
/** All that the page consists of, from its folder; `./` is the page itself. */
declare const kFiles: readonly string[];

const { scope } = self.registration; // other pages of this host have caches too
const kOurs = `shigusa ${scope} `;
const kCache = kOurs + kVersion;
const kLasting = /\/assets\//; // their names change with what they hold

const addresses = new Set(kFiles.map((file) => new URL(file, scope).href));

/** A file of the page: from an older cache where it is the same there. */
async function fetched(address: string): Promise<Response> {
  const lasting = kLasting.test(address);
  const known = lasting ? await caches.match(address, { ignoreVary: true }) : undefined;
  const answer = known ?? (await fetch(address, { cache: lasting ? 'default' : 'no-cache' }));
  if (!answer.ok) throw new TypeError(`${answer.status} for ${address}`);
  // a page must not come of an answer that has gone another way
  return answer.redirected ? new Response(answer.body, { headers: answer.headers }) : answer;
}

/** All files, or none. */
async function keepFiles(): Promise<void> {
  const cache = await caches.open(kCache);
  try {
    await Promise.all([...addresses].map(async (address) => cache.put(address, await fetched(address))));
  } catch (error) {
    await caches.delete(kCache);
    throw error;
  }
}

async function forget(isOld: (name: string) => boolean): Promise<void> {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith(kOurs) && isOld(name)).map((name) => caches.delete(name)));
}

/** Of a request the file that answers it; of a page's address without what follows its folder. */
function fileOf({ url, mode }: Request): string {
  const { origin, pathname } = new URL(url);
  return origin + (mode === 'navigate' ? pathname.replace(/\/index\.html$/, '/') : pathname);
}

async function answered(request: Request, file: string): Promise<Response> {
  const cache = await caches.open(kCache);
  return (await cache.match(file, { ignoreVary: true })) ?? fetch(request);
}

/** Retires where the page is gone, so that what is served in its place is seen: another program's page at a port. */
async function lookForPage(): Promise<void> {
  const answer = await fetch(self.location.href, { cache: 'no-store' }).catch(() => null);
  if (answer === null || answer.redirected || answer.status >= 500) return;
  if (answer.ok && /javascript/.test(answer.headers.get('content-type') ?? '')) return;
  await forget(() => true);
  await self.registration.unregister();
}

self.addEventListener('install', (event) => event.waitUntil(keepFiles()));

self.addEventListener('activate', (event) => {
  event.waitUntil(forget((name) => name !== kCache).then(() => self.clients.claim()));
});

self.addEventListener('message', ({ data }) => {
  if (data === 'take over') void self.skipWaiting();
});

self.addEventListener('fetch', (event) => {
  const { request } = event;
  const file = fileOf(request);
  if (request.method !== 'GET' || !addresses.has(file)) return;
  event.respondWith(answered(request, file));
  if (request.mode === 'navigate') event.waitUntil(lookForPage());
});
