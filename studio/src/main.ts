// SPDX-License-Identifier: MIT
import './styles/theme.css';
import './styles/page.css';
import './styles/panels.css';
import './styles/characters.css';
import { browserSupport, connect, failureOf } from './engine/connect';
import { preferredLanguage, setLanguage, t } from './i18n';
import { expose } from './inspect';
import { Page } from './page';
import { h } from './panels/dom';
import { openCharacter, openTask } from './state/files';
import { Studio } from './state/studio';
import { taskOfLink } from './state/task';

/** In place of the page, where it cannot work. */
function refuse(root: HTMLElement, text: string): void {
  root.replaceChildren(h('div', { class: 'refused', role: 'alert' }, h('h1', {}, t('title')), h('p', {}, text)));
}

async function firstTask(studio: Studio): Promise<void> {
  try {
    const task = taskOfLink(location.hash);
    if (task) return await openTask(studio, task);
  } catch (error) {
    await openCharacter(studio, { source: 'human' });
    if (error instanceof SyntaxError) studio.tell({ kind: 'text', key: 'badLink' });
    else studio.fail(error);
    return;
  }
  await openCharacter(studio, { source: 'human' });
}

async function start(): Promise<void> {
  const root = document.getElementById('app')!;
  setLanguage(preferredLanguage());
  const support = browserSupport();
  if (support !== 'ok') return refuse(root, t(support === 'no-wasm' ? 'noWasm' : support === 'no-simd' ? 'noSimd' : 'noWebgl'));
  const waiting = h('div', { class: 'refused' }, h('p', { role: 'status' }, t('loading')));
  root.append(waiting);
  try {
    const studio = new Studio(await connect());
    const theme = localStorage.getItem('shigusa.theme');
    studio.store.set({ language: preferredLanguage(), theme: theme === 'light' || theme === 'dark' ? theme : 'auto' });
    waiting.remove();
    const page = new Page(studio, root);
    expose(studio, page.view);
    window.addEventListener('hashchange', () => void firstTask(studio));
    await firstTask(studio);
  } catch (error) {
    refuse(root, `${t('engineFailed')} ${failureOf(error)?.message ?? ''}`);
  }
}

void start();
