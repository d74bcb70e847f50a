// SPDX-License-Identifier: MIT
// The mannequin from afar: fewer triangles of the same vertices, for shadows and small pictures.
import type { SkinnedMesh, WebGLRenderer } from 'three';
import type { MannequinMesh } from './mannequin_file';

const kCell = 0.03; // m, within which the vertices of a bone are one
const kFineCell = 0.015; // and those of heads, hands and feet, whose shapes are small
const kSmall = 400; // px, high at most: a cell is some three of them there

/** Of the bones of a vertex the one that moves it most. */
function boneOf({ skin, weights }: Pick<MannequinMesh, 'skin' | 'weights'>, vertex: number): number {
  let most = 4 * vertex;
  for (let k = most + 1; k < 4 * vertex + 4; ++k) if (weights[k]! > weights[most]!) most = k;
  return skin[most]!;
}

/** The corners of the triangles that are left where the first vertex in a cell stands for the others there. */
export function coarseCorners(mesh: Omit<MannequinMesh, 'coarse'>): Uint16Array {
  const { corners, positions, bones } = mesh;
  const first = new Map<number, number>(); // by bone and cell
  const standsFor = (vertex: number): number => {
    let cell = boneOf(mesh, vertex);
    const size = bones[cell]!.kind === 'finger' || /hand|head|foot|toes/.test(bones[cell]!.name) ? kFineCell : kCell;
    for (let k = 0; k < 3; ++k) cell = 1024 * cell + 512 + Math.round(positions[3 * vertex + k]! / size);
    if (!first.has(cell)) first.set(cell, vertex);
    return first.get(cell)!;
  };
  const to = Array.from({ length: positions.length / 3 }, (_, vertex) => standsFor(vertex));
  const left: number[] = [];
  for (let t = 0; t < corners.length; t += 3) {
    const [a, b, c] = [to[corners[t]!]!, to[corners[t + 1]!]!, to[corners[t + 2]!]!];
    if (a !== b && b !== c && c !== a) left.push(a, b, c);
  }
  return Uint16Array.from(left);
}

/** Draws the last `coarse` corners of a mesh in shadows and small pictures, and else those before them. */
export function drawCoarseFromAfar(drawn: SkinnedMesh, coarse: number): void {
  const { geometry } = drawn;
  const all = geometry.getIndex()!.count;
  const drawFine = (): void => geometry.setDrawRange(0, all - coarse);
  const drawCoarse = (): void => geometry.setDrawRange(all - coarse, coarse);
  drawn.onBeforeShadow = drawCoarse;
  drawn.onBeforeRender = (renderer: WebGLRenderer) => {
    if ((renderer.getRenderTarget() ?? renderer.domElement).height <= kSmall) drawCoarse();
  };
  drawn.onAfterShadow = drawn.onAfterRender = drawFine;
  drawFine();
}
