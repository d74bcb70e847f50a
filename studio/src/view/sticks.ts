// SPDX-License-Identifier: MIT
// Any skeleton as rods between its joints: robots, and people without known bones.
import { Group, Mesh, MeshStandardMaterial, Vector3 } from 'three';
import type { CharacterDescription } from '../../../bindings/wasm/src/types';
import type { Figure } from './mannequin';
import { makeNodes } from './pose';
import { ball, capsule } from './shapes';

export function makeSticks(description: CharacterDescription): Figure {
  const object = new Group();
  const { root, nodes } = makeNodes(description);
  object.add(root);
  object.updateMatrixWorld(true);
  const skin = new MeshStandardMaterial({ roughness: 0.55 });
  const joints = new MeshStandardMaterial({ roughness: 0.5 });
  const places = nodes.map((node) => node.getWorldPosition(new Vector3()));
  const thick = 0.021 * description.stature_m;
  const add = (index: number, mesh: Mesh): void => {
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    mesh.frustumCulled = false;
    nodes[index]!.attach(mesh);
  };
  description.nodes.forEach((node, index) => {
    const end = places[index]!;
    if (node.parent < 0) return;
    const start = places[node.parent]!;
    const length = start.distanceTo(end);
    if (length < 0.004 * description.stature_m) return;
    const radius = Math.min(thick, 0.2 * length + 0.004);
    add(node.parent, new Mesh(capsule(start, end, radius), skin));
    add(index, new Mesh(ball(end, radius * 1.2), joints));
  });
  return { object, nodes, height: description.stature_m, skin, joints };
}
