// SPDX-License-Identifier: MIT
// The motion's series as the engine computed them, over time: angles in their range, torques beside strength, the centre of
// mass within the feet, the speed of the hand.
import type { Candidate, JointDescription, Series } from '../../../bindings/wasm/src/types';
import { freedomName, jointName, t } from '../i18n';
import { effectorPaths } from '../state/speed';
import type { Studio } from '../state/studio';
import { fill, h, type Panel, select } from './dom';
import { type Curve, Plot } from './plot';

const kMost = 5; // curves in one plot

function column(series: Series, index: number, of: (value: number, frame: number) => number = (value) => value): Float64Array {
  return Float64Array.from({ length: series.frames }, (_, f) => of(series.values[f * series.columns + index] ?? 0, f));
}

const spread = (values: Float64Array): number => Math.max(...values) - Math.min(...values);
const largest = (values: Float64Array): number => Math.max(...values.map(Math.abs));

export class PlotsPanel implements Panel {
  readonly element: HTMLElement;
  private readonly angles: Plot;
  private readonly torques: Plot;
  private readonly margin: Plot;
  private readonly speed: Plot;
  private readonly choice = h('div', { class: 'fields' });
  private readonly noFeet = h('p', { class: 'quiet', hidden: true }, t('noSupport'));
  private joint = '';
  private readonly ends: (() => void)[];

  constructor(private readonly studio: Studio) {
    const scrub = (time: number): void => studio.scrub(time);
    this.angles = new Plot(t('angles'), scrub);
    this.torques = new Plot(t('torques'), scrub);
    this.margin = new Plot(t('margin'), scrub);
    this.speed = new Plot(t('handSpeed'), scrub);
    this.element = h('div', { class: 'panel plots' }, h('p', { class: 'quiet' }, t('plotsIntro')), this.choice,
      this.angles.element, this.torques.element, this.margin.element, this.noFeet, this.speed.element);
    const draw = (): void => this.draw();
    const observer = new ResizeObserver(draw);
    observer.observe(this.element);
    this.ends = [
      studio.store.subscribe((state, previous) => {
        if (state.document !== previous.document || state.preview !== previous.preview) this.update();
      }),
      studio.clock.subscribe(draw),
      () => observer.disconnect(),
    ];
    this.update();
  }

  private update(): void {
    const candidate = this.studio.shown();
    const joints = this.studio.document?.character.description.joints ?? [];
    if (!candidate) return;
    fill(this.choice, h('label', {}, h('span', {}, t('angles').split(/[,（]/)[0] ?? ''), select(t('angles'),
      [['', t('mostUsed')], ...joints.map((joint) => [joint.name, freedomName(joint.name)] as const)], this.joint, (name) => {
        this.joint = name;
        this.update();
      })));
    const times = column(candidate.series.time, 0);
    this.angles.show({ times, low: -0.06, high: 1.06, curves: this.ofJoints(candidate, joints, 'angles'), levels: [
      { value: 0, label: t('limit') }, { value: 0.5, label: '50 %' }, { value: 1, label: t('limit') },
    ] });
    this.torques.show({ times, low: 0, high: 1.2, curves: this.ofJoints(candidate, joints, 'torques'), levels: [
      { value: 0.5, label: '50 %' }, { value: 1, label: t('limit') },
    ] });
    this.showMargin(candidate, times);
    this.showSpeed(candidate, times);
    this.draw();
  }

  /** Shares of the range or of strength: of the joint that was picked, or of those that use most of it. */
  private ofJoints(candidate: Candidate, joints: readonly JointDescription[], kind: 'angles' | 'torques'): Curve[] {
    const series = candidate.series[kind];
    const curves = joints.map((joint, index) => {
      const uppers = column(candidate.series.upper_limits, index);
      const share = (value: number, frame: number): number => {
        const [low, high] = kind === 'angles' ? [joint.limits_rad[0], uppers[frame] ?? 0] : joint.strength_nm;
        if (kind === 'angles') return high > low ? (value - low) / (high - low) : 0;
        return value > 0 ? value / Math.max(high, 1e-9) : value / Math.min(low, -1e-9);
      };
      return { name: joint.name, label: freedomName(joint.name), values: column(series, index, share) };
    });
    if (this.joint !== '') return curves.filter((curve) => curve.name === this.joint);
    const use = kind === 'angles' ? spread : largest;
    return curves.sort((a, b) => use(b.values) - use(a.values)).slice(0, kMost);
  }

  private showMargin(candidate: Candidate, times: Float64Array): void {
    const { support } = candidate.series;
    const none = support.columns < 2;
    this.margin.element.hidden = none;
    this.noFeet.hidden = !none;
    if (none) return;
    const cm = (value: number): number => value * 100;
    const curves = [{ label: t('com'), values: column(support, 0, cm) }, { label: t('cop'), values: column(support, 1, cm) }];
    const all = curves.flatMap((curve) => [...curve.values]);
    const high = Math.max(...all, 4) * 1.1;
    const low = Math.min(...all, -1) * 1.1;
    this.margin.show({ times, low, high, curves, digits: 1, unit: ' cm', levels: [
      { value: 0, label: '0' }, { value: Math.floor(high), label: String(Math.floor(high)) },
    ] });
  }

  private showSpeed(candidate: Candidate, times: Float64Array): void {
    const curves = effectorPaths(candidate).map(({ speeds }, k) => ({ label: jointName(candidate.summary.reached[k]?.effector ?? ''), values: speeds }));
    const high = Math.max(0.1, ...curves.flatMap((curve) => [...curve.values])) * 1.1;
    const level = Math.floor(high * 2) / 2 || Math.floor(high * 10) / 10;
    this.speed.show({ times, low: 0, high, curves, unit: ' m/s', levels: [{ value: level, label: String(level) }] });
  }

  private draw(): void {
    if (this.element.hidden || this.element.offsetParent === null) return;
    const { time } = this.studio.clock;
    for (const plot of [this.angles, this.torques, this.margin, this.speed]) plot.draw(time);
  }

  dispose(): void {
    for (const end of this.ends) end();
  }
}
