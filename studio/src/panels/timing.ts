// SPDX-License-Identifier: MIT
// The timing of all motions: how early they make their way, and how early the head turns.
import { engineWord, type Key, t } from '../i18n';
import type { Document } from '../state/model';
import type { Studio } from '../state/studio';
import { keepTiming, tryTiming } from '../state/timed';
import { h } from './dom';
import { Slider } from './slider';
import { giveTip } from './tooltip';

const kRows = [['ease', 'ease'], ['gaze_lead', 'gazeLead']] as const satisfies readonly (readonly ['ease' | 'gaze_lead', Key])[];

export class TimingSection {
  readonly element: HTMLDetailsElement;
  private readonly sliders: readonly (readonly ['ease' | 'gaze_lead', Slider])[];
  private asked: Partial<Record<'ease' | 'gaze_lead', number>> = {};

  constructor(private readonly studio: Studio) {
    this.element = h('details', { open: true }, h('summary', {}, t('timing')));
    this.sliders = kRows.map(([name, key]) => {
      const [low, high] = studio.facts.ranges[name];
      const label = h('span', { class: 'row-name' }, t(key));
      const slider = new Slider({
        label: t(key), name: label, value: 0, low: 100 * low, high: 100 * high, digits: 0, mark: 0, unit: '%',
        onInput: (percent) => this.moved(name, percent / 100),
        onEnd: () => this.ended(),
        onBack: () => this.dropped(),
      });
      slider.range.dataset['parameter'] = name;
      const row = h('div', { class: 'row' }, h('div', { class: 'row-head' }, label), slider.element);
      giveTip(row, label, slider.range, () => ({ text: engineWord('timing', name) }));
      this.element.append(row);
      return [name, slider] as const;
    });
  }

  private moved(name: 'ease' | 'gaze_lead', value: number): void {
    this.asked = { ...this.asked, [name]: Number(value.toFixed(3)) };
    const { asked } = this;
    void tryTiming(this.studio, asked, () => this.asked === asked);
  }

  private dropped(): void {
    this.asked = {};
    this.studio.store.set({ preview: null });
  }

  private ended(): void {
    const { asked } = this;
    this.asked = {};
    void keepTiming(this.studio, asked);
  }

  update({ settings }: Document): void {
    const preset = this.studio.facts.presets.find(({ name }) => name === settings.preset);
    for (const [name, slider] of this.sliders) {
      slider.show(100 * (settings.more[name] ?? 0));
      slider.disabled = name === 'ease' ? preset?.layered === true : preset?.natural === false;
    }
    this.element.title = preset?.layered === true ? t('notInLayers') : '';
  }
}
