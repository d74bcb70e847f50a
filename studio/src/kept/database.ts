// SPDX-License-Identifier: MIT
// The browser's database, as promises.

const kName = 'shigusa';
const kVersion = 1;

const kStores = { projects: 'id', works: 'id', files: 'sha256', poses: 'id' } as const; // with their keys
export type StoreName = keyof typeof kStores;

/** Null where the browser keeps nothing. Some never answer. */
export function openDatabase(): Promise<IDBDatabase | null> {
  return new Promise((resolve) => {
    const none = (): void => resolve(null);
    try {
      const request = indexedDB.open(kName, kVersion);
      request.addEventListener('upgradeneeded', () => {
        for (const [name, keyPath] of Object.entries(kStores)) request.result.createObjectStore(name, { keyPath });
      });
      request.addEventListener('success', () => {
        // another version of the page may have the database when it wants to
        request.result.addEventListener('versionchange', () => request.result.close());
        resolve(request.result);
      });
      request.addEventListener('error', none);
    } catch {
      none();
    }
  });
}

export function answer<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.addEventListener('success', () => resolve(request.result));
    request.addEventListener('error', () => reject(request.error ?? new Error('the database does not answer')));
  });
}

/** Resolves once all of a transaction is kept. */
export function completed(transaction: IDBTransaction): Promise<void> {
  return new Promise((resolve, reject) => {
    transaction.addEventListener('complete', () => resolve());
    transaction.addEventListener('abort', () => reject(transaction.error ?? new DOMException('the database gave up', 'AbortError')));
  });
}

export function isQuota(error: unknown): boolean {
  return error instanceof DOMException && error.name === 'QuotaExceededError';
}
