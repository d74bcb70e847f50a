// SPDX-License-Identifier: MIT
// Short texts stored by the browser. A browser set to store nothing also refuses to read.

export type Memory = 'localStorage' | 'sessionStorage'; // of all tabs, of this one

export function recall(key: string, from: Memory = 'localStorage'): string | null {
  try {
    return window[from].getItem(`shigusa.${key}`);
  } catch {
    return null;
  }
}

export function remember(key: string, text: string, into: Memory = 'localStorage'): void {
  try {
    window[into].setItem(`shigusa.${key}`, text);
  } catch {
    // then not
  }
}

export function forget(key: string, from: Memory = 'localStorage'): void {
  try {
    window[from].removeItem(`shigusa.${key}`);
  } catch {
    // then there is none
  }
}
