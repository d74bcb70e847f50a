// SPDX-License-Identifier: MIT
// The light: a key from the front right with a soft shadow, a rim from behind, light from all around, and the contact shadow.
// Shadows are drawn anew where something has moved, not where the camera has.
import { DirectionalLight, Group, HemisphereLight, PCFShadowMap, type Scene, type WebGLRenderer } from 'three';
import { ContactShadow } from './contact';
import type { Palette } from './palette';
import type { Quality } from './quality';

const kSide = 4; // m that the shadow's map is wide and high
const kPenumbra = 0.021; // m to each side of a shadow's edge

export class Light {
  readonly object = new Group();
  private readonly key = new DirectionalLight(0xffffff, 2);
  private readonly rim = new DirectionalLight(0xffffff, 0.8);
  private readonly around = new HemisphereLight(0xffffff, 0x888888, 1);
  private readonly contact = new ContactShadow();
  private stale = true;

  constructor(private readonly renderer: WebGLRenderer, private readonly casters: Scene, quality: Quality) {
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = PCFShadowMap;
    renderer.shadowMap.autoUpdate = false;
    this.key.position.set(-2.2, 4.2, 2.8);
    this.key.castShadow = true;
    this.key.shadow.bias = -0.0002;
    this.key.shadow.normalBias = 0.02;
    const box = this.key.shadow.camera;
    box.left = box.bottom = -kSide / 2;
    box.right = box.top = kSide / 2;
    box.near = 0.5;
    box.far = 10;
    this.rim.position.set(2.5, 2.5, -3);
    this.object.add(this.key, this.rim, this.around, this.contact.object);
    this.setQuality(quality);
  }

  paint(palette: Palette): void {
    this.key.intensity = palette.light;
    this.rim.intensity = palette.rim;
    this.around.color = palette.sky;
    this.around.groundColor = palette.ground;
    this.around.intensity = palette.ambient;
    this.stale = true;
  }

  /** A shadow of fewer pixels is as soft. */
  setQuality({ shadow: pixels }: Quality): void {
    const { shadow } = this.key;
    if (shadow.map && shadow.mapSize.width === pixels) return;
    shadow.mapSize.set(pixels, pixels);
    shadow.radius = (kPenumbra * pixels) / kSide;
    shadow.map?.dispose();
    shadow.map = null;
    this.stale = true;
  }

  /** Something that casts a shadow has moved, or the graphics card has forgotten all. */
  invalidate(): void {
    this.stale = true;
  }

  /** Before a picture. */
  update(): void {
    if (!this.stale) return;
    this.stale = false;
    this.contact.update(this.renderer, this.casters);
    this.renderer.shadowMap.needsUpdate = true;
  }

  get contactDarkness(): number {
    return this.contact.darkest(this.renderer);
  }

  dispose(): void {
    this.contact.dispose();
    this.key.shadow.dispose();
  }
}
