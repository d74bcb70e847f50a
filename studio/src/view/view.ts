// SPDX-License-Identifier: MIT
// The three-dimensional view: shows the state, and reports drags.
import { Box3, type Object3D, Vector3 } from 'three';
import type { Candidate, Character, Vec3 } from '../../../bindings/wasm/src/types';
import type { Look } from '../kept/work';
import { fetchPart } from '../offline/part';
import { ranking } from '../state/criteria';
import { candidateAt, type Document, type State } from '../state/model';
import { leastOf, lookName, lookOf, placeOf, thingName, thingsOf } from '../state/places';
import { type Ray, type Snap, snapOf } from '../state/snapping';
import { speedScale } from '../state/speed';
import { effectorsOf, jointsOf } from '../state/start';
import type { Studio } from '../state/studio';
import { t } from '../i18n';
import { directionOf, type Preset } from './camera';
import type { FilmSettings, Scene as FilmScene } from './film';
import { nodeOfReached, undrawnOf } from './drawn_check';
import { disposeFigure, type Figure, makeFigure, poseFigure } from './figures';
import { headReach, placesToSee } from './framing';
import { Ghosts } from './ghosts';
import { GoalMarks } from './goal_marks';
import { type Grip, Handles } from './handles';
import { Obstacles } from './obstacles';
import { Overlays } from './overlays';
import { shownTheme } from './palette';
import { SpeedPath } from './path';
import type { PictureSettings } from './picture';
import { Ruler } from './ruler';
import { SnapMark } from './snap_mark';
import { Stage } from './stage';
import { StrainedJoints } from './strained';
import { type Tag, Tags } from './tags';

const kApproach = 0.75; // statures, from the selected object
const kRoom = 2.4; // times the size of the required contents
const kSmallSide = 112; // px, of a picture in a list
const kTagApart = 0.16; // statures from the middle to the sign of each of two in one place
const kBeside = 0.55; // shares of the stature between two that are compared

/** Of the body's name for a bone the node: of a file by its bone map, a hand for its grip. */
function nodeOfBone({ description }: Character, bone: string): number {
  const named = description.humanoid[bone] ?? description.humanoid[bone.replace(/_grip$/, '')] ?? bone;
  return description.nodes.findIndex((node) => node.name === named);
}

export interface DrawnFigure {
  low: number;
  high: number;
  closed: Record<'left' | 'right', number> | null; // -1 open, 0 relaxed, 1 in a grip; of the mannequin
}

/** All that the picture depends on. What others show, such as the progress of a search, must not take the machine from it. */
const kSeen = ['document', 'preview', 'trial', 'dragging', 'playing', 'selected', 'rings', 'compareMode', 'overlays', 'view', 'theme', 'lengths',
  'language'] as const;

function isSeen(state: State, previous: State): boolean {
  return kSeen.some((key) => state[key] !== previous[key]);
}

export class View {
  readonly stage: Stage;
  private readonly handles: Handles;
  private readonly obstacles = new Obstacles();
  private readonly otherObstacles = new Obstacles();
  private readonly overlays = new Overlays();
  private readonly otherOverlays = new Overlays();
  private readonly strained = new StrainedJoints();
  private readonly marks = new GoalMarks();
  private readonly snapMark = new SnapMark();
  private snapTo: Snap | null = null;
  private readonly ghosts = new Ghosts();
  private readonly ruler = new Ruler();
  private readonly speeds = new SpeedPath();
  private readonly otherSpeeds = new SpeedPath();
  private readonly tags = new Tags();
  private character: Character | null = null;
  private figure: Figure | null = null;
  private other: Figure | null = null;
  private checked: Figure | null = null; // the one that was compared with its motion
  private nodeOf = new Map<string, number>(); // by effector
  private framed: Character | null = null; // whose figure is in the picture
  private sought: Look | null = null; // until it is
  private soughtSide: Preset | null = null;
  private unframed = false; // something may lie outside the picture
  private readonly side = new Vector3(); // from the middle to the chosen one, where two stand beside one another
  private headReach = 0; // m, above its joint
  private listeners = new Set<(figure: Figure | null) => void>();
  private readonly ends: (() => void)[] = [];

