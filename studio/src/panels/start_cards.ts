// SPDX-License-Identifier: MIT
// Six things to begin with, below the view: five tasks and a person's own character. Shown at the first visit and by the button Start.
import { recall, remember } from '../kept/memory';
import { t } from '../i18n';
import { openFiles } from '../state/files';
import { characterEndings } from '../state/formats';
import { openStartTask, type StartTaskName } from '../state/start_tasks';
import type { Studio } from '../state/studio';
import { h, iconButton, type Panel } from './dom';
import { type StartPicture, startPicture } from './start_pictures';

const kCards = ['pick', 'shelf', 'box', 'seated', 'vrm', 'overhead'] as const satisfies readonly StartPicture[];
const kKept = 'start';

/** Whether the cards are shown on opening: until a person has closed them. */
export function startsWithCards(): boolean {
  return recall(kKept) === null;
}

export class StartCards implements Panel {
  readonly element: HTMLElement;
  private readonly end: () => void;

  constructor(private readonly studio: Studio) {
    const input = h('input', {
      type: 'file', accept: characterEndings(studio.facts).join(), hidden: true, multiple: true,
      onChange: () => {
        void openFiles(studio, [...(input.files ?? [])]);
        input.value = '';
      },
    });
    const card = (name: (typeof kCards)[number]): HTMLElement => h('li', {}, h('button', {
      type: 'button', class: 'start-card', 'data-start': name, onClick: () => (name === 'vrm' ? input.click() : this.open(name)),
    }, startPicture(name), h('span', {}, t(`start_${name}`))));
    this.element = h('section', { class: 'start', 'aria-label': t('startWith') },
      h('ul', {}, ...kCards.map(card)), iconButton('close', t('close'), () => studio.store.set({ start: false })), input);
    this.end = studio.store.subscribe((state, previous) => {
      if (state.start && previous.dragging && !state.dragging) return studio.store.set({ start: false });
      if (state.start === previous.start) return;
      this.element.hidden = !state.start;
      if (!state.start) remember(kKept, 'closed');
    });
    this.element.hidden = !studio.store.state.start;
  }

  private open(name: StartTaskName): void {
    openStartTask(this.studio, name).catch((error: unknown) => this.studio.fail(error));
  }

  dispose(): void {
    this.end();
  }
}
