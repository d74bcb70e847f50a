// SPDX-License-Identifier: MIT
// Files and links that go out.
import type { Studio } from './studio';
import { completeTask, linkOf } from './task';

export type Taken = 'glb' | 'vrma' | 'bvh' | 'csv' | 'svg' | 'png' | 'task' | 'result';

const kTypes: Record<Taken, string> = {
  glb: 'model/gltf-binary', vrma: 'model/gltf-binary', bvh: 'text/plain', csv: 'text/csv', svg: 'image/svg+xml', png: 'image/png',
  task: 'application/json', result: 'application/json',
};

/** Whether the character can leave in a format: VRMA and its own GLB need a file of that kind. */
export function canTake(studio: Studio, format: Taken): boolean {
  const { document } = studio;
  if (!document) return false;
  if (format === 'task') return true;
  if (!document.result) return false;
  return format !== 'vrma' || document.character.spec.source.toLowerCase().endsWith('.vrm');
}

export async function takeAway(studio: Studio, format: Taken): Promise<{ name: string; bytes: Uint8Array }> {
  const document = studio.document!;
  const body = document.character.spec.source.replace(/\.[^.]*$/, '').replace(/[^\p{L}\p{N}_-]+/gu, '-');
  const encode = (value: unknown): Uint8Array => new TextEncoder().encode(`${JSON.stringify(value, null, 2)}\n`);
  const name = `shigusa-${body}-${document.chosen + 1}`;
  switch (format) {
    case 'task':
      return { name: `shigusa-${body}-task.json`, bytes: encode(completeTask(document)) };
    case 'result':
      return { name: `shigusa-${body}-result.json`, bytes: encode(resultOf(studio)) };
    case 'png':
      return { name: `${name}.png`, bytes: await pngOf(await studio.exported('svg')) };
    case 'glb': {
      const bytes = document.character.bytes && /\.(glb|gltf|vrm)$/i.test(document.character.spec.source)
        ? await studio.exported('glb')
        : await (await import('../view/drawn_glb')).drawnGlb(document.character, await studio.sampledNodes());
      return { name: `${name}.glb`, bytes };
    }
    default:
      return { name: `${name}.${format}`, bytes: await studio.exported(format) };
  }
}

/** The result with what was edited in the place of what was found. */
function resultOf(studio: Studio): unknown {
  const document = studio.document!;
  const { summary } = document.result!;
  const candidates = summary.candidates.map((candidate, index) => {
    const edited = document.edits[index]?.generated.summary.candidates[0];
    return edited ? { ...edited, rank: index + 1 } : candidate;
  });
  return { ...summary, candidates };
}

const kPngWidth = 1600; // px

async function pngOf(svg: Uint8Array): Promise<Uint8Array> {
  const url = URL.createObjectURL(new Blob([svg as BlobPart], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = globalThis.document.createElement('canvas');
    canvas.width = kPngWidth;
    canvas.height = Math.round((kPngWidth * image.naturalHeight) / image.naturalWidth);
    canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
    const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'));
    if (!blob) throw new Error('the picture could not be made');
    return new Uint8Array(await blob.arrayBuffer());
  } finally {
    URL.revokeObjectURL(url);
  }
}

export function save(name: string, bytes: Uint8Array): void {
  const type = kTypes[name.split('.').pop() as Taken] ?? 'application/octet-stream';
  const url = URL.createObjectURL(new Blob([bytes as BlobPart], { type }));
  const anchor = globalThis.document.createElement('a');
  anchor.href = url;
  anchor.download = name;
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

export function link(studio: Studio): string {
  return linkOf(studio.document!, location.href);
}
