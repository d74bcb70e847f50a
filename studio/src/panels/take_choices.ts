// SPDX-License-Identifier: MIT
// How animations leave: frames a second, what they are called, whose names joints have, with or without what the
// hips travel, one motion or all.
import { engineWord, t } from '../i18n';
import type { FileChoices } from '../state/model';
import type { Studio } from '../state/studio';
import { h, type Panel, select } from './dom';

/** Frames a second that films, television and games have. */
const kRates = ['24', '25', '29.97', '30', '50', '60', '120'];
const kLongestName = 60;

export class TakeChoices implements Panel {
  readonly element: HTMLElement;
  private readonly names: HTMLSelectElement;
  private readonly end: () => void;

  constructor(private readonly studio: Studio) {
    const { facts, store } = studio;
    const { fps, files } = store.state;
    const rate = select(t('fps'), kRates.map((value) => [value, value] as const), String(fps), (value) => store.set({ fps: Number(value) }));
    const rated = facts.formats.filter((format) => format.rated).map(({ name }) => name.toUpperCase());
    rate.title = t('fpsOf', { formats: rated.join(', ') });
    const clip = h('input', {
      type: 'text', value: files.clip, maxlength: String(kLongestName), placeholder: 'shigusa', 'data-key': 'clip', onChange: () => this.choose({ clip: clip.value.trim() }),
    });
    this.names = select(t('jointNames'), facts.joint_names.map(({ name }) => [name, engineWord('jointNames', name)] as const), files.jointNames,
      (jointNames) => this.choose({ jointNames }));
    this.names.dataset['key'] = 'joint names';
    this.element = h('div', { class: 'fields' },
      h('label', {}, h('span', {}, t('fps')), rate),
      h('label', {}, h('span', {}, t('clipName')), clip),
      h('label', {}, h('span', {}, t('jointNames')), this.names),
      this.check('inPlace', t('inPlace'), t('inPlaceAbout')),
      this.check('together', t('together'), ''));
    this.end = store.subscribe(() => this.update());
    this.update();
  }

  private choose(more: Partial<FileChoices>): void {
    const { store } = this.studio;
    store.set({ files: { ...store.state.files, ...more } });
  }

  private check(key: 'inPlace' | 'together', name: string, about: string): HTMLElement {
    const box = h('input', {
      type: 'checkbox', checked: this.studio.store.state.files[key], 'data-key': key, onChange: () => this.choose({ [key]: box.checked }),
    });
    return h('label', { class: 'check', title: about }, box, name);
  }

  /** A character's file has names of its own. */
  private update(): void {
    const own = this.studio.document?.character.bytes !== undefined;
    this.names.disabled = own;
    this.names.value = own ? 'own' : this.studio.store.state.files.jointNames;
  }

  dispose(): void {
    this.end();
  }
}
