// SPDX-License-Identifier: MIT
// A person's actions, in one place: each panel and key calls these. Steps that undo knows go through `commit`.
import type { Candidate, Character, Generated, Goal, Quat, Series, Summary, Task, Vec3 } from '../../../bindings/wasm/src/types';
import { remember } from '../kept/memory';
import type { History } from './history';
import { ranking } from './criteria';
import { exportOptions } from './file_choices';
import { candidateAt, type Document, goalOf, withEdits } from './model';
import { moved, withGoal } from './places';
import { startOf } from './start';
import { madeSymmetric, withMirrorImage } from './symmetry';
import { moreOf, previewTask, taskOf } from './task';
import { assigned, listed } from './trial';
import { Timings } from './timings';
import { isMet, missOf } from './verdict';
import { Workbench } from './workbench';

/** Key by which the browser remembers that the user has dragged before. */
export const kHint = 'hint';

export class Studio extends Workbench {
  readonly timings = new Timings();
  private running: AbortController | null = null;
  private warm = false;
  private takenBack = ''; // the drag of a slider that was given up last
  private interrupted = false; // a drag has ended a search
  private wentBack = 0; // times, over the steps
  // what is asked for of a motion and has no answer yet: the engine drops a call for the next one
  private asked: { readonly result: Document['result']; readonly index: number; readonly assignments: Readonly<Record<string, string>> } | null = null;

  // ---- Steps -------------------------------------------------------------------------------------

  undo(): void {
    this.goBack((history) => history.undo());
  }

  redo(): void {
    this.goBack((history) => history.redo());
  }

  private goBack(step: (history: History<Document>) => Document): void {
    if (this.history === null) return;
    this.cancel();
    ++this.wentBack;
    this.asked = null;
    const document = step(this.history);
    this.publish(document, { preview: null, notice: null, dragging: false, trial: null });
    if (document.result === null) void this.search();
  }

  private takeBack(key: string): void {
    if (this.history?.takeBack(key)) this.publish(this.history.value, { notice: null });
  }

  // ---- Goals -------------------------------------------------------------------------------------

  select(effector: string): void {
    this.store.set({ selected: effector });
  }

  /** Hides the first hint about dragging, at later visits too. */
  learnHint(): void {
    if (!this.store.state.hint) return;
    this.store.set({ hint: false });
    remember(kHint, 'learned');
  }

  /** While a goal or a thing is dragged: the body follows by a quick search. */
  async drag(name: string, position: Vec3, rotation?: Quat): Promise<void> {
    const { document } = this;
    if (document === null) return;
    this.learnHint();
    this.store.set({ selected: name });
    await this.attempt(moved(document, name, position, rotation));
  }

  /** It is where it shall be: the whole search. */
  drop(name: string, position: Vec3, rotation?: Quat): Promise<void> {
    const { document } = this;
    if (document === null) return Promise.resolve();
    this.learnHint();
    this.store.set({ selected: name });
    return this.settle(moved(document, name, position, rotation));
  }

  /** What a person has in hand, as it would be now. */
  async attempt(asked: Document): Promise<void> {
    const trial = this.alike(asked);
    const since = performance.now();
    this.interrupted ||= this.running !== null;
    this.cancel();
    this.store.set({ dragging: true, trial });
    try {
      const found = await this.engine.preview(trial.character, previewTask(this.facts, trial));
      const candidate = found?.candidates[0];
      if (!found || !candidate || !this.store.state.dragging) return;
      this.store.set({ preview: candidate, previewRemaining_mm: found.summary.remaining_mm });
      this.timings.add(this.timings.dragToPose, since, found.engine_ms);
    } catch (error) {
      this.fail(error);
    }
  }

  /** With the other hand's goal as the mirror image, where hands move alike. */
  private alike(asked: Document): Document {
    return this.document && this.store.state.symmetric ? madeSymmetric(this.document, asked) : asked;
  }

