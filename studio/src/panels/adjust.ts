// SPDX-License-Identifier: MIT
// The parameter editor: sliders by limb, locks, the search's values marked.
import type { Parameter } from '../../../bindings/wasm/src/types';
import { groupName, parameterName, t } from '../i18n';
import { chosenCandidate, type Document } from '../state/model';
import type { Studio } from '../state/studio';
import { button, fill, h, icon, type Panel, round } from './dom';
import { Slider } from './slider';
import { tipOfParameter } from './slider_tips';
import { TimingSection } from './timing';
import { giveTip } from './tooltip';

const kJointOf = (name: string): string => name.replace(/\.weight$/, '');

/** Posture and path say most, so they stand first. */
const kOrder = ['posture', 'legs', 'arms', 'path', 'right_arm', 'left_arm', 'trunk', 'right_leg', 'left_leg'];

export class AdjustPanel implements Panel {
  readonly element: HTMLElement;
  private readonly reset: HTMLButtonElement;
  private readonly rest: HTMLButtonElement;
  private readonly kept = h('p', { class: 'quiet' });
  private readonly groups = h('div');
  private readonly timing: TimingSection;
  private rows = new Map<string, { slider: Slider; lock: HTMLButtonElement | null }>();
  private built = '';
  private open = new Set(['posture', 'legs', 'path']);
  private side = ''; // of the hand or foot that acts
  private readonly end: () => void;

  constructor(private readonly studio: Studio) {
    this.reset = button(t('reset'), () => studio.resetEdits());
    this.rest = button(t('searchRest'), () => {
      if (studio.document) void studio.searchRest(this.assignments(studio.document));
    }, { class: 'primary' });
    this.timing = new TimingSection(studio);
    this.element = h('div', { class: 'panel' }, h('p', { class: 'quiet' }, t('adjustIntro')),
      h('div', { class: 'buttons' }, this.reset, button(t('mirror'), () => void studio.mirror()), this.rest), this.kept, this.groups, this.timing.element);
    this.end = studio.store.subscribe((state, previous) => {
      if (state.document !== previous.document) this.update();
    });
    this.update();
  }

  private update(): void {
    const { document } = this.studio;
    const candidate = chosenCandidate(document);
    if (!document || !candidate) return fill(this.groups, h('p', { class: 'quiet' }, t('noMotion')));
    this.openActing(document);
    const found = document.result?.candidates[document.chosen]?.parameters ?? [];
    // marks and rows are those of one candidate of one result
    const key = `${document.character.id} ${document.chosen} ${found.map((p) => `${p.name}${p.value}`).join()}`;
    if (key !== this.built) {
      this.built = key;
      this.build(candidate.parameters, found);
    }
    for (const parameter of candidate.parameters) {
      const row = this.rows.get(parameter.name);
      if (!row) continue;
      row.slider.show(parameter.value);
      row.slider.disabled = parameter.locked;
      if (row.lock && row.lock.getAttribute('aria-pressed') !== String(parameter.locked)) {
        row.lock.setAttribute('aria-pressed', String(parameter.locked));
        fill(row.lock, icon(parameter.locked ? 'lock' : 'unlock'));
      }
    }
    this.showBar(document);
    this.timing.update(document);
  }

  /** Where the other side acts, its groups are open as this one's were. */
  private openActing({ goals }: Document): void {
    const side = /^(left|right)_/.exec(goals[0]?.effector ?? '')?.[1] ?? '';
    if (this.side !== '' && side !== '' && side !== this.side) {
      this.open = new Set([...this.open].map((group) => group.replace(/^(left|right)_/, (own) => (own === 'left_' ? 'right_' : 'left_'))));
    }
    this.side = side || this.side;
  }

  private showBar(document: Document): void {
    this.reset.disabled = document.edits[document.chosen] === undefined;
    this.rest.disabled = this.assignments(document).length === 0;
    fill(this.kept, ...(document.fixed.length === 0 ? [] : [
      t('kept', { n: document.fixed.length }), ' ', button(t('release'), () => void this.studio.searchRest([]), { class: 'link' }),
    ]));
    this.kept.title = document.fixed.join('\n');
  }

  /** The values that the user has set or locked, and those kept already. */
  private assignments(document: Document): string[] {
    const all = new Map<string, string>();
    for (const assignment of document.fixed) {
      const [name = '', value = ''] = assignment.split('=');
      all.set(name, value);
    }
    for (const [name, value] of Object.entries(document.edits[document.chosen]?.assignments ?? {})) all.set(name, value);
    return [...all].filter(([, value]) => value !== 'false').map(([name, value]) => `${name}=${value}`);
  }

  private build(parameters: readonly Parameter[], found: readonly Parameter[]): void {
    this.rows.clear();
    const byGroup = new Map<string, Parameter[]>();
    for (const parameter of parameters) {
      byGroup.set(parameter.group, [...(byGroup.get(parameter.group) ?? []), parameter]);
    }
    const place = (group: string): number => (kOrder.indexOf(group) + kOrder.length + 1) % (kOrder.length + 1);
    const names = [...byGroup.keys()].sort((a, b) => place(a) - place(b));
    fill(this.groups, ...names.map((group) => {
      const members = byGroup.get(group)!;
      const details = h('details', { open: this.open.has(group), onToggle: () => this.open[details.open ? 'add' : 'delete'](group) },
        h('summary', {}, groupName(group)));
      let told = false;
      for (const parameter of members) {
        if (parameter.kind === 'weight' && !told) {
          told = true;
          details.append(h('p', { class: 'quiet' }, t('weightsIntro')));
        }
        details.append(this.row(parameter, found.find((p) => p.name === parameter.name)));
      }
      return details;
    }));
  }

  private row(parameter: Parameter, found: Parameter | undefined): HTMLElement {
    const label = parameterName(parameter.name);
    const digits = parameter.unit === 'deg' ? 0 : 2;
    const mark = found?.value ?? parameter.value;
    const name = h('span', { class: 'row-name' }, label);
    const slider = new Slider({
      label, name, value: parameter.value, low: parameter.low, high: parameter.high, log: parameter.scale === 'log', digits, mark,
      markTitle: t('searchValue', { value: parameter.scale === 'log' ? Number(mark.toPrecision(3)) : round(mark, digits) }),
      unit: parameter.unit === 'deg' ? '°' : parameter.unit,
      onInput: (value, drag) => void this.studio.edit({ [parameter.name]: String(value) }, drag),
      onBack: (drag) => this.studio.takeBackEdit(drag),
    });
    slider.range.dataset['parameter'] = parameter.name;
    let lock: HTMLButtonElement | null = null;
    if (parameter.kind === 'weight') {
      const press = h('button', {
        type: 'button', class: 'icon-button lock', 'aria-pressed': String(parameter.locked), 'aria-label': t('lock', { name: label }), title: t('lock', { name: label }),
        onClick: () => void this.studio.edit({ [`${kJointOf(parameter.name)}.locked`]: String(press.getAttribute('aria-pressed') !== 'true') }),
      }, icon(parameter.locked ? 'lock' : 'unlock'));
      lock = press;
    }
    this.rows.set(parameter.name, { slider, lock });
    const row = h('div', { class: 'row' }, h('div', { class: 'row-head' }, name, lock), slider.element);
    giveTip(row, name, slider.range, () => tipOfParameter(this.studio, parameter));
    return row;
  }

  dispose(): void {
    this.end();
  }
}
