// SPDX-License-Identifier: MIT
// One tab alone has a project; the browser's locks end with the tab.

export const hasLocks = (): boolean => 'locks' in navigator;

const lockName = (id: string): string => `shigusa project ${id}`;

export class ProjectLock {
  private release: () => void = () => undefined;

  drop(): void {
    this.release();
  }

  /** Lets the last project go and takes this one; false where another tab has it for longer than `patience_ms`. */
  take(id: string, patience_ms: number): Promise<boolean> {
    this.drop();
    // pages that came over an open network have none
    if (!hasLocks()) return Promise.resolve(true);
    return new Promise((resolve) => {
      const hold = (lock: Lock | null): Promise<void> | undefined => {
        resolve(lock !== null);
        if (lock === null) return undefined;
        return new Promise((release) => {
          this.release = release;
        });
      };
      const options = patience_ms > 0 ? { signal: AbortSignal.timeout(patience_ms) } : { ifAvailable: true };
      navigator.locks.request(lockName(id), options, hold).catch(() => resolve(false));
    });
  }
}

/** Does something to a project that no tab has; false where one has it. */
export async function whileFree(id: string, act: () => Promise<void>): Promise<boolean> {
  if (!hasLocks()) {
    await act();
    return true;
  }
  return navigator.locks.request(lockName(id), { ifAvailable: true }, async (lock) => {
    if (lock) await act();
    return lock !== null;
  });
}