  /** Hands move alike from now on, or each by itself; the hand that is selected shows the other the way. */
  setSymmetric(symmetric: boolean): Promise<void> {
    const { document, store } = this;
    store.set({ symmetric });
    const hands = [store.state.selected, 'right_hand', 'left_hand'];
    const hand = hands.find((name) => name.endsWith('_hand') && document && goalOf(document, name));
    return symmetric && document && hand ? this.settle(withMirrorImage(document, hand)) : Promise.resolve();
  }

  /** All is as it was before the drag. */
  abandon(): void {
    if (!this.store.state.dragging) return;
    this.store.set({ dragging: false, trial: null, preview: null });
    if (this.interrupted) void this.search();
  }

  /** A step that asks for other motions. */
  settle(document: Document): Promise<void> {
    this.store.set({ dragging: false, trial: null });
    this.commit(this.alike(document));
    return this.search();
  }

  /** Other settings of a goal: a load, a rotation or none. */
  changeGoal(effector: string, change: (goal: Goal) => Goal): Promise<void> {
    const document = this.document;
    const goal = document && goalOf(document, effector);
    return document && goal ? this.settle(withGoal(document, change(goal))) : Promise.resolve();
  }

  addGoal(effector: string): Promise<void> {
    const document = this.document;
    if (document === null || goalOf(document, effector)) return Promise.resolve();
    return this.drop(effector, startOf(document.character, effector));
  }

  removeGoal(effector: string): Promise<void> {
    const document = this.document;
    if (document === null || document.goals.length < 2) return Promise.resolve();
    return this.settle({ ...document, goals: document.goals.filter((goal) => goal.effector !== effector) });
  }

  // ---- Search ------------------------------------------------------------------------------------

  /** All candidates anew for the document as it is; ends an earlier search. */
  async search(): Promise<void> {
    const document = this.document;
    if (document === null) return;
    this.cancel();
    this.interrupted = false;
    const controller = new AbortController();
    this.running = controller;
    const since = performance.now();
    this.store.set({ search: { fraction: 0, best: Infinity }, notice: null });
    try {
      const result = await this.engine.generate(document.character, taskOf(this.facts, document), {
        signal: controller.signal,
        onProgress: (progress) => {
          if (this.running !== controller) return;
          this.store.set({ search: { fraction: progress.fraction, best: progress.best_score } });
        },
      });
      if (this.running !== controller) return;
      this.timings.add(this.timings.search, since, result.engine_ms);
      const now = this.document ?? document;
      const found: Document = { ...now, result, chosen: 0, compared: null, edits: {} };
      this.amend({ ...found, chosen: ranking(found)[0] ?? 0 });
      this.store.set({ preview: null });
      this.present();
      void this.warmUp(found);
      const miss = missOf(result.summary);
      if (miss) this.tellToo({ kind: 'text', ...miss });
    } catch (error) {
      if (this.running === controller) this.store.set({ preview: null });
      this.fail(error);
    } finally {
      if (this.running === controller) {
        this.running = null;
        this.store.set({ search: null });
      }
    }
  }

  /** The first quick searches take several times as long as later ones, until the browser has optimised the code: nobody waits for these. */
  private async warmUp(document: Document): Promise<void> {
    if (this.warm) return;
    this.warm = true;
    await this.eye?.firstPicture();
    try {
      for (let k = 0; k < 8 && !this.store.state.dragging; ++k) await this.engine.preview(document.character, previewTask(this.facts, document));
    } catch {
      // the drag reports errors
    }
  }

  /** The same with other random numbers. */
  searchAgain(seed = true): Promise<void> {
    const document = this.document;
    if (document === null) return Promise.resolve();
    const { seed: old } = document.settings;
    const next = old < Number.MAX_SAFE_INTEGER ? old + 1 : 0;
    const settings = { ...document.settings, seed: seed && document.result ? next : old };
    this.commit({ ...document, settings });
    return this.search();
  }

  /** A result's motions anew, which can be stopped as a search can. */
  async restore(character: Character, summary: Summary): Promise<Generated> {
    this.cancel();
    const controller = new AbortController();
    this.running = controller;
    this.store.set({ search: { fraction: 0, best: Infinity } });
    try {
      return await this.engine.restore(character, summary, {
        signal: controller.signal,
        onProgress: ({ fraction, best_score }) => {
          if (this.running === controller) this.store.set({ search: { fraction, best: best_score } });
        },
      });
    } finally {
      if (this.running === controller) {
        this.running = null;
        this.store.set({ search: null });
      }
    }
  }

