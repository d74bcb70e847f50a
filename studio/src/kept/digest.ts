// SPDX-License-Identifier: MIT
// The SHA-256 of files, as hexadecimal digits.

const asked = new WeakMap<Uint8Array, Promise<string>>();
const known = new WeakMap<Uint8Array, string>();

/** Of bytes that nobody changes; each is digested once. "" where the page came over an open network, as browsers digest nothing there. */
export function digestOf(bytes: Uint8Array): Promise<string> {
  const old = asked.get(bytes);
  if (old) return old;
  const digest = digested(bytes);
  asked.set(bytes, digest);
  return digest;
}

/** The same where it is known already. */
export const knownDigest = (bytes: Uint8Array): string | undefined => known.get(bytes);

async function digested(bytes: Uint8Array): Promise<string> {
  const { subtle } = globalThis.crypto;
  const digest = subtle === undefined ? [] : [...new Uint8Array(await subtle.digest('SHA-256', bytes as BufferSource))];
  const text = digest.map((byte) => byte.toString(16).padStart(2, '0')).join('');
  known.set(bytes, text);
  return text;
}