  constructor(
    private readonly studio: Studio, host: HTMLElement, canvas: HTMLCanvasElement,
    onHover: (name: string | null, x: number, y: number) => void,
  ) {
    this.stage = new Stage(host, canvas);
    this.handles = new Handles(this.stage, canvas, {
      select: (name) => studio.select(name),
      drag: (name, position, rotation) => void studio.drag(name, position, rotation),
      drop: (name, position, rotation) => void studio.drop(name, position, rotation),
      hover: onHover,
      snap: (name, place, inverted, ray) => this.snapped(name, place, inverted, ray),
      least: (name) => (studio.document ? leastOf(studio.document, name) : 0),
    });
    this.stage.casters.add(this.obstacles.object, this.otherObstacles.object, this.marks.solids);
    const drawn = [
      this.overlays, this.otherOverlays, this.strained, this.marks, this.snapMark, this.handles, this.ghosts, this.ruler, this.speeds, this.otherSpeeds, this.tags,
    ];
    this.stage.scene.add(...drawn.map(({ object }) => object));
    this.stage.onFrame = (seconds) => this.advance(seconds);
    this.stage.onDraw = () => this.pose();
    this.stage.onLost = (pictureLost) => studio.showLost(pictureLost);
    this.stage.isAwaited = () => !this.figure || (!studio.document?.result && studio.store.state.search !== null);
    studio.eye = this;
    this.ends.push(
      studio.store.subscribe((state, previous) => isSeen(state, previous) && this.changed(state, previous)),
      studio.clock.subscribe(() => this.stage.invalidate()),
    );
    this.stage.setLens(studio.store.state.view);
    this.paint();
    this.changed(studio.store.state, studio.store.state);
    if (studio.firstLook) this.lookFrom(studio.firstLook);
  }

  /** Colours of the theme that is on. */
  paint(): void {
    const { theme } = this.studio.store.state;
    this.stage.paint(shownTheme(theme));
    this.overlays.paint(this.stage.palette);
    this.otherOverlays.paint({ ...this.stage.palette, path: this.stage.palette.comparedPath, support: this.stage.palette.compared });
    this.strained.paint(this.stage.palette);
    this.marks.paint(this.stage.palette);
    this.snapMark.paint(this.stage.palette);
    this.marks.show(this.studio.document);
    this.handles.paint(this.stage.palette);
    this.obstacles.paint(this.stage.palette);
    this.otherObstacles.paint(this.stage.palette);
    this.ghosts.paint(this.stage.palette);
    this.ruler.paint(this.stage.palette);
    this.showMotion(this.studio.store.state);
    this.colour();
  }

  /** In the unit of lengths that is chosen now. */
  showUnits(): void {
    this.ruler.build();
    this.stage.invalidate();
  }

  private colour(): void {
    const { skin, joints, compared } = this.stage.palette;
    if (this.figure) {
      this.figure.skin.color = skin;
      this.figure.joints.color = joints;
    }
    if (this.other) {
      this.other.skin.color = compared;
      this.other.joints.color = compared.clone().multiplyScalar(0.7);
      const over = this.studio.store.state.compareMode === 'over';
      for (const material of [this.other.skin, this.other.joints]) {
        material.transparent = over;
        material.opacity = over ? 0.55 : 1;
      }
    }
    this.stage.invalidate();
  }

  look(): Look {
    return this.sought ?? this.stage.look();
  }

  firstPicture(): Promise<void> {
    return this.stage.firstPicture;
  }

  lookFrom(look: Look): void {
    this.unframed = false;
    this.soughtSide = null;
    if (this.framed === this.character) this.stage.lookFrom(look);
    else this.sought = look;
  }

  /** The whole body from one of the usual sides, of left and right from the one that acts. */
  lookFromSide(preset: Preset): void {
    const { document, store } = this.studio;
    this.sought = null;
    this.soughtSide = this.framed === this.character ? null : preset;
    if (!document || !this.figure || this.soughtSide) return;
    this.stage.frame(this.figure.height, directionOf(preset, store.state.selected.startsWith('left') ? 1 : -1));
    this.stage.include(document.goals.map((goal) => new Vector3(...goal.position_m)));
  }

