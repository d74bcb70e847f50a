// SPDX-License-Identifier: MIT
// The motion's series as the engine computed them, over time: angles in their range, torques beside strength, the centre of
// mass within the feet, the speed of the hand.
import type { Candidate, JointDescription } from '../../../bindings/wasm/src/types';
import { engineWord, freedomName, jointName, t } from '../i18n';
import { lengths } from '../i18n/lengths';
import { ranking } from '../state/criteria';
import { columnOf, plotTable, rangeShare, strengthShare } from '../state/plot_table';
import { effectorPaths } from '../state/speed';
import type { Studio } from '../state/studio';
import { bodyName, pngOf, save } from '../state/take_away';
import { shownTheme } from '../view/palette';
import { button, fill, h, type Panel, select } from './dom';
import { Plot } from './plot';
import { freedomColour, sideOf } from './plot_colours';
import { type Curve, type Ink, plotSheet, rangeOf } from './plot_svg';

const kMost = 5; // curves in one plot
const kAngles = [-0.06, 1.06] as const;
const kTorques = [0, 1.06] as const;

const spread = (values: Float64Array): number => Math.max(...values) - Math.min(...values);
const largest = (values: Float64Array): number => Math.max(...values.map(Math.abs));

/** Strength is passed now and then; each whole multiple of it has its line, or each second, fourth, … where they are many. */
function strengthLevels(high: number): { value: number; label: string }[] {
  const step = 2 ** Math.max(0, Math.ceil(Math.log2(high / 5)));
  const more = Array.from({ length: Math.floor(high / step) }, (_, k) => step * (k + 1)).filter((value) => value > 1);
  return [...(high < 3 ? [0.5] : []), 1, ...more].map((value) => ({ value, label: `${Math.round(100 * value)} %` }));
}

export class PlotsPanel implements Panel {
  readonly element: HTMLElement;
  private readonly angles: Plot;
  private readonly torques: Plot;
  private readonly margin: Plot;
  private readonly speed: Plot;
  private readonly choice = h('div', { class: 'fields' });
  private readonly noFeet = h('p', { class: 'quiet', hidden: true }, t('noSupport'));
  private joint = '';
  private listed: readonly JointDescription[] | null = null; // whose choice is there
  private ink: Ink = { text: '', line: '', paper: '' };
  private readonly ends: (() => void)[];

  constructor(private readonly studio: Studio) {
    const scrub = (time: number): void => studio.scrub(time);
    this.angles = new Plot(t('angles'), scrub);
    this.torques = new Plot(t('torques'), scrub);
    this.margin = new Plot(t('margin'), scrub);
    this.speed = new Plot(t('handSpeed'), scrub);
    const saved = (['svg', 'png', 'csv'] as const).map((format) =>
      button(t(format === 'csv' ? 'plotTable' : 'plotPicture', { format: format.toUpperCase() }), () => void this.save(format), { 'data-plots': format }));
    this.element = h('div', { class: 'panel plots' }, h('p', { class: 'quiet' }, t('plotsIntro')), this.choice,
      this.angles.element, this.torques.element, this.margin.element, this.noFeet, this.speed.element, h('div', { class: 'buttons' }, ...saved));
    const draw = (): void => this.draw();
    const observer = new ResizeObserver(draw);
    observer.observe(this.element);
    const system = matchMedia('(prefers-color-scheme: dark)');
    const recolour = (): void => this.update();
    system.addEventListener('change', recolour);
    this.ends = [
      studio.store.subscribe((state, previous) => {
        if (state.document !== previous.document || state.preview !== previous.preview || state.theme !== previous.theme) this.update();
      }),
      studio.clock.subscribe(draw),
      () => observer.disconnect(),
      () => system.removeEventListener('change', recolour),
    ];
    this.update();
  }

  private get dark(): boolean {
    return shownTheme(this.studio.store.state.theme) === 'dark';
  }

  private update(): void {
    const candidate = this.studio.shown();
    const joints = this.studio.document?.character.description.joints ?? [];
    if (!candidate) return;
    if (joints !== this.listed) this.list(joints);
    const style = getComputedStyle(document.documentElement);
    this.ink = { text: style.getPropertyValue('--text-quiet'), line: style.getPropertyValue('--line-strong'), paper: style.getPropertyValue('--panel') };
    const times = columnOf(candidate.series.time, 0);
    const angles = this.ofJoints(candidate, joints, 'angles');
    const [low, high] = rangeOf(angles, ...kAngles);
    this.angles.show({ times, low, high, curves: angles, levels: [
      { value: 0, label: t('limit') }, { value: 0.5, label: '50 %' }, { value: 1, label: t('limit') },
    ] });
    const torques = this.ofJoints(candidate, joints, 'torques');
    const [least, most] = rangeOf(torques, ...kTorques);
    this.torques.show({ times, low: least, high: most, curves: torques, levels: strengthLevels(most) });
    this.showMargin(candidate, times);
    this.showSpeed(candidate, times);
    this.draw();
  }

