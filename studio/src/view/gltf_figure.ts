// SPDX-License-Identifier: MIT
// A character drawn with the mesh of its own glTF or VRM file.
import { Box3, Group, LoadingManager, type Material, Mesh, MeshStandardMaterial, type Object3D, TextureLoader, Vector3 } from 'three';
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { Character } from '../../../bindings/wasm/src/types';
import { readContainer } from '../plain_gltf/container';
import type { Figure } from './mannequin';
import { worldMatrix } from './pose';

/** Fetches nothing outside the file: references to other files are refused. */
function innerFilesOnly(): LoadingManager {
  const manager = new LoadingManager();
  manager.setURLModifier((url) => (/^(blob:|data:)/.test(url) ? url : 'data:,'));
  return manager;
}

/** What a data: address holds, for a loader of three. */
function loadData(url: string, onLoad: (data: ArrayBuffer) => void, _onProgress: unknown, onError: (error: Error) => void): void {
  const text = /^data:[^,]*;base64,(.*)$/s.exec(url)?.[1];
  if (text === undefined) onError(new Error('the file names another file'));
  else onLoad(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer);
}

/** What the file shows; of one without scenes, as it may be, all of its nodes. */
async function sceneOf({ scene, parser }: GLTF): Promise<Group> {
  if ((scene as Group | undefined) !== undefined) return scene;
  const all = new Group();
  const nodes = (await parser.getDependencies('node')) as Object3D[];
  return all.add(...nodes.filter(({ parent }) => parent === null));
}

/** Null where the file has no mesh. */
export async function makeGltfFigure(character: Character): Promise<Figure | null> {
  const bytes = character.bytes!;
  if (!readContainer(bytes).json.meshes?.length) return null;
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength) as ArrayBuffer;
  const manager = innerFilesOnly();
  const loader = new GLTFLoader(manager).register((parser) => {
    // by elements and by hand: the page may not connect to anything, not even to blob: and data:
    parser.textureLoader = new TextureLoader(manager);
    (parser as unknown as { fileLoader: object }).fileLoader = { load: loadData };
    return { name: 'inner_files' };
  });
  const gltf = await loader.parseAsync(buffer, '');
  const scene = await sceneOf(gltf);
  const byIndex = new Map<number, Object3D>();
  for (const [item, reference] of gltf.parser.associations) {
    const index = (reference as { nodes?: number } | undefined)?.nodes;
    if (index !== undefined && 'isObject3D' in item) byIndex.set(index, item);
  }
  const root = new Group();
  root.matrixAutoUpdate = false;
  root.matrix.copy(worldMatrix(character.description));
  root.add(scene);
  const object = new Group();
  object.add(root);
  scene.traverse((item) => {
    if (!(item instanceof Mesh)) return;
    item.castShadow = true;
    item.receiveShadow = true;
    item.frustumCulled = false;
    item.material = Array.isArray(item.material) ? item.material.map(lit) : lit(item.material as Material);
  });
  const nodes = character.description.nodes.map(({ file_node, scale = [1, 1, 1] }) => {
    const node = file_node === undefined ? undefined : byIndex.get(file_node);
    node?.scale.set(...scale); // as it was measured, which may be in a frame of an animation
    return node;
  });
  object.updateMatrixWorld(true);
  const size = new Box3().setFromObject(scene).getSize(new Vector3());
  // how the file lies is not known before it moves, so its longest side counts, but for arms held out
  const height = Math.max(character.description.stature_m, 0.9 * Math.max(size.x, size.y, size.z));
  return { object, nodes, height, skin: new MeshStandardMaterial(), joints: new MeshStandardMaterial() };
}

/** Metal without surroundings to mirror would be black. */
function lit(material: Material): Material {
  if (material instanceof MeshStandardMaterial) material.metalness = Math.min(material.metalness, 0.2);
  return material;
}