  /** What is selected, an effector with its goal. */
  approachSelected(): void {
    const { document, store } = this.studio;
    if (!document) return;
    const { selected } = store.state;
    const asked = placeOf(document, selected);
    const place = this.place(selected) ?? (asked && new Vector3(...asked));
    if (!place) return;
    const apart = asked ? place.distanceTo(new Vector3(...asked)) : 0;
    if (asked) place.lerp(new Vector3(...asked), 0.5);
    this.stage.approach(place, Math.max(kApproach * document.character.description.stature_m, kRoom * apart));
  }

  onLook(listener: () => void): void {
    this.stage.orbit.addEventListener('change', listener);
  }

  onFigure(listener: (figure: Figure | null) => void): void {
    this.listeners.add(listener);
    listener(this.figure);
  }

  private advance(seconds: number): boolean {
    const { playing, loop, speed, dragging } = this.studio.store.state;
    if (!playing || dragging || !this.studio.shown()) return false;
    if (!this.studio.clock.advance(seconds * speed, loop)) this.studio.play(false);
    return true;
  }

  private changed(state: State, previous: State): void {
    const character = state.document?.character ?? null;
    if (character !== this.character) void this.setCharacter(character);
    else this.check();
    if (state.theme !== previous.theme) this.paint();
    if (state.view !== previous.view) this.stage.setLens(state.view);
    if (state.compareMode !== previous.compareMode) this.colour();
    if (state.document?.compared !== previous.document?.compared) void this.setOther();
    if (state.dragging && !previous.dragging) this.studio.play(false);
    if (!state.dragging && previous.dragging) this.snapMark.show(null);
    const { document } = state;
    const before = previous.document;
    const { obstacles } = document?.settings.more ?? {};
    if (document?.goals !== before?.goals || document?.result !== before?.result || obstacles !== before?.settings.more.obstacles) this.unframed = true;
    this.showOverlays(state);
    this.showMotion(state);
    this.stage.invalidate();
  }

  private showOverlays(state: State): void {
    const asked = state.trial ?? state.document;
    this.overlays.show(this.studio.shown(), state.document?.goals ?? []);
    this.obstacles.show(asked ? thingsOf(asked) : []);
    this.otherObstacles.show(asked && this.compared() ? thingsOf(asked) : []);
    this.marks.show(asked);
    this.otherOverlays.show(this.compared(), []);
    this.strained.show(this.studio.shown(), state.document?.character.description);
  }

  /** The whole motion in space. A drag has other things to draw. */
  private showMotion({ view, dragging, preview }: State): void {
    const chosen = dragging || preview ? null : this.studio.chosen();
    const compared = this.compared();
    this.ghosts.show(chosen, view.ghosts);
    const shown = [chosen, compared].filter((candidate) => candidate !== null);
    const most = view.path ? speedScale(shown) : 1;
    this.speeds.show(view.path ? chosen : null, most, this.stage.palette.speed);
    this.otherSpeeds.show(view.path ? compared : null, most, this.stage.palette.speed);
  }

  private compared(): Candidate | null {
    const { document, dragging, preview } = this.studio.store.state;
    if (!document || document.compared === null || dragging || preview) return null;
    return candidateAt(document, document.compared);
  }

