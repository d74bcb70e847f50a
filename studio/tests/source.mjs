// SPDX-License-Identifier: MIT
// The page's sources that need no browser, for tests in Node.
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

/** What these modules of src export, all in one. */
export async function sources(...modules) {
  const { outputFiles: [file] } = await build({
    stdin: { contents: `${modules.map((name) => `export * from './${name}';`).join('\n')} export { Vector3 } from 'three';`, resolveDir: fileURLToPath(new URL('../src/', import.meta.url)), loader: 'ts' },
    bundle: true, format: 'esm', platform: 'node', target: 'node20', write: false, treeShaking: true, loader: { '.wasm': 'empty' }, define: { 'import.meta.env.PROD': 'false' },
  });
  return import(`data:text/javascript;base64,${Buffer.from(file.contents).toString('base64')}`);
}

/** What one module of src exports, by its path. */
export const source = (path) => sources(path.replace(/\.ts$/, ''));

const hand = (name) => ({ effector: name, node: name, start_m: [name.startsWith('left') ? 0.2 : -0.2, 0.8, 0.1] });

/** A document of a body with both hands, for what is computed from goals, things and settings. */
export function documentOf(goals, things = []) {
  const description = {
    name: 'human', stature_m: 1.74, humanoid: {}, support_polygon: [[-0.2, -0.1], [0.2, -0.1], [0.2, 0.2], [-0.2, 0.2]], joints: [], feet: [], effectors: [],
    places: [hand('right_hand'), hand('left_hand')], capsules: [{ name: 'right_hand', radius_m: 0.02 }, { name: 'left_hand', radius_m: 0.02 }],
  };
  return {
    character: { description, spec: { source: 'human' } }, goals, weights: {}, fixed: [], edits: {}, result: null, chosen: 0, compared: null,
    settings: { preset: 'flat', seed: 0, evaluations: null, duration_s: null, more: things.length > 0 ? { obstacles: things } : {} },
  };
}
