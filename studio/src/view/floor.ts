// SPDX-License-Identifier: MIT
// The floor: a disc that fades into the page, lines each half metre, and a plane that takes the shadow.
import { CircleGeometry, Group, Mesh, ShaderMaterial, ShadowMaterial } from 'three';
import type { Palette } from './palette';

const kRadius = 5; // m

const vertexShader = `
varying vec2 place;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  place = world.xz;
  gl_Position = projectionMatrix * viewMatrix * world;
}`;

const fragmentShader = `
uniform vec3 floorColor;
uniform vec3 gridColor;
varying vec2 place;
float lines(vec2 p, float step, float width) {
  vec2 away = abs(fract(p / step - 0.5) - 0.5) * step;
  vec2 blur = fwidth(p) * 0.75;
  vec2 line = 1.0 - smoothstep(vec2(width), vec2(width) + blur, away);
  return max(line.x, line.y);
}
void main() {
  float far = length(place);
  float fade = 1.0 - smoothstep(1.2, ${kRadius.toFixed(1)}, far);
  float grid = max(lines(place, 0.5, 0.002) * 0.22, lines(place, 1.0, 0.003) * 0.38);
  grid *= 1.0 - smoothstep(0.8, 3.6, far);
  gl_FragColor = vec4(mix(floorColor, gridColor, grid), fade * 0.9);
  #include <colorspace_fragment>
}`;

export class Floor {
  readonly object = new Group();
  private readonly ground: Mesh;
  private readonly surface: ShaderMaterial;
  private readonly shade = new ShadowMaterial({ transparent: true });

  constructor() {
    const disc = new CircleGeometry(kRadius, 64);
    disc.rotateX(-Math.PI / 2);
    this.surface = new ShaderMaterial({
      vertexShader,
      fragmentShader,
      transparent: true,
      depthWrite: false,
      uniforms: { floorColor: { value: null }, gridColor: { value: null } },
    });
    this.ground = new Mesh(disc, this.surface);
    this.ground.renderOrder = -2;
    const shadow = new Mesh(disc, this.shade);
    shadow.receiveShadow = true;
    shadow.position.y = 0.001;
    shadow.renderOrder = -1;
    this.object.add(this.ground, shadow);
  }

  /** Without it shadows stay. */
  showSurface(shown: boolean): void {
    this.ground.visible = shown;
  }

  paint(palette: Palette): void {
    this.surface.uniforms['floorColor']!.value = palette.floor;
    this.surface.uniforms['gridColor']!.value = palette.grid;
    this.shade.opacity = palette.shadow;
  }
}