  private async setCharacter(character: Character | null): Promise<void> {
    this.character = character;
    this.sought = null;
    this.soughtSide = null;
    this.ghosts.setFigure(null); // the motion is soon another body's
    const figure = character ? await makeFigure(character) : null;
    if (this.character !== character) {
      if (figure) disposeFigure(figure);
      return;
    }
    this.ghosts.setFigure(figure);
    if (this.figure) disposeFigure(this.figure);
    this.figure = figure;
    if (figure && character) {
      this.stage.casters.add(figure.object);
      this.stage.prepare();
      this.nodeOf.clear();
      for (const place of character.description.places) this.nodeOf.set(place.effector, nodeOfBone(character, place.node));
      if (!this.nodeOf.has('right_foot')) this.nodeOf.set('right_foot', nodeOfBone(character, 'right_foot'));
      this.overlays.setSupport(character.description);
      this.otherOverlays.setSupport(character.description);
      this.ruler.setStature(character.description.stature_m);
      this.stage.frame(figure.height);
      this.headReach = 0;
      this.unframed = this.sought === null;
      if (this.sought) this.stage.lookFrom(this.sought);
    }
    this.framed = character;
    this.sought = null;
    if (this.soughtSide) this.lookFromSide(this.soughtSide);
    await this.setOther();
    this.showMotion(this.studio.store.state);
    this.colour();
    for (const listener of this.listeners) listener(figure);
    this.check();
  }

  /** Compares a new figure with the first motion that the engine has for it. */
  private check(): void {
    const { figure, character } = this;
    const candidate = this.studio.chosen();
    if (!figure || !character || !candidate || this.checked === figure || this.framed !== this.studio.document?.character) return;
    this.checked = figure;
    this.studio.store.set({ undrawn: undrawnOf(figure, character, candidate) });
  }

  private async setOther(): Promise<void> {
    const wanted = this.character !== null && this.studio.document?.compared != null;
    if (this.other) disposeFigure(this.other);
    this.other = null;
    if (!wanted) return this.stage.invalidate();
    const figure = await makeFigure(this.character!);
    if (this.other !== null || this.studio.document?.compared == null) return disposeFigure(figure);
    this.other = figure;
    this.stage.casters.add(figure.object);
    this.colour();
  }

  private pose(): void {
    const { state } = this.studio.store;
    const shown = this.studio.shown();
    const document = state.document;
    if (!this.figure || !document) return;
    const time = state.dragging && shown ? shown.summary.duration_s : this.studio.clock.time;
    // unturned, a file's bones may stand anywhere
    this.figure.object.visible = shown !== null || !document.character.bytes;
    this.frame(document, shown);
    if (shown) poseFigure(this.figure, shown, time);
    const compared = this.compared();
    // a figure whose hand is dragged stays where it stands
    const apart = document.compared !== null && state.compareMode === 'beside' ? kBeside * document.character.description.stature_m : 0;
    this.standApart(apart);
    if (this.other) {
      this.other.object.visible = compared !== null;
      if (compared) poseFigure(this.other, compared, (time / this.studio.clock.duration) * compared.summary.duration_s);
    }
    this.figure.object.updateMatrixWorld(true);
    this.overlays.pose(time, state.overlays && !state.dragging);
    this.otherOverlays.pose(time, state.overlays && !state.dragging);
    this.ruler.pose(this.stage.camera, this.side, state.view.ruler);
    this.otherObstacles.object.visible = apart > 0 && compared !== null;
    this.showTags(document, compared);
    this.marks.pose((effector) => this.placeInMotion(effector));
    this.strained.pose(time, (joint) => this.place(joint.replace(/_ankle$/, '_foot')));
    this.handles.update(this.grips(state.trial ?? document), state.selected, state.rings);
  }

  /** Two that are compared stand beside one another as the camera sees them, as far from it, so that both have one size. */
  private standApart(apart: number): void {
    const side = new Vector3(apart / 2, 0, 0).applyQuaternion(this.stage.camera.quaternion);
    if (!side.equals(this.side)) this.stage.light.invalidate();
    this.side.copy(side);
    const ours = [this.overlays, this.ghosts, this.speeds, this.obstacles, this.marks, this.handles, this.snapMark].map(({ object }) => object);
    for (const object of [...ours, this.marks.solids, this.figure!.object]) object.position.copy(side);
    const others = [this.otherOverlays, this.otherSpeeds, this.otherObstacles].map(({ object }) => object);
    for (const object of this.other ? [...others, this.other.object] : others) object.position.copy(side).negate();
  }

