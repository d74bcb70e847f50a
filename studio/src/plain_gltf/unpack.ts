// SPDX-License-Identifier: MIT
// Rewrites a glTF file with packed meshes as a GLB with plain ones, which any reader knows.
import { fetchPart } from '../offline/part';
import { type Accessor, type BufferView, type Gltf, type Primitive, readContainer, writeGlb } from './container';
import type { DracoMesh } from './draco';
import { kDraco, kMeshopt, PackedError } from './packed';

type Buffers = readonly (Uint8Array | undefined)[];

const kComponents: Record<number, number> = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 }; // bytes
const kTypes: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
const kVertices = 34962;
const kCorners = 34963;
const kTriangles = new Set([undefined, 4, 5]); // modes that Draco packs

/** Bytes of an accessor's values in one piece. */
export function sizeOf({ componentType, type, count }: Accessor): number {
  return count * (kTypes[type] ?? NaN) * (kComponents[componentType] ?? NaN);
}

function item<Item>(list: readonly (Item | undefined)[] | undefined, index: unknown): Item {
  const found = typeof index === 'number' ? list?.[index] : undefined;
  if (found === undefined) throw new PackedError(`nothing has index ${String(index)}`);
  return found;
}

function bufferOf(uri: string | undefined): Uint8Array | undefined {
  const text = /^data:[^,]*;base64,(.*)$/s.exec(uri ?? '')?.[1];
  return text === undefined ? undefined : Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}

/** Of a view, or of what a packed one names. */
function sliceOf(buffers: Buffers, { buffer, byteOffset = 0, byteLength }: BufferView): Uint8Array {
  const bytes = item(buffers, buffer);
  if (!(byteOffset >= 0 && byteLength >= 0 && byteOffset + byteLength <= bytes.length)) throw new PackedError('a part lies outside its buffer');
  return bytes.subarray(byteOffset, byteOffset + byteLength);
}

/** Counts bytes before they are taken. */
class Budget {
  constructor(private left: number) {}

  take(bytes: number): void {
    this.left -= bytes;
    if (!(bytes >= 0 && this.left >= 0)) throw new PackedError('the file declares more than fits');
  }
}

async function plainViews(json: Gltf, buffers: Buffers, budget: Budget): Promise<Uint8Array[]> {
  const parts: Uint8Array[] = [];
  for (const view of json.bufferViews ?? []) {
    const name = kMeshopt.find((each) => view.extensions?.[each] !== undefined);
    budget.take(view.byteLength);
    if (name === undefined) {
      parts.push(sliceOf(buffers, view));
      continue;
    }
    const { unpackMeshopt } = await fetchPart(() => import('./meshopt'));
    parts.push(await unpackMeshopt(view, view.extensions![name], (packed) => sliceOf(buffers, packed)));
    delete view.extensions![name];
  }
  return parts;
}

function spread(bytes: Uint8Array, each: number, stride: number): Uint8Array {
  const out = new Uint8Array((bytes.length / each) * stride);
  for (let from = 0, to = 0; from < bytes.length; from += each, to += stride) out.set(bytes.subarray(from, from + each), to);
  return out;
}

/** Gives an accessor values of its own. The place of a packed view goes to the first, so that nothing packed stays. */
class Values {
  private readonly taken = new Set<number>();

  constructor(private readonly json: Gltf, private readonly parts: Uint8Array[]) {}

  put(accessor: Accessor, bytes: Uint8Array, target: number, free: number): void {
    const view = this.taken.has(free) ? this.parts.length : free;
    this.taken.add(view);
    const each = bytes.length / accessor.count;
    const byteStride = (each + 3) & ~3; // of vertices a multiple of four
    const spaced = target === kVertices && byteStride !== each;
    this.parts[view] = spaced ? spread(bytes, each, byteStride) : bytes;
    this.json.bufferViews![view] = { buffer: 0, byteLength: this.parts[view].length, target, ...(spaced && { byteStride }) };
    accessor.bufferView = view;
    delete accessor.byteOffset;
    delete accessor.sparse;
  }
}

async function plainPrimitives(json: Gltf, parts: Uint8Array[], budget: Budget): Promise<void> {
  const values = new Values(json, parts);
  const packed = [...parts];
  for (const primitive of (json.meshes ?? []).flatMap(({ primitives }) => primitives)) {
    const told = primitive.extensions?.[kDraco] as DracoMesh | undefined;
    if (told === undefined) continue;
    await plainPrimitive(json, primitive, told, item(packed, told.bufferView), values, budget);
    delete primitive.extensions![kDraco];
  }
}

async function plainPrimitive(json: Gltf, primitive: Primitive, told: DracoMesh, bytes: Uint8Array, values: Values, budget: Budget): Promise<void> {
  if (!kTriangles.has(primitive.mode)) throw new PackedError(`Draco packs no primitives of mode ${primitive.mode}`);
  const attributes = Object.entries(told.attributes ?? {}).map(([name, id]) => ({ id, accessor: item(json.accessors, primitive.attributes[name]) }));
  const indices = item(json.accessors, primitive.indices);
  for (const accessor of [...attributes.map((attribute) => attribute.accessor), indices]) budget.take(sizeOf(accessor));
  const { unpackDraco } = await fetchPart(() => import('./draco'));
  const { corners, columns } = await unpackDraco(bytes, attributes, indices);
  columns.forEach((column, k) => values.put(attributes[k]!.accessor, column, kVertices, told.bufferView));
  values.put(indices, corners, kCorners, told.bufferView);
  if (primitive.mode !== undefined) primitive.mode = 4; // strips come as triangles
}

function withoutExtensions(json: Gltf): void {
  for (const list of ['extensionsUsed', 'extensionsRequired'] as const) {
    const left = json[list]?.filter((name) => name !== kDraco && !kMeshopt.some((packed) => packed === name)) ?? [];
    if (left.length > 0) json[list] = left;
    else delete json[list];
  }
}

/** The same file unpacked. Throws a PackedError where it is damaged or would take more than `most` bytes. */
export async function unpacked(bytes: Uint8Array, most: number): Promise<Uint8Array> {
  try {
    const { json, binary } = readContainer(bytes);
    const buffers = (json.buffers ?? []).map(({ uri }, index) => (index === 0 && uri === undefined ? binary : bufferOf(uri)));
    const budget = new Budget(most);
    const parts = await plainViews(json, buffers, budget);
    await plainPrimitives(json, parts, budget);
    let byteOffset = 0;
    json.bufferViews?.forEach((view, index) => {
      Object.assign(view, { buffer: 0, byteOffset, byteLength: parts[index]!.length });
      byteOffset += (parts[index]!.length + 3) & ~3;
    });
    json.buffers = [{ byteLength: byteOffset }];
    withoutExtensions(json);
    return writeGlb(json, parts);
  } catch (error) {
    if (error instanceof PackedError) throw error;
    throw new PackedError(String(error));
  }
}
