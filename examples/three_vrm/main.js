// SPDX-License-Identifier: MIT
// A VRM in three.js reaches for a ball: shigusa makes the motion, three-vrm plays it.
import {
  AnimationMixer, Clock, Color, DirectionalLight, GridHelper, HemisphereLight, LoopOnce, Mesh, MeshStandardMaterial,
  PerspectiveCamera, Scene, SphereGeometry, Vector3, WebGLRenderer,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { VRMLoaderPlugin, VRMUtils } from '@pixiv/three-vrm';
import { createVRMAnimationClip, VRMAnimationLoaderPlugin } from '@pixiv/three-vrm-animation';
import { createEngine } from 'shigusa';

const said = document.querySelector('#said');
const renderer = new WebGLRenderer({ antialias: true });
renderer.setSize(innerWidth, innerHeight);
document.body.append(renderer.domElement);
const camera = new PerspectiveCamera(35, innerWidth / innerHeight, 0.1, 20);
camera.position.set(-2.2, 1.3, 3.2);
camera.lookAt(0, 0.8, 0);
const scene = new Scene();
scene.background = new Color('#e8eef4');
scene.add(new HemisphereLight('#fff', '#889', 2), new DirectionalLight('#fff', 2), new GridHelper(4, 8));
const ball = new Mesh(new SphereGeometry(0.04), new MeshStandardMaterial({ color: '#c33' }));
scene.add(ball);

const loader = new GLTFLoader();
loader.register((parser) => new VRMLoaderPlugin(parser));
loader.register((parser) => new VRMAnimationLoaderPlugin(parser));
const engine = await createEngine(); // one for the whole life of the page

async function reach(bytes) {
  said.textContent = 'Thinking …';
  const character = await engine.open({ source: 'model.vrm' }, new Uint8Array(bytes));
  const height = character.description.stature_m;
  ball.position.set(-0.15 * height, 0.3 * height, 0.3 * height); // its left is +X, and it faces +Z
  const task = { goals: [{ effector: 'right_hand', position_m: ball.position.toArray() }], seed: 1 };
  const { summary, candidates: [best] } = await engine.generate(character, task);
  const file = await engine.export(character, summary, 1, 'vrma');
  engine.close(character);

  const { userData: { vrm } } = await loader.parseAsync(bytes, '');
  const { userData: { vrmAnimations } } = await loader.parseAsync(file.buffer, '');
  VRMUtils.rotateVRM0(vrm);
  scene.add(vrm.scene);
  const mixer = new AnimationMixer(vrm.scene);
  const action = mixer.clipAction(createVRMAnimationClip(vrmAnimations[0], vrm));
  action.setLoop(LoopOnce).play().clampWhenFinished = true;
  const words = `${best.summary.verdict}: ${best.summary.final_posture.words}`;
  mixer.addEventListener('finished', () => {
    const wrist = vrm.humanoid.getRawBoneNode('rightHand').getWorldPosition(new Vector3());
    said.textContent = `${words}; the wrist is ${(100 * wrist.distanceTo(ball.position)).toFixed(0)} cm from the ball`;
  });
  said.textContent = words;
  const clock = new Clock();
  renderer.setAnimationLoop(() => {
    const seconds = clock.getDelta();
    mixer.update(seconds);
    vrm.update(seconds);
    renderer.render(scene, camera);
  });
}

const fail = (error) => { said.textContent = error.message; };
document.querySelector('#file').addEventListener('change', ({ target }) => target.files[0].arrayBuffer().then(reach).catch(fail));
const model = new URLSearchParams(location.search).get('model');
if (model !== null) await fetch(model).then((response) => response.arrayBuffer()).then(reach).catch(fail);
