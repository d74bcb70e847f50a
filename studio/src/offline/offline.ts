// SPDX-License-Identifier: MIT
// Makes the browser cache the whole page, and reports when it works offline, and when a newer version waits.
import type { Store } from '../state/store';
import type { State } from '../state/model';

const kWorker = './offline.js'; // made by the build, beside the page

/** Where it cannot be kept, as in a private window or over plain HTTP, the page works as it is. */
export async function keepOffline(store: Store<State>): Promise<void> {
  const { serviceWorker } = navigator;
  if (!import.meta.env.PROD || !serviceWorker) return;
  const hadPage = serviceWorker.controller !== null;
  const tellNewer = (): void => store.set({ offline: 'newer' });
  const registration = await serviceWorker.register(kWorker);
  if (registration.waiting) tellNewer();
  registration.addEventListener('updatefound', () => {
    const next = registration.installing;
    next?.addEventListener('statechange', () => {
      if (next.state === 'installed' && serviceWorker.controller) tellNewer();
    });
  });
  // another tab has taken the newer one
  serviceWorker.addEventListener('controllerchange', () => {
    if (hadPage) tellNewer();
  });
  await serviceWorker.ready;
  if (store.state.offline === 'no') store.set({ offline: 'ready' });
}

/** Opens the newer page. */
export async function takeNewer(): Promise<void> {
  const { serviceWorker } = navigator;
  const waiting = (await serviceWorker.getRegistration())?.waiting;
  if (!waiting) return location.reload();
  serviceWorker.addEventListener('controllerchange', () => location.reload(), { once: true });
  waiting.postMessage('take over', []);
}
