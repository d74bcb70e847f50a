// SPDX-License-Identifier: MIT
// Ghosts: pale figures at moments of a motion, from its begin to its end. Each shares the figure's meshes and has bones of
// its own, which are turned once per motion; between two pictures of a motion that plays nothing is computed.
import { Group, LessEqualDepth, type Material, Mesh, MeshLambertMaterial, type MeshStandardMaterial, type Object3D, SkinnedMesh } from 'three';
import { clone } from 'three/addons/utils/SkeletonUtils.js';
import type { Candidate } from '../../../bindings/wasm/src/types';
import { type Figure, poseFigure } from './figures';
import type { Palette } from './palette';

const kFaintest = 0.16; // opacity of the first
const kStrongest = 0.44; // and of the last
const kGlow = 0.4; // of their colour, so that their shaded sides do not darken the figure behind them
/** Ghosts are seen through, so they come after what is opaque, each mesh first as depth alone: of a body that is seen
 *  through only the nearest surface shall show. */
const kDepthOrder = 1;
const kColourOrder = 2;

interface Ghost {
  object: Object3D;
  nodes: (Object3D | undefined)[];
  pairs: [from: Object3D, to: Object3D][]; // of the figure's bones
  materials: MeshLambertMaterial[]; // seen
  hidden: MeshLambertMaterial[]; // of depth alone
}

/** Moments of `count` ghosts as shares of the motion's time. One ghost stands where the motion begins. */
export function momentsOf(count: number): number[] {
  return Array.from({ length: count }, (_, k) => (count > 1 ? k / (count - 1) : 0));
}

export class Ghosts {
  readonly object = new Group();
  private figure: Figure | null = null;
  private ghosts: Ghost[] = [];
  private posed: Candidate | null = null;
  private palette: Palette | null = null;

  /** Of which figure; its ghosts must go before it is disposed of. */
  setFigure(figure: Figure | null): void {
    this.keep(0);
    this.figure = figure;
  }

  paint(palette: Palette): void {
    this.palette = palette;
    for (const ghost of this.ghosts) for (const material of ghost.materials) colour(material, palette);
  }

  show(candidate: Candidate | null, count: number): void {
    this.object.visible = candidate !== null;
    const { figure } = this;
    if (!candidate || !figure) return this.keep(0);
    if (this.posed === candidate && this.ghosts.length === count) return;
    this.keep(count);
    while (this.ghosts.length < count) this.ghosts.push(this.makeGhost(figure));
    momentsOf(count).forEach((share, k) => {
      const ghost = this.ghosts[k]!;
      poseFigure(figure, candidate, share * candidate.summary.duration_s);
      for (const [from, to] of ghost.pairs) {
        to.position.copy(from.position);
        to.quaternion.copy(from.quaternion);
      }
      for (const material of ghost.materials) material.opacity = kFaintest + (kStrongest - kFaintest) * (count > 1 ? share : 1);
    });
    this.posed = candidate;
  }

  /** Where a node of each ghost is, m. */
  placesOf(node: number): [number, number, number][] {
    this.object.updateMatrixWorld(true);
    return this.ghosts.flatMap(({ nodes }) => {
      const elements = nodes[node]?.matrixWorld.elements;
      return elements ? [[elements[12], elements[13], elements[14]] as [number, number, number]] : [];
    });
  }

  /** Only the first `count` stay. */
  private keep(count: number): void {
    for (const ghost of this.ghosts.splice(count)) {
      ghost.object.removeFromParent();
      ghost.object.traverse((item) => {
        if (item instanceof SkinnedMesh) item.skeleton.dispose();
      });
      for (const material of [...ghost.materials, ...ghost.hidden]) material.dispose();
    }
    this.posed = null;
  }

  private makeGhost(figure: Figure): Ghost {
    const object = clone(figure.object);
    object.position.set(0, 0, 0);
    object.visible = true;
    const copies = new Map<Object3D, Object3D>();
    pair(figure.object, object, copies);
    const pairs = [...figure.nodes, ...(figure.others ?? [])].flatMap((from): Ghost['pairs'] => (from ? [[from, copies.get(from)!]] : []));
    const ghost: Ghost = { object, nodes: figure.nodes.map((node) => node && copies.get(node)), pairs, materials: [], hidden: [] };
    const meshes: Mesh[] = [];
    object.traverse((item) => {
      if (item instanceof Mesh) meshes.push(item);
    });
    const made = new Map<Material, [MeshLambertMaterial, MeshLambertMaterial]>();
    for (const mesh of meshes) this.veil(mesh, ghost, made);
    this.object.add(object);
    return ghost;
  }

  /** Gives a mesh a ghost's look and, below it, its depth. */
  private veil(mesh: Mesh, ghost: Ghost, made: Map<Material, [MeshLambertMaterial, MeshLambertMaterial]>): void {
    const looks = [mesh.material].flat().map((source) => {
      const known = made.get(source);
      if (known) return known;
      const materials = this.makeMaterials(source);
      made.set(source, materials);
      ghost.materials.push(materials[0]);
      ghost.hidden.push(materials[1]);
      return materials;
    });
    const several = Array.isArray(mesh.material);
    const [seen, hidden] = [0, 1].map((which) => (several ? looks.map((look) => look[which]!) : looks[0]![which]!));
    const depth = mesh instanceof SkinnedMesh ? new SkinnedMesh(mesh.geometry, hidden) : new Mesh(mesh.geometry, hidden);
    if (mesh instanceof SkinnedMesh) (depth as SkinnedMesh).bind(mesh.skeleton, mesh.bindMatrix);
    depth.morphTargetInfluences = mesh.morphTargetInfluences;
    depth.morphTargetDictionary = mesh.morphTargetDictionary;
    depth.frustumCulled = mesh.frustumCulled = false;
    depth.renderOrder = kDepthOrder;
    mesh.renderOrder = kColourOrder;
    mesh.castShadow = mesh.receiveShadow = false;
    mesh.material = seen!;
    mesh.add(depth);
  }

  private makeMaterials(source: Material): [MeshLambertMaterial, MeshLambertMaterial] {
    // the figure itself wins where a ghost's foot stands in its own
    const look = { transparent: true, depthFunc: LessEqualDepth, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 8, side: source.side };
    const seen = new MeshLambertMaterial({ ...look, depthWrite: false });
    const hidden = new MeshLambertMaterial({ ...look, colorWrite: false });
    const cut = source.transparent || source.alphaTest > 0; // hair, lashes
    const map = cut ? (source as MeshStandardMaterial).map : null;
    if (map) {
      seen.map = hidden.map = map;
      seen.alphaTest = hidden.alphaTest = 0.5 * kFaintest;
    }
    if (this.palette) colour(seen, this.palette);
    return [seen, hidden];
  }
}

function colour(material: MeshLambertMaterial, { ghost }: Palette): void {
  material.color = ghost;
  material.emissive.copy(ghost).multiplyScalar(kGlow);
}

/** The copy of each object below two that are alike. */
function pair(from: Object3D, to: Object3D, copies: Map<Object3D, Object3D>): void {
  copies.set(from, to);
  from.children.forEach((child, k) => pair(child, to.children[k]!, copies));
}
