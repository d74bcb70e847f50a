// SPDX-License-Identifier: MIT
// The page: bars, view and panels put together. Made anew where the language changes.
import { fetchLanguage, type Language, setLanguage, t } from './i18n';
import { setLengthUnit } from './i18n/lengths';
import { placeWords } from './i18n/place_words';
import type { Keeper } from './kept/keeper';
import { remember } from './kept/memory';
import { WantedBanner } from './kept/wanted_banner';
import { Keyboard } from './keyboard';
import { AdjustPanel } from './panels/adjust';
import { CriteriaPanel } from './panels/criteria';
import { button, h, type Panel } from './panels/dom';
import { Gallery } from './panels/gallery';
import { GoalsPanel } from './panels/goals';
import { helpDialog } from './panels/help';
import { Notices } from './panels/notices';
import { OfflineLine } from './panels/offline_line';
import { SpeedLegend } from './panels/speed_legend';
import { StartCards } from './panels/start_cards';
import { Tabs } from './panels/tabs';
import { Timeline } from './panels/timeline';
import { TopBar } from './panels/topbar';
import { VerdictLine } from './panels/verdict';
import { ViewMenu } from './panels/view_menu';
import { keepOffline } from './offline/offline';
import { openFiles } from './state/files';
import { characterFormats } from './state/formats';
import type { Studio } from './state/studio';
import { Thumbnails } from './view/thumbnails';
import { shownTheme } from './view/palette';
import { View } from './view/view';

export { loadMannequin } from './view/mannequin_file';

const kRests = 1000; // ms after the first motions

const later = (): Promise<typeof import('./panels/later')> => import('./panels/later');

/** Fetches them while nobody waits, and then all else, so that they are there where the network is not. */
function fetchLater({ store }: Studio): void {
  const look = (): void => {
    if (!store.state.document?.result) return;
    end();
    // a panel tells it where it is asked for; without the rest the page works as long as the network does
    setTimeout(() => void later().then(() => keepOffline(store)).catch(() => undefined), kRests);
  };
  const end = store.subscribe(look);
  look();
}

export class Page {
  private panels: Panel[] = [];
  private keyboard: Keyboard | null = null;
  private readonly canvas = h('canvas', { class: 'view', tabIndex: 0, role: 'application' });
  private readonly stage = h('div', { class: 'stage' });
  private readonly label = h('div', { class: 'handle-label', hidden: true });
  readonly view: View;
  private readonly thumbnails: Thumbnails;

  constructor(private readonly studio: Studio, private readonly root: HTMLElement, private readonly keeper: Keeper) {
    this.stage.append(this.canvas, this.label);
    root.append(this.stage);
    this.view = new View(studio, this.stage, this.canvas, (name, x, y) => this.hover(name, x, y));
    this.thumbnails = new Thumbnails(studio, () => (this.view.stage.shown ? this.view.stage.quality.moving.thumbnails : 0));
    keeper.follow(this.view, () => this.thumbnails.pictureOf(studio.document?.chosen ?? -1));
    studio.store.subscribe((state, previous) => {
      if (state.language !== previous.language) void this.speak(previous.language);
      else if (state.lengths !== previous.lengths) this.build();
      if (state.theme !== previous.theme) this.paint();
    });
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.paint());
    const calm = matchMedia('(prefers-reduced-motion: reduce)');
    this.thumbnails.still = calm.matches;
    studio.calm = calm.matches;
    if (calm.matches) studio.store.set({ loop: false, playing: false });
    this.dropFiles();
    fetchLater(studio);
    this.build();
    this.paint();
  }

  /** In the language that was chosen; in the one before where that cannot be fetched. */
  private async speak(before: Language): Promise<void> {
    const { store } = this.studio;
    try {
      await fetchLanguage(store.state.language);
    } catch (error) {
      store.set({ language: before });
      return this.studio.fail(error);
    }
    this.build();
  }

  private paint(): void {
    const { theme } = this.studio.store.state;
    document.documentElement.dataset['theme'] = shownTheme(theme);
    remember('theme', theme);
    this.view.paint();
    this.thumbnails.paint(this.view.stage.palette);
  }

  private build(): void {
    const { language, lengths } = this.studio.store.state;
    setLanguage(language);
    setLengthUnit(lengths);
    this.view.showUnits();
    remember('language', language);
    remember('lengths', lengths);
    document.title = t('title');
    this.keyboard?.dispose();
    for (const panel of this.panels) panel.dispose();
    const { studio } = this;
    const dialog = helpDialog();
    const openHelp = (): void => dialog.showModal();
    const gallery = new Gallery(studio, this.thumbnails);
    const verdict = new VerdictLine(studio);
    const timeline = new Timeline(studio);
    const start = new StartCards(studio);
    const notices = new Notices(studio);
    const wanted = new WantedBanner(studio);
    notices.element.append(wanted.element);
    const tabs = new Tabs(studio, {
      goals: new GoalsPanel(studio, this.view), adjust: new AdjustPanel(studio), criteria: new CriteriaPanel(studio),
      body: async () => new (await later()).BodyPanel(studio, this.thumbnails.portraits),
      plots: async () => new (await later()).PlotsPanel(studio),
      take: async () => {
        const { TakePanel, TakePicture, TakeFilm } = await import('./panels/taking');
        return new TakePanel(studio, new TakePicture(studio, this.view), new TakeFilm(studio, this.view));
      },
    });
    const top = new TopBar(studio, this.keeper, openHelp);
    const legend = new SpeedLegend(studio);
    const offline = new OfflineLine(studio);
    const menu = new ViewMenu(studio, this.view);
    this.panels = [gallery, verdict, timeline, start, notices, wanted, tabs, top, legend, offline, menu];
    this.canvas.setAttribute('aria-label', t('viewLabel'));
    this.stage.replaceChildren(this.canvas, this.label, notices.element, legend.element, offline.element, menu.element, h('div', { class: 'drop-here', 'aria-hidden': 'true' }, t('dropHere', { formats: characterFormats(studio.facts) })));
    const main = h('main', { class: 'work' }, gallery.element, h('div', { class: 'middle' }, this.stage, verdict.element, start.element, timeline.element), tabs.element);
    const skip = button(t('skipToView'), () => this.canvas.focus(), { class: 'skip' });
    this.root.replaceChildren(skip, top.element, main, dialog);
    this.keyboard = new Keyboard(studio, this.canvas, menu, openHelp);
  }

  private hover(name: string | null, x: number, y: number): void {
    const { document } = this.studio;
    this.label.hidden = name === null || document === null;
    if (name === null || document === null) return;
    this.label.textContent = placeWords(document, name);
    this.label.style.transform = `translate(${x + 14}px, ${y - 30}px)`;
  }

  private dropFiles(): void {
    const { body } = document;
    body.addEventListener('dragover', (event) => {
      event.preventDefault();
      body.classList.add('dropping');
    });
    body.addEventListener('dragleave', (event) => {
      if (event.relatedTarget === null) body.classList.remove('dropping');
    });
    body.addEventListener('drop', (event) => {
      event.preventDefault();
      body.classList.remove('dropping');
      void openFiles(this.studio, [...(event.dataTransfer?.files ?? [])]);
    });
  }
}
