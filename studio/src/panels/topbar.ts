// SPDX-License-Identifier: MIT
import { t } from '../i18n';
import type { Keeper } from '../kept/keeper';
import { ProjectMenu } from '../kept/project_menu';
import type { Studio } from '../state/studio';
import { button, h, iconButton, type Panel, select } from './dom';
import { keepPlaced } from './popover';

export class TopBar implements Panel {
  readonly element: HTMLElement;
  private readonly end: () => void;

  constructor(studio: Studio, keeper: Keeper, openHelp: () => void) {
    const { store } = studio;
    const start = button(t('start'), () => store.set({ start: !store.state.start }), { class: 'quiet-button' });
    const undo = iconButton('undo', t('undo'), () => studio.undo());
    const redo = iconButton('redo', t('redo'), () => studio.redo());
    const mirror = iconButton('mirror', t('mirror'), () => void studio.mirror());
    const language = select(t('language'), [['en', 'English'], ['ja', '日本語']], store.state.language, (value) =>
      store.set({ language: value }));
    const theme = select(t('theme'), [['auto', t('themeAuto')], ['light', t('themeLight')], ['dark', t('themeDark')]], store.state.theme, (value) =>
      store.set({ theme: value }));
    const projects = new ProjectMenu(studio, keeper);
    const choices = h('div', { id: 'page-menu', class: 'tools page-menu', popover: 'auto', role: 'group', 'aria-label': t('more') },
      start, theme, language, iconButton('help', t('help'), openHelp));
    // on narrow screens these are behind a button
    const more = iconButton('more', t('more'), () => undefined, { popovertarget: 'page-menu', class: 'icon-button page-opener' });
    this.element = h('header', { class: 'topbar' },
      h('h1', {}, h('img', { src: './favicon.svg', alt: '' }), h('span', {}, 'shigusa'), h('small', {}, t('tagline'))),
      projects.element, h('div', { class: 'tools' }, undo, redo, mirror), more, choices);
    const unplace = keepPlaced(choices, more, 'below');
    const update = (): void => {
      start.setAttribute('aria-pressed', String(store.state.start));
      undo.disabled = !store.state.canUndo;
      redo.disabled = !store.state.canRedo;
      mirror.disabled = !store.state.document?.result;
    };
    const end = store.subscribe(update);
    this.end = () => {
      end();
      unplace();
      projects.dispose();
    };
    update();
  }

  dispose(): void {
    this.end();
  }
}