  /** The number and the duration of each motion over its figure, where two are compared. */
  private showTags(document: Document, compared: Candidate | null): void {
    const { palette, lens } = this.stage;
    const chosen = this.studio.chosen();
    const order = ranking(document);
    const sign = (index: number, candidate: Candidate, colour: string, place: Vector3): Tag => ({
      text: `${order.indexOf(index) + 1} · ${t('seconds', { t: candidate.summary.duration_s.toFixed(2) })}`, colour, place,
    });
    const { stature_m } = document.character.description;
    const half = this.side.lengthSq() > 0 ? this.side : new Vector3(kTagApart * stature_m, 0, 0);
    const texts = chosen && compared && document.compared !== null
      ? [sign(document.chosen, chosen, palette.tag, half), sign(document.compared, compared, palette.comparedTag, half.clone().negate())] : [];
    this.tags.show(texts, stature_m, lens.constantSize);
  }

  /** What is written over figures that are compared; for tests. */
  get tagTexts(): string[] {
    return this.tags.texts;
  }

  /** The position of a place that is dragged there; marks the object that it snaps to. */
  private snapped(name: string, place: Vector3, inverted: boolean, ray?: Ray): Vector3 {
    const { document, store } = this.studio;
    this.snapTo = document && store.state.snap !== inverted ? snapOf(document, name, place, ray) : null;
    this.snapMark.show(this.snapTo);
    return this.snapTo?.place ?? place;
  }

  /** What the place that is dragged has snapped to: "floor", a thing or a hand; for tests. */
  get snappedTo(): string | null {
    return this.snapMark.object.visible ? this.snapTo?.to ?? null : null;
  }

  /** All that can be dragged. */
  private grips(asked: Document): Grip[] {
    const grips: Grip[] = thingsOf(asked).map(({ position_m, rotation_xyzw = [0, 0, 0, 1] }, index) => ({
      name: thingName(index), kind: 'thing', place: new Vector3(...position_m), rotation: rotation_xyzw,
    }));
    const { goals, character } = asked;
    for (const { effector, position_m, rotation_xyzw } of goals) {
      grips.push({ name: effector, kind: 'goal', place: new Vector3(...position_m), ...(rotation_xyzw && { rotation: rotation_xyzw }) });
    }
    const look = lookOf(asked);
    if (look) grips.push({ name: lookName, kind: 'look', place: new Vector3(...look) });
    const addFree = (effectors: readonly string[], kind: 'free' | 'joint'): void => {
      for (const effector of effectors) {
        const place = goals.some((goal) => goal.effector === effector) ? null : this.placeInMotion(effector);
        if (place) grips.push({ name: effector, kind, place });
      }
    };
    addFree(effectorsOf(character), 'free');
    addFree(jointsOf(character), 'joint');
    return grips;
  }

  /** Goes back until all of the motion is in the picture; a hand that is dragged must not see the picture move under it. */
  private frame(document: Document, shown: Candidate | null): void {
    const { figure } = this;
    const { dragging, preview } = this.studio.store.state;
    if (!this.unframed || !figure || !shown || dragging || preview) return;
    this.unframed = false;
    const head = figure.nodes[this.nodeOf.get('head') ?? -1];
    if (head && this.headReach === 0) {
      poseFigure(figure, shown, 0);
      figure.object.updateMatrixWorld(true);
      this.headReach = headReach(figure, head);
    }
    this.stage.include(document.goals.map((goal) => new Vector3(...goal.position_m)), placesToSee(document, shown, figure, head, this.headReach));
  }

  /** Where an effector's node is now. */
  private place(effector: string): Vector3 | null {
    const node = this.figure?.nodes[this.nodeOf.get(effector) ?? -1];
    return node ? node.getWorldPosition(new Vector3()) : null;
  }

  /** The same, wherever the figure stands beside another one. */
  private placeInMotion(effector: string): Vector3 | null {
    return this.place(effector)?.sub(this.figure!.object.position) ?? null;
  }

  /** Where an effector's node is drawn, m; for tests. */
  drawn(effector: string): Vec3 | null {
    const reached = this.studio.chosen()?.summary.reached.find((r) => r.effector === effector);
    if (!reached || !this.character || !this.figure) return null;
    const index = nodeOfReached(this.character.description, reached);
    return this.figure.nodes[index]?.getWorldPosition(new Vector3()).toArray() ?? null;
  }