  /** The choice of a joint, which stays while the body does, and the focus in it. */
  private list(joints: readonly JointDescription[]): void {
    this.listed = joints;
    if (!joints.some(({ name }) => name === this.joint)) this.joint = '';
    fill(this.choice, h('label', {}, h('span', {}, t('angles').split(/[,（]/)[0] ?? ''), select(t('angles'),
      [['', t('mostUsed')], ...joints.map((joint) => [joint.name, freedomName(joint.name)] as const)], this.joint, (name) => {
        this.joint = name;
        this.update();
      })));
  }

  /** Shares of the range or of strength: of the joint that was picked, or of those that use most of it. */
  private ofJoints(candidate: Candidate, joints: readonly JointDescription[], kind: 'angles' | 'torques'): Curve[] {
    const { description } = this.studio.document!.character;
    const share = kind === 'angles' ? rangeShare : strengthShare;
    const curves = joints.map(({ name }, index): Curve => ({
      name, label: freedomName(name), side: sideOf(name), colour: freedomColour(name, index, this.dark), values: share(description, candidate, index),
    }));
    if (this.joint !== '') return curves.filter((curve) => curve.name === this.joint);
    const use = kind === 'angles' ? spread : largest;
    return curves.sort((a, b) => use(b.values) - use(a.values)).slice(0, kMost);
  }

  private showMargin(candidate: Candidate, times: Float64Array): void {
    const { support } = candidate.series;
    const none = support.columns < 2;
    this.noFeet.hidden = !none;
    if (none) return this.margin.show(null);
    const { perMetre, name: unit } = lengths();
    const curves = ([['com', 0, '--plot-3'], ['cop', 1, '--plot-2']] as const).map(([key, index, colour]): Curve => ({
      name: key, label: t(key), side: 'middle', colour: getComputedStyle(document.documentElement).getPropertyValue(colour), values: columnOf(support, index, (value) => value * perMetre),
    }));
    const [low, high] = rangeOf(curves, -0.01 * perMetre, 0.044 * perMetre);
    this.margin.show({ times, low, high, curves, digits: 1, unit: ` ${unit}`, levels: [
      ...(low < -0.05 * perMetre ? [{ value: Math.ceil(low), label: String(Math.ceil(low)) }] : []), { value: 0, label: '0' }, { value: Math.floor(high), label: String(Math.floor(high)) },
    ] });
  }

  private showSpeed(candidate: Candidate, times: Float64Array): void {
    const colours = getComputedStyle(document.documentElement);
    const curves = effectorPaths(candidate).map(({ speeds }, k): Curve => {
      const name = candidate.summary.reached[k]?.effector ?? '';
      return { name, label: jointName(name), side: sideOf(name), colour: colours.getPropertyValue(`--plot-${(k % 5) + 1}`), values: speeds };
    });
    const [, high] = rangeOf(curves, 0, 0.11);
    const level = Math.floor(high * 2) / 2 || Math.floor(high * 10) / 10;
    this.speed.show({ times, low: 0, high, curves, unit: ' m/s', levels: [{ value: level, label: String(level) }] });
  }

  private draw(): void {
    if (this.element.hidden || this.element.offsetParent === null) return;
    const { time } = this.studio.clock;
    for (const plot of [this.angles, this.torques, this.margin, this.speed]) plot.draw(time, this.ink);
  }

  private async save(format: 'svg' | 'png' | 'csv'): Promise<void> {
    const { document: work } = this.studio;
    const candidate = this.studio.chosen();
    if (!work || !candidate) return;
    const name = `shigusa-${bodyName(work.character)}-${work.chosen + 1}-plots.${format}`;
    const encode = (text: string): Uint8Array => new TextEncoder().encode(text);
    try {
      if (format === 'csv') return save({ name, bytes: encode(plotTable(work.character.description, candidate)), type: 'text/csv' });
      const plots = [this.angles, this.torques, this.margin, this.speed].flatMap(({ title, data }) => (data ? [{ title, data }] : []));
      const sheet = encode(plotSheet(`${engineWord('bodies', work.character.description.name)} — ${t('candidate', { n: ranking(work).indexOf(work.chosen) + 1 })}`, plots, this.ink));
      save({ name, bytes: format === 'svg' ? sheet : await pngOf(sheet), type: format === 'svg' ? 'image/svg+xml' : 'image/png' });
    } catch (error) {
      this.studio.fail(error);
    }
  }

  dispose(): void {
    for (const end of this.ends) end();
  }
}
