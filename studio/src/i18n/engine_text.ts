// SPDX-License-Identifier: MIT
// The engine's sentences in the page's language: which of its messages a text is, with what values, and the words
// for that. What has no words stays as the engine says it.
import type { Facts } from '../../../bindings/wasm/src/types';
import { japaneseMessages } from './messages_ja';

interface Known {
  key: string;
  pattern: RegExp;
}

/** How deep a value of a message may hold another one. */
const kDeepest = 3;
const kHole = /\{[^{}]*\}/g;

const escaped = (text: string): string => text.replace(/[$()*+.?[\\\]^{|}]/g, String.raw`\$&`);

/** Messages with the most words of their own come first, as others may hold for the same text. */
function patterns(facts: Facts): Known[] {
  const own = (text: string): number => text.replaceAll(kHole, '').length;
  return [...facts.messages].sort((a, b) => own(b.text) - own(a.text)).map(({ key, text }) => ({
    key, pattern: new RegExp(`^${text.split(kHole).map(escaped).join('(.*?)')}$`, 's'),
  }));
}

export class EngineTexts {
  private readonly known: readonly Known[];

  constructor(facts: Facts, private readonly word: (value: string) => string) {
    this.known = patterns(facts);
  }

  /** The sentence in Japanese; undefined where no message is known by it. */
  japanese(text: string, deep = 0): string | undefined {
    for (const { key, pattern } of this.known) {
      const match = pattern.exec(text);
      const words = japaneseMessages[key];
      if (!match || words === undefined) continue;
      return words.replaceAll(/\{(\d+)\}/g, (_, index: string) => this.value(match[Number(index) + 1] ?? '', deep));
    }
    return undefined;
  }

  /** The same with the place before it: "hero.glb: no left leg: …". */
  withPlace(text: string): string {
    const whole = this.japanese(text);
    if (whole !== undefined) return whole;
    for (let at = text.indexOf(': '); at > 0; at = text.indexOf(': ', at + 1)) {
      const rest = this.japanese(text.slice(at + 2));
      if (rest !== undefined) return `${this.word(text.slice(0, at))}：${rest}`;
    }
    return text;
  }

  private value(text: string, deep: number): string {
    return (deep < kDeepest ? this.japanese(text, deep + 1) : undefined) ?? this.word(text);
  }
}

/** Keys of the engine's messages that the page has no words for. */
export const wordlessMessages = (facts: Facts): string[] => facts.messages.map(({ key }) => key).filter((key) => !(key in japaneseMessages));
