// SPDX-License-Identifier: MIT
import './styles/theme.css';
import './styles/page.css';
import './styles/panels.css';
import './styles/verdict.css';
import './styles/scene.css';
import './styles/characters.css';
import './styles/projects.css';
import './styles/start.css';
import './styles/tip.css';
import './styles/phone.css';
import { browserSupport, connect, failureOf } from './engine/connect';
import { fetchLanguage, knowEngine, preferredLanguage, setLanguage, t } from './i18n';
import { isLengthUnit } from './i18n/lengths';
import { expose } from './inspect';
import { Keeper } from './kept/keeper';
import { workOfLink } from './kept/link';
import { recall } from './kept/memory';
import { openWork } from './kept/pack';
import { h } from './panels/dom';
import { startsWithCards } from './panels/start_cards';
import { openCharacter, openTask } from './state/files';
import { kHint, Studio } from './state/studio';
import { taskOfLink } from './state/task';

const kMostPatience = 150; // ms

/** In place of the page, where it cannot work. */
function refuse(root: HTMLElement, text: string): void {
  root.replaceChildren(h('div', { class: 'refused', role: 'alert' }, h('h1', {}, t('title')), h('p', {}, text)));
}

/** Opens the work or the task of the page's address, else the last one kept. Where something is open already, a
 *  damaged link changes nothing. */
async function openAddress(studio: Studio, keeper: Keeper): Promise<void> {
  const openFirst = async (): Promise<void> => {
    if (!studio.document) await keeper.openLast(() => openCharacter(studio, { source: 'human' }));
  };
  const { hash } = location;
  try {
    const work = await workOfLink(hash);
    const task = work ? null : taskOfLink(hash);
    if (work || task) {
      const kept = await keeper.openAsNew(() => (work ? openWork(studio, work) : openTask(studio, task!)));
      // loaded anew, the page has the link's work as it was changed since; another link may have come meanwhile
      if (kept && location.hash === hash) history.replaceState(null, '', location.pathname + location.search);
    }
  } catch (error) {
    await openFirst();
    if (error instanceof SyntaxError) studio.tell({ kind: 'text', key: 'badLink' });
    else studio.fail(error, t('theLink'));
    return;
  }
  await openFirst();
}

/** Until there is a document: the engine is then at work on its motions while the page is made. Files that take longer are not waited for. */
function begun({ store }: Studio): Promise<void> {
  return new Promise((done) => {
    if (store.state.document) return done();
    const end = store.subscribe(({ document }) => {
      if (!document) return;
      end();
      done();
    });
    setTimeout(done, kMostPatience);
  });
}

async function start(): Promise<void> {
  const root = document.getElementById('app')!;
  const support = browserSupport();
  // both take their time, so they are asked for first
  const [engine, module] = [support === 'ok' ? connect() : Promise.reject(new Error(support)), import('./page')];
  for (const each of [engine, module]) each.catch(() => undefined); // reported below
  void module.then(({ loadMannequin }) => loadMannequin()).catch(() => undefined); // most bodies are drawn as it
  await fetchLanguage(preferredLanguage());
  setLanguage(preferredLanguage());
  if (support !== 'ok') return refuse(root, t(support === 'no-wasm' ? 'noWasm' : support === 'no-simd' ? 'noSimd' : 'noWebgl'));
  const waiting = h('div', { class: 'refused' }, h('p', { role: 'status' }, t('loading')));
  root.append(waiting);
  try {
    const studio = new Studio(await engine);
    knowEngine(studio.facts);
    const theme = recall('theme');
    const lengths = recall('lengths');
    studio.store.set({ language: preferredLanguage(), lengths: isLengthUnit(lengths) ? lengths : 'cm', theme: theme === 'light' || theme === 'dark' ? theme : 'auto', hint: recall(kHint) === null, start: startsWithCards() && location.hash === '' });
    const keeper = new Keeper(studio);
    const opened = openAddress(studio, keeper);
    await Promise.race([opened, begun(studio)]);
    const made = await module.catch(() => null);
    if (!made) return refuse(root, t('partFailed'));
    waiting.remove();
    const page = new made.Page(studio, root, keeper);
    expose(studio, page.view);
    window.addEventListener('hashchange', () => void openAddress(studio, keeper));
    await opened;
  } catch (error) {
    const failure = failureOf(error);
    refuse(root, `${t('engineFailed')} ${failure?.code === 'io' ? t('partFailed') : failure?.message ?? ''}`);
  }
}

void start();
