// SPDX-License-Identifier: MIT
// A work in a link: "#work=1." and its JSON, deflated, in base64url. Browsers send nothing after the # to servers.
import { readWork, type Work } from './work';

const kFragment = '#work=1.';
/** Letters of a link. Longer ones get lost on their way through mails and messages. */
const kLongest = 32_000;
const kMostBytes = 4_000_000; // of the JSON
const kDeepest = 40; // brackets within one another

/** The link of a work; null where it would be too long, or the browser cannot deflate. */
export async function linkOf(work: Work, page: string): Promise<string | null> {
  if (typeof CompressionStream === 'undefined') return null;
  const stream = new Blob([JSON.stringify(work)]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  if (bytes.length > kLongest) return null;
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  const link = page.split('#')[0] + kFragment + btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
  return link.length > kLongest ? null : link;
}

/** The work of a link; null if there is none. Throws a SyntaxError if it is damaged. */
export async function workOfLink(fragment: string): Promise<Work | null> {
  if (!fragment.startsWith(kFragment)) return null;
  const text = await inflated(bytesOf(fragment.slice(kFragment.length)));
  if (depthOf(text) > kDeepest) throw new SyntaxError('the JSON is too deep');
  return readWork(JSON.parse(text));
}

function bytesOf(base64url: string): Uint8Array<ArrayBuffer> {
  try {
    const text = atob(base64url.replaceAll('-', '+').replaceAll('_', '/'));
    return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  } catch {
    throw new SyntaxError('not base64url');
  }
}

/** A few bytes may stand for any number of them, so that it is counted while they come. */
async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw')).getReader();
  const decoder = new TextDecoder('utf-8', { fatal: true });
  let text = '';
  let count = 0;
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return text + decoder.decode();
      count += value.length;
      if (count > kMostBytes) throw new RangeError('too large');
      text += decoder.decode(value, { stream: true });
    }
  } catch (error) {
    await reader.cancel().catch(() => undefined);
    throw new SyntaxError(error instanceof Error ? error.message : 'not deflated');
  }
}

/** How deep the brackets of a JSON text go. */
function depthOf(text: string): number {
  let depth = 0;
  let deepest = 0;
  for (const [bracket] of text.matchAll(/"(?:[^"\\]|\\.)*"|[[\]{}]/gs)) {
    if (bracket === '[' || bracket === '{') deepest = Math.max(deepest, ++depth);
    else if (bracket === ']' || bracket === '}') --depth;
  }
  return deepest;
}
