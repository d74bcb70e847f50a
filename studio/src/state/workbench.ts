// SPDX-License-Identifier: MIT
// The document on the table: its steps, its display over time, and messages about it.
import type { Candidate, Character, Engine, Facts } from '../../../bindings/wasm/src/types';
import { failureOf } from '../engine/connect';
import { PackedError } from '../plain_gltf/packed';
import { Library } from '../kept/library';
import type { Look } from '../kept/work';
import { PartError } from '../offline/part';
import { Clock } from './clock';
import { History } from './history';
import { candidateAt, chosenCandidate, type Document, initialState, type Notice, type State } from './model';
import { placeOf } from './places';
import { hasRoom, isSameFile, shelved } from './shelf';
import { Store } from './store';

/** The view, to those who keep or bring back from where it is seen. */
export interface Eye {
  look(): Look;
  lookFrom(look: Look): void;
  onLook(listener: () => void): void;
  /** Once the page has its first picture: a machine has then time for what nobody waits for. */
  firstPicture(): Promise<void>;
}

/** The message of an error; null if the user cancelled. */
export function noticeOf(error: unknown, about?: string): Notice | null {
  if (error instanceof PartError) return { kind: 'text', key: 'partFailed' };
  if (error instanceof PackedError) return { kind: 'text', key: 'badPacked', values: { name: about ?? '' } };
  const failure = failureOf(error);
  return failure && { kind: 'failure', failure, about };
}

export class Workbench {
  readonly store = new Store<State>(initialState);
  readonly clock = new Clock();
  readonly library = new Library();
  eye: Eye | null = null;
  /** From where the view is to be seen once there is one. */
  firstLook: Look | null = null;
  /** Little shall move, as the person's system says. */
  calm = false;
  protected history: History<Document> | null = null;
  private characters = new Set<Character>();

  constructor(readonly engine: Engine) {}

  get facts(): Facts {
    return this.engine.facts;
  }

  get document(): Document | null {
    return this.store.state.document;
  }

  commit(document: Document, key?: string): void {
    if (this.history === null) this.history = new History(document);
    else this.history.push(document, key);
    this.publish(document);
    this.forget();
  }

  /** Another work is on the table: undo goes back no further. */
  forgetSteps(): void {
    if (this.history === null) return;
    this.history.reset(this.history.value);
    this.publish(this.history.value);
    this.forget();
  }

  /** What came of the last step. */
  protected amend(document: Document): void {
    this.history?.amend(document);
    this.publish(document);
  }

  protected publish(document: Document, more: Partial<State> = {}): void {
    const candidate = candidateAt(document, document.chosen);
    if (candidate !== null) this.clock.duration = candidate.summary.duration_s;
    const { selected } = this.store.state;
    this.store.set({
      document,
      shelf: shelved(this.store.state.shelf, document),
      selected: placeOf(document, selected) ? selected : (document.goals[0]?.effector ?? selected),
      canUndo: this.history?.canUndo ?? false,
      canRedo: this.history?.canRedo ?? false,
      ...more,
    });
  }

  /** Adds a character to the opened ones, unless it is there; false if there is no room. */
  shelve(document: Document): boolean {
    const { shelf } = this.store.state;
    const isThere = shelf.some(({ character }) => isSameFile(character, document.character));
    const fits = !isThere && hasRoom([...shelf, document]);
    if (fits) this.store.set({ shelf: [...shelf, document] });
    else this.engine.close(document.character);
    return isThere || fits;
  }

  /** Takes a character off the shelf; the one at hand stays. */
  takeOff(document: Document): void {
    if (document.character === this.document?.character) return;
    this.store.set({ shelf: this.store.state.shelf.filter((other) => other !== document) });
    this.forget();
  }

  /** Lets go of characters that no step and no place of the shelf has any more. */
  private forget(): void {
    const needed = new Set([...this.history!.all(), ...this.store.state.shelf].map((document) => document.character));
    for (const character of needed) this.characters.add(character);
    for (const character of this.characters) {
      if (needed.has(character)) continue;
      this.characters.delete(character);
      this.engine.close(character);
    }
  }

  // ---- Playing -----------------------------------------------------------------------------------

  /** Plays a new motion, or shows its end to users who prefer reduced motion. */
  present(): void {
    this.clock.time = this.calm ? this.clock.duration : 0;
    this.store.set({ playing: !this.calm });
  }

  play(playing: boolean): void {
    if (playing && this.clock.time >= this.clock.duration) this.clock.time = 0;
    this.store.set({ playing });
  }

  scrub(time: number): void {
    this.store.set({ playing: false });
    this.clock.time = time;
  }

  // ---- Messages ----------------------------------------------------------------------------------

  tell(notice: Notice | null): void {
    this.store.set({ notice });
  }

  /** The picture is gone, which is told while it lasts, or back. */
  showLost(pictureLost: boolean): void {
    this.store.set({ pictureLost });
    if (!pictureLost) this.tell({ kind: 'text', key: 'pictureBack' });
  }

  /** Beside what is told already. */
  tellToo(notice: Notice): void {
    const { notice: now } = this.store.state;
    this.tell(now ? { kind: 'several', of: now.kind === 'several' ? [...now.of, notice] : [now, notice] } : notice);
  }

  fail(error: unknown, about?: string): void {
    const notice = noticeOf(error, about);
    if (notice) this.tell(notice);
  }

  chosen(): Candidate | null {
    return chosenCandidate(this.document);
  }

  shown(): Candidate | null {
    const { document, preview } = this.store.state;
    return preview ?? (document === null ? null : candidateAt(document, document.chosen));
  }
}
