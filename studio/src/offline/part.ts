// SPDX-License-Identifier: MIT
// Parts of the page that are fetched when they are needed.

/** A part that could not be fetched. */
export class PartError extends Error {}

/** Any failure, as browsers have words of their own for it, is told as one of the part. */
export async function fetchPart<Part>(load: () => Promise<Part>): Promise<Part> {
  try {
    return await load();
  } catch (cause) {
    throw new PartError('a part of the page could not be fetched', { cause });
  }
}
