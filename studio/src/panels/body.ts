// SPDX-License-Identifier: MIT
// Whose body: a built-in one of any size, or a file's; what was understood of it.
import type { CharacterDescription, CharacterSpec } from '../../../bindings/wasm/src/types';
import { engineText, engineWord, t } from '../i18n';
import { openCharacter, openFiles } from '../state/files';
import { characterEndings, characterFormats, isBuiltIn } from '../state/formats';
import type { Document } from '../state/model';
import type { Studio } from '../state/studio';
import type { Portraits } from '../view/portraits';
import { boneMap } from './bone_map';
import { CharacterList } from './character_list';
import { button, fill, h, type Panel, select } from './dom';
import { measures } from './measures';
import { startPosture } from './start_posture';

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
      type: 'file', accept: [...characterEndings(studio.facts), '.json'].join(), hidden: true, multiple: true,
      onChange: () => {
        void openFiles(studio, [...(input.files ?? [])]);
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
      this.builtIn(spec),
      measures(this.studio, character, (more) => this.change(more)), startPosture(character, (more) => this.change(more)),
      h('h3', {}, t('understood')), h('p', {}, movesText(description)),
      description.doubt_messages.length > 0 ? h('div', {}, h('h4', {}, t('doubts')), h('ul', {}, ...description.doubt_messages.map((doubt) => h('li', {}, engineText(doubt))))) : null,
      character.bytes ? this.bones(character) : null);
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

  /** Stays as open as it was when another map is applied. */
  private bones(character: Document['character']): HTMLElement {
    const details = boneMap(this.studio.facts.bones, character, (more) => this.change(more));
    details.open = this.mapOpen;
    details.addEventListener('toggle', () => void (this.mapOpen = details.open));
    return details;
  }

  dispose(): void {
    this.end();
    this.characters.dispose();
  }
}
