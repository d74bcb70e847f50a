// SPDX-License-Identifier: MIT
// Where the eyes are on at the end, as numbers; without it they are on the goal.
import type { Vec3 } from '../../../bindings/wasm/src/types';
import { t } from '../i18n';
import type { Document } from '../state/model';
import { lookName, lookOf, withLook } from '../state/places';
import type { Studio } from '../state/studio';
import { kFarthest } from '../view/handles';
import { h } from './dom';
import { fieldGroup, NumberField } from './number_field';

const kAxes = ['left', 'up', 'ahead'] as const;
const kEyes = 0.93; // statures above the floor
const kAhead = 1; // m

/** Straight ahead of a standing person. */
const ahead = ({ character }: Document): Vec3 => [0, kEyes * character.description.stature_m, kAhead];

export class LookRow {
  readonly element: HTMLElement;
  private readonly has: HTMLInputElement;
  private readonly axes: readonly NumberField[];
  private readonly details: HTMLElement;

  constructor(private readonly studio: Studio) {
    this.has = h('input', { type: 'checkbox', 'data-key': 'look has', onChange: () => this.ask() });
    this.axes = kAxes.map((axis, index) => new NumberField(studio, {
      key: `look ${axis}`, label: t(axis), low: -kFarthest, high: kFarthest, kind: 'length',
      change: (document, value) => {
        const place: Vec3 = [...lookOf(document) ?? ahead(document)];
        place[index] = value;
        return withLook(document, place);
      },
    }));
    this.details = fieldGroup(t('looksAt'), this.axes);
    this.element = h('div', { class: 'goal', role: 'group', 'aria-label': t('looksAt') },
      h('div', { class: 'goal-head' }, h('label', {}, this.has, t('looksAt'))), this.details);
    this.element.addEventListener('focusin', () => studio.document && lookOf(studio.document) && studio.select(lookName));
  }

  private ask(): void {
    const { document } = this.studio;
    if (!document) return;
    void this.studio.settle(withLook(document, this.has.checked ? ahead(document) : undefined));
    if (this.has.checked) this.studio.select(lookName);
  }

  update(document: Document, selected: string): void {
    const place = lookOf(document);
    this.has.checked = place !== undefined;
    this.details.hidden = place === undefined;
    this.element.classList.toggle('selected', place !== undefined && selected === lookName);
    place?.forEach((value, index) => this.axes[index]!.show(value));
  }
}