  /** The ruler as it is drawn; for tests. */
  get drawnRuler(): Ruler['drawn'] {
    return this.ruler.drawn;
  }

  /** Joints that are marked as strained; for tests. */
  get strainedNames(): string[] {
    return this.strained.names;
  }

  /** As it is seen, but for the handles. */
  picture(settings: PictureSettings): Promise<Uint8Array> {
    return this.stage.picture(settings, [this.handles.object]);
  }

  /** A film of it, without the handles; playing stops. */
  async film(settings: FilmSettings, signal: AbortSignal, progress: (share: number) => void): Promise<Uint8Array> {
    const { film } = await fetchPart(() => import('./film'));
    const { clock } = this.studio;
    this.studio.play(false);
    const shown = clock.time;
    const { draw, end } = this.stage.film(settings.size, settings.transparent, [this.handles.object]);
    const scene: FilmScene = {
      duration: clock.duration,
      draw: (pen, time, turn) => {
        clock.time = time ?? shown;
        draw(pen, turn);
      },
    };
    try {
      return await film(scene, settings, signal, progress);
    } finally {
      clock.time = shown;
      end();
    }
  }

  /** The middle of it as a data URL, for lists; at a time of the motion where one is given, s. */
  smallPicture(time?: number): string {
    const { clock } = this.studio;
    const now = clock.time;
    if (time !== undefined) clock.time = time;
    const picture = this.stage.small(kSmallSide);
    clock.time = now;
    return picture;
  }

  /** Where the ghosts have an effector's node, m; for tests. */
  ghostsOf(effector: string): Vec3[] {
    return this.ghosts.placesOf(this.nodeOf.get(effector) ?? -1);
  }

  /** Whether the character's figure is in the picture; for tests. */
  get framesCharacter(): boolean {
    return this.framed === this.character;
  }

  /** How high the figure is drawn above the floor, m, and how closed its hands are; for tests. */
  drawnFigure(): DrawnFigure | null {
    if (!this.figure) return null;
    const { min, max } = new Box3().setFromObject(this.figure.object, true);
    const { closed } = this.figure;
    return { low: min.y, high: max.y, closed: closed ? { left: closed('left'), right: closed('right') } : null };
  }

  /** What goals are marked with; for tests. */
  get goalMarks(): string[] {
    return this.marks.kinds;
  }

  /** Whether a place is in the picture; for tests. */
  sees(place: Vec3): boolean {
    const p = new Vector3(...place).project(this.stage.camera);
    return Math.abs(p.x) < 1 && Math.abs(p.y) < 1;
  }

  /** From the head to the right foot of each figure in the picture, shares of its height; for tests. */
  get sizes(): number[] {
    const [head, foot] = ['head', 'right_foot'].map((name) => this.nodeOf.get(name) ?? -1);
    const height = (node: Object3D | undefined): number => node?.getWorldPosition(new Vector3()).project(this.stage.lens.shown).y ?? 0;
    return [this.figure, this.other].filter((figure) => figure !== null).map(({ nodes }) => (height(nodes[head!]) - height(nodes[foot!])) / 2);
  }

  /** How far the head is drawn above its joint, m; for tests. */
  get headHeight(): number {
    return this.headReach;
  }

  /** Where a handle is in the page, px; for tests. */
  handleOnScreen(name: string): [number, number] | null {
    const { document } = this.studio;
    const asked = document && placeOf(document, name);
    const place = asked ? new Vector3(...asked) : this.place(name);
    if (!place) return null;
    const box = this.stage.renderer.domElement.getBoundingClientRect();
    if (asked) place.add(this.handles.object.position);
    const p = place.project(this.stage.lens.shown);
    return [box.left + ((p.x + 1) / 2) * box.width, box.top + ((1 - p.y) / 2) * box.height];
  }

  dispose(): void {
    for (const end of this.ends) end();
    this.handles.dispose();
    if (this.figure) disposeFigure(this.figure);
    if (this.other) disposeFigure(this.other);
    this.stage.dispose();
  }
}
