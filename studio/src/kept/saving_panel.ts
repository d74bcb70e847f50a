// SPDX-License-Identifier: MIT
// Says in the top bar which project this is, and whether it is saved.
import { t } from '../i18n';
import { fill, h, type Panel } from '../panels/dom';
import type { State } from '../state/model';
import type { Studio } from '../state/studio';

export class SavingPanel implements Panel {
  readonly element = h('span', { class: 'saving' });
  private readonly end: () => void;

  constructor(studio: Studio) {
    this.end = studio.store.subscribe((state, previous) => {
      if (state.saving !== previous.saving || state.project !== previous.project) this.update(state);
    });
    this.update(studio.store.state);
  }

  private update({ saving, project }: State): void {
    this.element.dataset['saving'] = saving;
    if (saving === 'none') return fill(this.element);
    fill(this.element, h('span', {}, project), ' ', h('b', {}, t(`saving_${saving}`)));
  }

  dispose(): void {
    this.end();
  }
}
