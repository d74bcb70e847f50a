// SPDX-License-Identifier: MIT
// Scrub, play, loop, speed.
import { t } from '../i18n';
import type { Studio } from '../state/studio';
import { fill, h, icon, iconButton, type Panel, round, select } from './dom';

const kSpeeds = ['0.1', '0.25', '0.5', '1', '2'] as const;

export class Timeline implements Panel {
  readonly element: HTMLElement;
  private readonly range: HTMLInputElement;
  private readonly label = h('output', { class: 'clock' });
  private readonly play: HTMLButtonElement;
  private readonly ends: (() => void)[];

  constructor(private readonly studio: Studio) {
    const { store, clock } = studio;
    this.range = h('input', {
      type: 'range', min: '0', max: '1000', step: '1', 'aria-label': t('time'), class: 'scrub',
      onInput: () => studio.scrub((Number(this.range.value) / 1000) * clock.duration),
    });
    this.play = iconButton('play', t('play'), () => studio.play(!store.state.playing));
    const loop = iconButton('loop', t('loop'), () => store.set({ loop: !store.state.loop }));
    const overlays = iconButton('path', t('overlays'), () => store.set({ overlays: !store.state.overlays }));
    const speed = select(t('speed'), kSpeeds.map((value) => [value, `${value}×`] as const), String(store.state.speed), (value) =>
      store.set({ speed: Number(value) }));
    this.element = h('section', { class: 'timeline', 'aria-label': t('time') }, this.play, this.range, this.label, speed, loop, overlays);
    let shownPlaying: boolean | null = null;
    const update = (): void => {
      const { playing, loop: loops, overlays: shown, document } = store.state;
      if (playing !== shownPlaying) { // a click that has begun on its picture shall end there
        shownPlaying = playing;
        fill(this.play, icon(playing ? 'pause' : 'play'));
        this.play.setAttribute('aria-label', t(playing ? 'pause' : 'play'));
        this.play.title = t(playing ? 'pause' : 'play');
      }
      loop.setAttribute('aria-pressed', String(loops));
      overlays.setAttribute('aria-pressed', String(shown));
      const none = !document?.result;
      this.range.disabled = none;
      this.play.disabled = none;
      this.showTime();
    };
    this.ends = [store.subscribe(update), clock.subscribe(() => this.showTime())];
    update();
  }

  private showTime(): void {
    const { time, duration } = this.studio.clock;
    this.range.value = String(Math.round((time / duration) * 1000));
    this.label.textContent = `${round(time)} / ${t('seconds', { t: round(duration) })}`;
    this.range.setAttribute('aria-valuetext', t('seconds', { t: round(time) }));
  }

  dispose(): void {
    for (const end of this.ends) end();
  }
}
