// SPDX-License-Identifier: MIT
// A line in the view's corner: once, that the page works without the network; and that a newer page waits, whenever one does.
import { t } from '../i18n';
import { recall, remember } from '../kept/memory';
import { takeNewer } from '../offline/offline';
import type { Studio } from '../state/studio';
import { button, fill, h, iconButton, type Panel } from './dom';

const kKept = 'offline';
const kSeen = 12_000; // ms

export class OfflineLine implements Panel {
  readonly element = h('div', { class: 'offline-line', role: 'status' });
  private timer = 0;
  private readonly end: () => void;

  constructor(private readonly studio: Studio) {
    this.end = studio.store.subscribe((state, previous) => {
      if (state.offline !== previous.offline) this.update();
    });
    this.update();
  }

  private update(): void {
    const { offline } = this.studio.store.state;
    if (offline === 'newer') return this.tell(t('newerPage'), button(t('reload'), () => void takeNewer()));
    if (offline === 'no' || recall(kKept) !== null) return;
    remember(kKept, 'told');
    this.tell(t('offlineReady'));
    this.timer = window.setTimeout(() => fill(this.element), kSeen);
  }

  private tell(text: string, ...more: HTMLElement[]): void {
    clearTimeout(this.timer);
    fill(this.element, h('span', {}, text), ...more, iconButton('close', t('dismiss'), () => fill(this.element)));
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.end();
  }
}
