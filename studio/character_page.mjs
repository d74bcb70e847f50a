// SPDX-License-Identifier: MIT
// The page on which character_pictures.mjs draws.
import {
  AmbientLight, AnimationMixer, Box3, BufferAttribute, Color, DirectionalLight, GridHelper, Group, Mesh, MeshLambertMaterial, OrthographicCamera,
  Scene, SphereGeometry, Vector3, WebGLRenderer,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const kCell = 400; // px
const kTitle = 28; // px
const kMargin = 1.08;
const kMoments = { start: 0, 'a third': 1 / 3, 'two thirds': 2 / 3, end: 1 };
const kViews = { front: [0, 0.1, 1], 'from the right': [-1, 0.1, 0], 'three quarters': [-0.75, 0.35, 1] };
const kColors = ['#d8d4cc', '#e2a04a', '#5f9fd0']; // of the body, its left and its right arm

const renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
renderer.setSize(kCell, kCell);

/** A picture of a motion as a data URL; null where there is no mesh. */
window.draw = async ({ title, animation, unit_m, goals_m, arms }) => {
  const gltf = await new GLTFLoader().loadAsync('/glb');
  const clip = gltf.animations.findLast(({ name }) => name === animation);
  const armNodes = await Promise.all(arms.map((nodes) => Promise.all(nodes.map((i) => gltf.parser.getDependency('node', i)))));
  gltf.scene.traverse((part) => part.isMesh && paint(part, armNodes));
  const scene = new Scene();
  scene.background = new Color('#f4f4f2');
  const figure = new Group().add(gltf.scene);
  figure.scale.setScalar(unit_m);
  const sun = new DirectionalLight('white', 2.2);
  scene.add(figure, new GridHelper(6, 24, '#b8b8b0', '#d6d6d0'), new AmbientLight('white', 0.9), sun);
  for (const goal of goals_m) {
    const ball = new Mesh(new SphereGeometry(0.03), new MeshLambertMaterial({ color: '#d03030' }));
    ball.position.fromArray(goal);
    scene.add(ball);
  }
  const mixer = new AnimationMixer(gltf.scene);
  mixer.clipAction(clip).play();
  const at = (share) => {
    mixer.setTime(share * clip.duration * (1 - 1e-6));
    scene.updateMatrixWorld(true);
  };
  const box = new Box3();
  for (const share of Object.values(kMoments)) {
    at(share);
    gltf.scene.traverse((part) => part.isMesh && box.expandByObject(part, true));
  }
  if (box.isEmpty()) return null;
  for (const goal of goals_m) box.expandByPoint(new Vector3(...goal));

  const sheet = document.createElement('canvas');
  [sheet.width, sheet.height] = [kCell * Object.keys(kMoments).length, kTitle + kCell * Object.keys(kViews).length];
  const pen = sheet.getContext('2d');
  pen.fillStyle = 'white';
  pen.fillRect(0, 0, sheet.width, sheet.height);
  pen.fillStyle = 'black';
  pen.font = '16px sans-serif';
  pen.fillText(title, 8, 19);
  Object.entries(kMoments).forEach(([moment, share], column) => {
    at(share);
    Object.entries(kViews).forEach(([view, from], row) => {
      const camera = cameraFor(box, new Vector3(...from).normalize());
      sun.position.copy(camera.position).add(new Vector3(-1, 3, 1));
      renderer.render(scene, camera);
      pen.drawImage(renderer.domElement, column * kCell, kTitle + row * kCell);
      pen.fillText(`${view}, ${moment}`, column * kCell + 8, kTitle + row * kCell + 20);
    });
  });
  return sheet.toDataURL('image/png');
};

/** One neutral material, the arms in colours of their own. */
function paint(part, armNodes) {
  const armOf = (node) => node && (armNodes.findIndex((nodes) => nodes.includes(node)) + 1 || armOf(node.parent) || 0);
  const { position, normal, skinIndex, skinWeight } = part.geometry.attributes;
  const joints = part.isSkinnedMesh ? part.skeleton.bones : [part];
  const colors = kColors.map((color) => new Color(color));
  const arms = joints.map((joint) => armOf(joint) || 0);
  const colored = new BufferAttribute(new Float32Array(3 * position.count), 3);
  for (let i = 0; i < position.count; ++i) {
    const weights = part.isSkinnedMesh ? [0, 1, 2, 3].map((k) => skinWeight.getComponent(i, k)) : [];
    const color = colors[arms[part.isSkinnedMesh ? skinIndex.getComponent(i, weights.indexOf(Math.max(...weights))) : 0]];
    colored.setXYZ(i, color.r, color.g, color.b);
  }
  part.geometry = part.geometry.clone().setAttribute('color', colored);
  if (!normal) part.geometry.computeVertexNormals();
  part.material = new MeshLambertMaterial({ vertexColors: true, side: 2 });
  part.frustumCulled = false;
}

/** From a side, so that all of a box is seen. */
function cameraFor(box, from) {
  const [middle, size] = [box.getCenter(new Vector3()), box.getSize(new Vector3())];
  const camera = new OrthographicCamera(-1, 1, 1, -1, 0.01, 100);
  camera.position.copy(middle).addScaledVector(from, 20);
  camera.lookAt(middle);
  camera.updateMatrixWorld(true);
  let half = 0;
  for (let corner = 0; corner < 8; ++corner) {
    const sign = [0, 1, 2].map((k) => ((corner >> k) & 1) - 0.5);
    const seen = new Vector3(...sign).multiply(size).add(middle).applyMatrix4(camera.matrixWorldInverse);
    half = Math.max(half, Math.abs(seen.x), Math.abs(seen.y));
  }
  Object.assign(camera, { left: -kMargin * half, right: kMargin * half, top: kMargin * half, bottom: -kMargin * half });
  camera.updateProjectionMatrix();
  return camera;
}
