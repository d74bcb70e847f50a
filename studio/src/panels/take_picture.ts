// SPDX-License-Identifier: MIT
// Takes the view away as a picture.
import { t } from '../i18n';
import type { Studio } from '../state/studio';
import { save } from '../state/take_away';
import type { View } from '../view/view';
import { button, h, select } from './dom';

const kTimes = ['1', '2', '4'] as const;

export class TakePicture {
  readonly element: HTMLElement;
  private times = 2;
  private transparent = false;

  constructor(private readonly studio: Studio, private readonly view: View) {
    const size = select(t('pictureSize'), kTimes.map((times) => [times, `${times}×`] as const), String(this.times), (times) => {
      this.times = Number(times);
    });
    size.dataset['picture'] = 'times';
    const bare = h('input', {
      type: 'checkbox', 'data-picture': 'transparent', onChange: () => {
        this.transparent = bare.checked;
      },
    });
    this.element = h('section', {}, h('h3', {}, t('picture')),
      h('div', { class: 'fields' }, h('label', {}, h('span', {}, t('pictureSize')), size)), h('label', { class: 'view-row' }, bare, h('span', {}, t('transparent'))),
      h('div', { class: 'take' }, button('PNG', () => void this.take(), { 'data-format': 'picture' })));
  }

  private async take(): Promise<void> {
    const { studio, view, times, transparent } = this;
    if (times > view.stage.mostTimes) {
      return studio.tell({ kind: 'text', key: 'pictureTooLarge', values: { most: view.stage.mostTimes.toFixed(1) } });
    }
    try {
      const file = { name: 'shigusa-view.png', bytes: await view.picture({ times, transparent }), type: 'image/png' };
      save(file);
      studio.tell({ kind: 'text', key: 'saved', values: { name: file.name } });
    } catch (error) {
      studio.fail(error);
    }
  }
}