  cancel(): void {
    this.running?.abort();
    this.running = null;
    this.store.set({ search: null });
  }

  // ---- Candidates --------------------------------------------------------------------------------

  choose(index: number): void {
    const document = this.document;
    if (document === null || candidateAt(document, index) === null || index === document.chosen) return;
    this.commit({ ...document, chosen: index, compared: document.compared === index ? null : document.compared });
    this.store.set({ preview: null });
    this.present();
  }

  /** Shows another candidate beside the chosen one; again: no more. */
  compare(index: number): void {
    const document = this.document;
    if (document === null || index === document.chosen) return;
    this.commit({ ...document, compared: document.compared === index ? null : index });
    this.store.set({ hint: false }); // it would cover the figures' signs
  }

  // ---- Parameters --------------------------------------------------------------------------------

  /** The slider is back where it was: the step that its drag has made is none. */
  takeBackEdit(drag: string): void {
    this.takenBack = drag;
    this.asked = null;
    this.takeBack(`edit ${this.document?.chosen} ${drag}`);
  }

  /** Plays the chosen candidate anew with changed parameters. Changes of one `drag` are one step. */
  async edit(assignments: Readonly<Record<string, string>>, drag?: string): Promise<void> {
    const document = this.document;
    if (!document?.result) return;
    const since = performance.now();
    const { wentBack } = this;
    const index = document.chosen;
    const { result } = document;
    const waiting = this.asked?.result === result && this.asked.index === index ? this.asked.assignments : {};
    const asked = (this.asked = { result, index, assignments: { ...waiting, ...assignments } });
    const { base, all } = assigned(document, asked.assignments);
    try {
      const generated = await this.engine.replay(document.character, base.summary, base.candidate, listed(all));
      const now = this.document;
      if (!generated || !now || now.result !== document.result || (drag !== undefined && drag === this.takenBack)) return;
      if (wentBack !== this.wentBack) return; // it has been undone before it came
      const edits = { ...now.edits, [index]: { base, assignments: all, generated } };
      this.commit({ ...now, edits }, drag === undefined ? undefined : `edit ${index} ${drag}`);
      this.timings.add(this.timings.sliderToMotion, since, generated.engine_ms);
      const missed = !isMet(generated.summary.remaining_mm);
      this.store.set({
        preview: null,
        notice: missed
          ? { kind: 'text', key: 'editMisses', values: { length: generated.summary.remaining_mm / 1000 } }
          : null,
      });
    } catch (error) {
      this.fail(error);
    } finally {
      if (this.asked === asked) this.asked = null;
    }
  }

  resetEdits(): void {
    const document = this.document;
    if (document === null || document.edits[document.chosen] === undefined) return;
    const edits = { ...document.edits };
    delete edits[document.chosen];
    this.commit({ ...document, edits });
  }

  /** The same with the other side's hands and feet. */
  async mirror(): Promise<void> {
    const document = this.document;
    if (!document?.result) return;
    this.cancel();
    try {
      const mirrored = await this.mirrored(document, document.result);
      // a change that was on its way, such as a slider's last one, goes along
      if (this.document !== document) return await this.mirror();
      this.commit(mirrored);
      this.store.set({ selected: mirrored.goals[0]?.effector ?? this.store.state.selected });
      this.lookMirrored();
    } catch (error) {
      this.fail(error);
    }
  }

  /** From the other side, where the hand that acts is now. */
  private lookMirrored(): void {
    if (!this.eye) return;
    const { position_m: [x, y, z], target_m: [u, v, w] } = this.eye.look();
    this.eye.lookFrom({ position_m: [-x, y, z], target_m: [-u, v, w] });
  }

