// SPDX-License-Identifier: MIT
// The SHA-256 of files, as hexadecimal digits.

const known = new WeakMap<Uint8Array, Promise<string>>();

/** Of bytes that nobody changes; each is digested once. "" where the page came over an open network, as browsers digest nothing there. */
export function digestOf(bytes: Uint8Array): Promise<string> {
  if (globalThis.crypto.subtle === undefined) return Promise.resolve('');
  const old = known.get(bytes);
  if (old) return old;
  const digest = crypto.subtle.digest('SHA-256', bytes as BufferSource).then((all) =>
    [...new Uint8Array(all)].map((byte) => byte.toString(16).padStart(2, '0')).join(''));
  known.set(bytes, digest);
  return digest;
}
