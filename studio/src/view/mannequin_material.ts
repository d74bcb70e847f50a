// SPDX-License-Identifier: MIT
// How the mannequin is painted: darker joints and a visor, whose borders are found for each pixel.
import { BufferAttribute, type BufferGeometry, CanvasTexture, Color, MeshStandardMaterial, SRGBColorSpace } from 'three';

const kVisor = 0.16; // of the joints' colour
const kSeam = 0.0055; // m, half of a seam's width

const kBefore = `#include <common>
varying vec3 vPaint;
uniform vec3 jointColor;
`;
const kColor = `#include <color_fragment>
vec2 inside = vec2(max(vPaint.x, ${kSeam} - abs(vPaint.z)), vPaint.y);
vec2 soft = max(0.75 * fwidth(inside), vec2(1e-5));
vec2 paint = smoothstep(-soft, soft, inside);
float line = 1.0 - smoothstep(0.0006, 0.0009 + 1.5 * soft.x, abs(inside.x));
diffuseColor.rgb = mix(diffuseColor.rgb, jointColor, paint.x) * (1.0 - 0.4 * line);
diffuseColor.rgb = mix(diffuseColor.rgb, ${kVisor} * jointColor, paint.y);
`;
const kRough = `#include <roughnessmap_fragment>
roughnessFactor = mix(roughnessFactor, 0.2, paint.y);
`;

/** `joints`: whose colour the joints have at each time. */
export function mannequinMaterial(joints: { color: Color }): MeshStandardMaterial {
  const material = new MeshStandardMaterial({ roughness: 0.55, metalness: 0 });
  material.onBeforeCompile = (shader) => {
    shader.uniforms.jointColor = {
      get value() {
        return joints.color;
      },
    };
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nattribute vec3 paint;\nvarying vec3 vPaint;')
      .replace('#include <begin_vertex>', '#include <begin_vertex>\nvPaint = paint;');
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', kBefore).replace('#include <color_fragment>', kColor).replace('#include <roughnessmap_fragment>', kRough);
  };
  return material;
}

const kSide = 128; // px of the picture
const kReach = 0.0256; // m that the picture takes in on both sides of a border

/** From m past a border to a share of the picture's reach about it. */
const shareOf = (past: number): number => Math.min(Math.max(0.5 + past / (2 * kReach), 0), 1);

/** The same paint as a picture and its coordinates, for files that no shader of ours draws. Joints begin at the picture's middle column;
 *  from its middle row on lie the seams, and up from it the visor, as no place has both. */
export function paintByPicture(geometry: BufferGeometry, material: MeshStandardMaterial, colours: { skin: Color; joints: Color }): void {
  const paint = geometry.getAttribute('paint');
  const uv = new BufferAttribute(new Float32Array(2 * paint.count), 2);
  for (let i = 0; i < paint.count; ++i) uv.setXY(i, shareOf(paint.getX(i)), 0.5 + 0.5 * (shareOf(paint.getZ(i)) - shareOf(paint.getY(i))));
  geometry.setAttribute('uv', uv);
  geometry.deleteAttribute('paint');
  const canvas = document.createElement('canvas');
  canvas.width = kSide;
  canvas.height = 4 * kSide;
  const pen = canvas.getContext('2d')!;
  const fill = (colour: Color, x: number, y: number, high: number): void => {
    pen.fillStyle = `#${colour.getHexString()}`;
    pen.fillRect(x * kSide, y * canvas.height, kSide, high * canvas.height);
  };
  fill(colours.skin, 0, 0, 1);
  fill(colours.joints, 0.5, 0, 1);
  const wide = kSeam / (2 * kReach);
  fill(colours.joints, 0, 0.75 - wide / 2, wide);
  fill(colours.joints.clone().multiplyScalar(kVisor), 0, 0, 0.25);
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  map.flipY = false;
  material.map = map;
  material.color = new Color(0xffffff);
}
