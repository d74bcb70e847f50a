// SPDX-License-Identifier: MIT
// Whose body: a built-in one of any size, or a file's; what was understood of it, and mending the bone map.
import type { CharacterDescription, CharacterSpec } from '../../../bindings/wasm/src/types';
import { engineText, engineWord, jointName, t } from '../i18n';
import { openCharacter, openFile } from '../state/files';
import { characterEndings, characterFormats, isBuiltIn } from '../state/formats';
import type { Document } from '../state/model';
import { isRobot } from '../state/start';
import type { Studio } from '../state/studio';
import type { Portraits } from '../view/portraits';
import { CharacterList } from './character_list';
import { button, fill, h, type Panel, select } from './dom';

/** "moves at 19 joints, in 35 ways" */
function movesText({ joints }: CharacterDescription): string {
  const places = new Set(joints.map(({ name }) => name.split('.')[0]));
  return t('moves', { joints: places.size, ways: joints.length });
}

export class BodyPanel implements Panel {
  readonly element: HTMLElement;
  private readonly content = h('div');
  private readonly characters: CharacterList;
  private readonly end: () => void;
  private shown: Document['character'] | null = null;
  private mapOpen = false;

  constructor(private readonly studio: Studio, portraits: Portraits) {
    this.characters = new CharacterList(studio, portraits);
    const input = h('input', {
      type: 'file', accept: [...characterEndings(studio.facts), '.json'].join(), hidden: true,
      onChange: () => {
        const file = input.files?.[0];
        if (file) void openFile(studio, file);
        input.value = '';
      },
    });
    this.element = h('div', { class: 'panel' }, h('p', { class: 'quiet' }, t('bodyIntro', { formats: characterFormats(studio.facts) })),
      h('div', { class: 'buttons' }, button(t('openFile'), () => input.click()), input), this.characters.element, this.content);
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
    fill(this.content,
      this.builtIn(spec), this.measures(character),
      h('h3', {}, t('understood')), h('p', {}, movesText(description)),
      description.doubts.length > 0 ? h('div', {}, h('h4', {}, t('doubts')), h('ul', {}, ...description.doubts.map((doubt) => h('li', {}, engineText(doubt))))) : null,
      character.bytes ? this.boneMap(character) : null);
  }

  /** Opens a built-in body, as it was left where it was open before. */
  private builtIn(spec: CharacterSpec): HTMLElement {
    const names = this.studio.facts.bodies.map(({ name }) => [name, engineWord('bodies', name)] as const);
    const own = isBuiltIn(this.studio.facts, spec);
    const options = own ? names : ([['', t('nothing')], ...names] as const);
    const choice = select(t('builtIn'), options, own ? spec.source : '', (source) => {
      if (source === '') return;
      const before = this.studio.store.state.shelf.find(({ character }) => character.spec.source === source);
      const opened = before ? this.studio.begin(before) : openCharacter(this.studio, { source });
      opened.catch((error: unknown) => this.studio.fail(error));
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
    this.characters.dispose();
  }
}
