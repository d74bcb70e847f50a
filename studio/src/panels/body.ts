// SPDX-License-Identifier: MIT
// Whose body: a built-in one of any size, or a file's; what was understood of it, and mending the bone map.
import type { CharacterSpec } from '../../../bindings/wasm/src/types';
import { engineWord, jointName, t } from '../i18n';
import { openCharacter, openFile } from '../state/files';
import { characterEndings, characterFormats } from '../state/formats';
import type { Document } from '../state/model';
import { isRobot } from '../state/start';
import type { Studio } from '../state/studio';
import { button, fill, h, type Panel, round, select } from './dom';

export class BodyPanel implements Panel {
  readonly element: HTMLElement;
  private readonly content = h('div');
  private readonly end: () => void;
  private shown: Document['character'] | null = null;
  private mapOpen = false;

  constructor(private readonly studio: Studio) {
    const input = h('input', {
      type: 'file', accept: [...characterEndings(studio.facts), '.json'].join(), hidden: true,
      onChange: () => {
        const file = input.files?.[0];
        if (file) void openFile(studio, file);
        input.value = '';
      },
    });
    this.element = h('div', { class: 'panel' }, h('p', { class: 'quiet' }, t('bodyIntro', { formats: characterFormats(studio.facts) })),
      h('div', { class: 'buttons' }, button(t('openFile'), () => input.click()), input), this.content);
    this.end = studio.store.subscribe((state, previous) => {
      if (state.document?.character !== previous.document?.character) this.update();
    });
    this.update();
  }

  private change(more: Partial<CharacterSpec>): void {
    const now = this.studio.document!.character;
    const spec: CharacterSpec = { ...now.spec, ...more };
    openCharacter(this.studio, spec, now.bytes).catch((error: unknown) => {
      this.studio.fail(error);
      this.shown = null;
      this.update();
    });
  }

  private update(): void {
    const character = this.studio.document?.character;
    if (!character || character === this.shown) return;
    this.shown = character;
    const { spec, description } = character;
    const facts = t('facts', { stature: round(description.stature_m, 2), mass: round(description.mass_kg, 0), dof: description.dof });
    fill(this.content,
      this.builtIn(spec), this.measures(character),
      h('h3', {}, t('understood')), h('p', {}, h('b', {}, description.name), ` — ${facts}`),
      description.doubts.length > 0 ? h('div', {}, h('h4', {}, t('doubts')), h('ul', {}, ...description.doubts.map((doubt) => h('li', {}, doubt)))) : null,
      character.bytes ? this.boneMap(character) : null);
  }

  private builtIn(spec: CharacterSpec): HTMLElement {
    const names = this.studio.facts.bodies.map(({ name, dof }) => [name, t('freedoms', { body: engineWord('bodies', name), dof })] as const);
    const own = names.some(([name]) => name === spec.source);
    const options = own ? names : ([['', spec.source], ...names] as const);
    const choice = select(t('builtIn'), options, own ? spec.source : '', (source) => {
      if (source !== '') openCharacter(this.studio, { source }).catch((error: unknown) => this.studio.fail(error));
    });
    return h('div', { class: 'fields' }, h('label', {}, h('span', {}, t('builtIn')), choice));
  }

  private measures({ spec, description, bytes }: Document['character']): HTMLElement {
    const number = (value: number, [low, high]: readonly [number, number], step: string, apply: (value: number) => void): HTMLInputElement => {
      const input = h('input', {
        type: 'number', min: String(low), max: String(high), step, value: String(Number(value.toFixed(3))),
        onChange: () => apply(Math.min(Math.max(Number(input.value) || value, low), high)),
      });
      return input;
    };
    const { ranges, sexes } = this.studio.facts;
    const sex = select(t('sex'), sexes.map((name) => [name, engineWord('sexes', name)] as const), spec.sex ?? sexes[0]!, (value) =>
      this.change({ sex: value as NonNullable<CharacterSpec['sex']> }));
    const heels = h('input', { type: 'checkbox', checked: spec.heels === true, onChange: () => this.change({ heels: heels.checked }) });
    if (isRobot(description)) return h('div');
    return h('div', { class: 'fields' },
      h('label', {}, h('span', {}, t('stature')), number(description.stature_m, ranges.stature_m, '0.01', (value) => this.change({ stature_m: value })), t('m')),
      h('label', {}, h('span', {}, t('mass')), number(description.mass_kg, ranges.mass_kg, '1', (value) => this.change({ mass_kg: value })), t('kg')),
      h('label', {}, h('span', {}, t('sex')), sex),
      spec.source === 'human' || bytes ? h('label', { class: 'check' }, heels, t('heels')) : null);
  }

  private boneMap({ spec, description }: Document['character']): HTMLElement {
    const nodes = [...new Set(description.nodes.map((node) => node.name).filter((name) => name !== ''))];
    const changed = new Map<string, string>();
    const apply = button(t('apply'), () => this.change({ map: { ...spec.map, ...Object.fromEntries(changed) } }), { class: 'primary', disabled: true, 'data-key': 'apply map' });
    const rows = this.studio.facts.bones.map((bone) => {
      const now = spec.map?.[bone] ?? description.humanoid[bone] ?? '';
      const known = now === '' || nodes.includes(now) ? nodes : [now, ...nodes];
      const choice = select(jointName(bone), [['', t('nothing')], ...known.map((name) => [name, name] as const)], now, (name) => {
        if (name === now || name === '') changed.delete(bone);
        else changed.set(bone, name);
        apply.disabled = changed.size === 0;
      });
      choice.dataset['bone'] = bone;
      return h('tr', {}, h('th', { scope: 'row' }, jointName(bone)), h('td', {}, choice));
    });
    const details = h('details', { open: this.mapOpen, onToggle: () => void (this.mapOpen = details.open) }, h('summary', {}, t('boneMap')),
      h('table', { class: 'bones' }, h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, t('bone')), h('th', { scope: 'col' }, t('node')))), h('tbody', {}, ...rows)),
      h('div', { class: 'buttons' }, apply));
    return details;
  }

  dispose(): void {
    this.end();
  }
}