  private async mirrored(document: Document, found: Generated): Promise<Document> {
    const { character } = document;
    const result = await this.engine.mirror(character, found.summary);
    const edits: Record<number, Document['edits'][number]> = {};
    for (const [index, edit] of Object.entries(document.edits)) {
      const generated = await this.engine.mirror(character, edit.generated.summary);
      edits[Number(index)] = { base: { summary: generated.summary, candidate: 1 }, assignments: {}, generated };
    }
    const task = result.summary['task'] as Task;
    const settings = { ...document.settings, more: moreOf(task) };
    return { ...document, result, edits, settings, goals: task.goals ?? [], fixed: task.fixed ?? [] };
  }

  /** Keeps the locked and given values, and searches the rest. */
  searchRest(fixed: readonly string[]): Promise<void> {
    const document = this.document;
    if (document === null) return Promise.resolve();
    this.commit({ ...document, fixed: [...fixed] });
    return this.search();
  }

  // ---- Criteria ----------------------------------------------------------------------------------

  weigh(name: string, weight: number, drag: string): void {
    const document = this.document;
    if (document === null) return;
    this.commit({ ...document, weights: { ...document.weights, [name]: weight } }, `weigh ${drag}`);
  }

  takeBackWeight(drag: string): void {
    this.takeBack(`weigh ${drag}`);
  }

  // ---- Whole documents ---------------------------------------------------------------------------

  /** A document that is complete but for its motions. */
  begin(document: Document): Promise<void> {
    this.cancel();
    this.commit(document);
    this.store.set({ selected: document.goals[0]?.effector ?? 'right_hand', preview: null, notice: null });
    if (document.result !== null) return Promise.resolve();
    void this.showFirstPicture(document);
    return this.search();
  }

  /** Something to see while the first search runs. */
  private async showFirstPicture(document: Document): Promise<void> {
    try {
      const found = await this.engine.preview(document.character, previewTask(this.facts, document));
      const candidate = found?.candidates[0];
      if (!candidate || this.document !== document || this.store.state.dragging) return;
      this.clock.duration = candidate.summary.duration_s;
      this.store.set({ preview: candidate, previewRemaining_mm: found.summary.remaining_mm });
    } catch {
      // the search reports errors
    }
  }

  // ---- What files are made of --------------------------------------------------------------------

  async exported(format: string, index?: number): Promise<Uint8Array> {
    const document = this.document;
    if (!document?.result) throw new Error('no motion');
    const which = index ?? document.chosen;
    const [summary, candidate] = this.source(document.result, document.edits, which);
    return this.engine.export(document.character, summary, candidate, format, exportOptions(this.store.state, document.character));
  }

  /** All motions in one GLB, on the character's own file. */
  async exportedTogether(): Promise<Uint8Array> {
    const document = this.document;
    if (!document?.result) throw new Error('no motion');
    const summary = { ...document.result.summary, candidates: withEdits(document) };
    return this.engine.export(document.character, summary, 0, 'glb', exportOptions(this.store.state, document.character));
  }

  /** The nodes of a motion at the rate of files. */
  async sampledNodes(index: number): Promise<Record<'time' | 'node_translations' | 'node_rotations', Series>> {
    const document = this.document;
    if (!document?.result) throw new Error('no motion');
    const [summary, candidate] = this.source(document.result, document.edits, index);
    const names = ['time', 'node_translations', 'node_rotations'] as const;
    return this.engine.sampled(document.character, summary, candidate, names, this.store.state.fps);
  }

  /** The result that a motion is in, and its number there. */
  private source(result: Generated, edits: Document['edits'], index: number): [Summary, number] {
    const edit = edits[index];
    return edit ? [edit.generated.summary, 1] : [result.summary, index + 1];
  }

  /** The strip figure as SVG; null where the body has none, or where it has been replaced meanwhile. */
  async strip(index: number, candidate: Candidate): Promise<Uint8Array | null> {
    await this.eye?.firstPicture();
    const document = this.document;
    if (document === null || candidateAt(document, index) !== candidate) return null;
    try {
      return await this.exported('svg', index);
    } catch {
      return null;
    }
  }

  open(spec: Character['spec'], bytes?: Uint8Array): Promise<Character> {
    return this.engine.open(spec, bytes);
  }
}
