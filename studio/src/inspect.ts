// SPDX-License-Identifier: MIT
// window.shigusa: the page's state to read, for tests and for the curious.
import type { Facts, Vec3 } from '../../bindings/wasm/src/types';
import { type Language, untranslated } from './i18n';
import { criterionTip, parameterTip } from './i18n/tips';
import type { Look } from './kept/work';
import type { Document, State } from './state/model';
import type { Studio } from './state/studio';
import { taskOf } from './state/task';
import type { Timings } from './state/timings';
import type { DrawnFigure, View } from './view/view';

export interface Inspection {
  readonly state: Readonly<State>;
  readonly document: Document | null;
  readonly task: object | null;
  readonly chosen: number;
  readonly words: readonly string[];
  readonly facts: Facts;
  /** Words of the engine that the page has none for, by language. */
  untranslated(language: Language): Promise<string[]>;
  readonly timings: Timings;
  readonly time: number;
  /** Bytes that the engine's modules have taken. */
  memory(): Promise<{ search: number; quick: number }>;
  /** Where a goal's effector is at the end of the chosen motion, by the engine's own series, m. */
  hand(effector?: string): Vec3 | null;
  /** The text of a slider's tip; "" if there is none. */
  tip(kind: 'parameter' | 'criterion', name: string): string;
  /** Where an effector's node is drawn now, m. */
  drawn(effector: string): Vec3 | null;
  /** From where the picture is seen. */
  look(): Look;
  /** Of the contact shadow, 0 to 1, at its darkest place. */
  contactDarkness(): number;
  /** The ruler as it is drawn. */
  readonly ruler: { height_m: number; texts: string[] } | null;
  /** What is written over two figures that are compared. */
  readonly tags: readonly string[];
  /** From head to foot of the figure, and of the one that it is compared with, in shares of the picture's height. */
  readonly sizes: readonly number[];
  /** Joints that are red on the figure. */
  readonly strained: readonly string[];
  /** Where the ghosts have an effector's node, m. */
  ghosts(effector: string): Vec3[];
  /** Whether the character's figure is in the picture. */
  readonly framed: boolean;
  /** How the figure is drawn now. */
  figure(): DrawnFigure | null;
  /** What goals are marked with in the view: axis, box, load, seat. */
  readonly marks: readonly string[];
  /** What a place that is dragged has snapped to: floor, a thing or a hand. */
  readonly snapped: string | null;
  /** Whether a place is in the picture. */
  sees(place: Vec3): boolean;
  /** How far the head is drawn above its joint, m. */
  readonly headHeight: number;
  /** Where a handle is in the page, px. */
  handle(effector: string): [number, number] | null;
}

declare global {
  interface Window {
    shigusa?: Inspection;
  }
}

export function expose(studio: Studio, view: View): void {
  const inspection: Inspection = {
    get state() {
      return studio.store.state;
    },
    get document() {
      return studio.document;
    },
    get task() {
      return studio.document ? taskOf(studio.facts, studio.document) : null;
    },
    get chosen() {
      return studio.document?.chosen ?? -1;
    },
    get words() {
      return studio.document?.result?.candidates.map((c) => c.summary.final_posture.words) ?? [];
    },
    facts: studio.facts,
    untranslated: (language) => untranslated(studio.facts, language),
    get timings() {
      return studio.timings;
    },
    get time() {
      return studio.clock.time;
    },
    get ruler() {
      return view.drawnRuler;
    },
    get tags() {
      return view.tagTexts;
    },
    get sizes() {
      return view.sizes;
    },
    get strained() {
      return view.strainedNames;
    },
    get snapped() {
      return view.snappedTo;
    },
    get marks() {
      return view.goalMarks;
    },
    get headHeight() {
      return view.headHeight;
    },
    sees: (place) => view.sees(place),
    contactDarkness: () => view.stage.light.contactDarkness,
    memory: () => studio.engine.memory(),
    look: () => view.look(),
    tip: (kind, name) => (kind === 'parameter' ? parameterTip(name) : criterionTip(name)),
    drawn: (effector) => view.drawn(effector),
    ghosts: (effector) => view.ghostsOf(effector),
    get framed() {
      return view.framesCharacter;
    },
    figure: () => view.drawnFigure(),
    handle: (effector) => view.handleOnScreen(effector),
    hand(effector) {
      const candidate = studio.chosen();
      if (!candidate) return null;
      const { effectors } = candidate.series;
      const index = effector === undefined ? 0 : candidate.summary.reached.findIndex((r) => r.effector === effector);
      const first = (effectors.frames - 1) * effectors.columns + 3 * index;
      return index < 0 ? null : [effectors.values[first]!, effectors.values[first + 1]!, effectors.values[first + 2]!];
    },
  };
  Object.defineProperty(window, 'shigusa', { value: Object.freeze(inspection) });
}
