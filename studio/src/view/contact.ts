// SPDX-License-Identifier: MIT
// The contact shadow: how near to the floor things are, seen from below it, blurred and laid on the floor. Feet so stand on
// it, whatever the light does.
import {
  Mesh, MeshDepthMaterial, LinearMipmapLinearFilter, OrthographicCamera, PlaneGeometry, type Scene, ShaderMaterial, type Texture, WebGLRenderTarget,
  type WebGLRenderer,
} from 'three';
import { FullScreenQuad } from 'three/addons/postprocessing/Pass.js';

const kHalf = 1.2; // m of floor to each side of the middle
const kHigh = 0.22; // m above the floor where no shadow is left
const kDrawn = 256; // px of the picture from below
const kBlurred = 128; // and of its blur
const kStrength = 0.62; // of a shadow right at the floor

const wholePicture = `
varying vec2 at;
void main() {
  at = uv;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

/** Nearness falls with the square, so that a calf leaves next to nothing. */
const blur = `
uniform sampler2D near;
varying vec2 at;
void main() {
  float sum = 0.0;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      float share = (x == 0 ? 0.5 : 0.25) * (y == 0 ? 0.5 : 0.25);
      float high = textureLod(near, at + vec2(x, y) * ${(1.6 / kBlurred).toFixed(6)}, 1.5).r;
      sum += share * high * high;
    }
  }
  gl_FragColor = vec4(sum);
}`;

const onFloor = `
varying vec2 at;
void main() {
  at = vec2(position.x, position.z) / ${(2 * kHalf).toFixed(3)} + 0.5;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const shade = `
uniform sampler2D blurred;
varying vec2 at;
void main() {
  gl_FragColor = vec4(0.0, 0.0, 0.0, ${kStrength.toFixed(3)} * texture2D(blurred, at).r);
}`;

export class ContactShadow {
  readonly object: Mesh;
  private readonly camera = new OrthographicCamera(-kHalf, kHalf, kHalf, -kHalf, 0, kHigh);
  private readonly drawn = new WebGLRenderTarget(kDrawn, kDrawn, { generateMipmaps: true, minFilter: LinearMipmapLinearFilter });
  private readonly blurred = new WebGLRenderTarget(kBlurred, kBlurred, { depthBuffer: false });
  private readonly nearness = new MeshDepthMaterial();
  private readonly pass: FullScreenQuad;
  private readonly material: ShaderMaterial;

  constructor() {
    this.camera.rotation.x = Math.PI / 2; // from the floor upwards
    this.camera.updateMatrixWorld();
    const uniform = (value: Texture): { value: Texture } => ({ value });
    this.pass = new FullScreenQuad(new ShaderMaterial({
      vertexShader: wholePicture, fragmentShader: blur, depthTest: false, depthWrite: false, uniforms: { near: uniform(this.drawn.texture) },
    }));
    this.material = new ShaderMaterial({
      vertexShader: onFloor, fragmentShader: shade, transparent: true, depthWrite: false, uniforms: { blurred: uniform(this.blurred.texture) },
    });
    this.object = new Mesh(new PlaneGeometry(2 * kHalf, 2 * kHalf).rotateX(-Math.PI / 2), this.material);
    this.object.position.y = 0.002;
    this.object.renderOrder = -1;
  }

  /** Anew, of all that is in `casters`. */
  update(renderer: WebGLRenderer, casters: Scene): void {
    const target = renderer.getRenderTarget();
    casters.overrideMaterial = this.nearness;
    renderer.setRenderTarget(this.drawn);
    renderer.render(casters, this.camera);
    casters.overrideMaterial = null;
    renderer.setRenderTarget(this.blurred);
    this.pass.render(renderer);
    renderer.setRenderTarget(target);
  }

  /** What it adds to the floor at its darkest, 0 to 1; for tests. */
  darkest(renderer: WebGLRenderer): number {
    const bytes = new Uint8Array(4 * kBlurred * kBlurred);
    renderer.readRenderTargetPixels(this.blurred, 0, 0, kBlurred, kBlurred, bytes);
    return (kStrength * bytes.reduce((most, byte) => Math.max(most, byte), 0)) / 255;
  }

  dispose(): void {
    this.drawn.dispose();
    this.blurred.dispose();
    this.nearness.dispose();
    this.material.dispose();
    this.pass.dispose();
  }
}
