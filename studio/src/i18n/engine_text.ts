// SPDX-License-Identifier: MIT
// The engine's sentences in the page's language, by their keys and values; lengths are in the unit that is chosen.
import type { Facts, Message, Quantity } from '../../../bindings/wasm/src/types';
import { lengths } from './lengths';
import { englishMessages } from './messages_en';

export interface Language {
  /** A sentence of a key, with {0} where its first value stands. */
  sentence(key: string): string | undefined;
  /** A value that is text. */
  word(text: string): string;
}

/** The engine's own sentences, but for those that the page has in other words. */
export const englishOf = (facts: Facts): Language => ({
  sentence: (key) => {
    if (key in englishMessages) return englishMessages[key];
    let hole = 0;
    const text = facts.messages.find((message) => message.key === key)?.text;
    return text?.replace(/\{\{|\}\}|\{[^{}]*\}/g, (found) => (found === '{{' || found === '}}' ? found.charAt(0) : `{${hole++}}`));
  },
  word: (text) => text,
});

function length({ number, unit }: Quantity): string {
  const { perMetre, digits } = lengths();
  return String(Number(((unit === 'mm' ? number / 1000 : number) * perMetre).toFixed(digits)));
}

/** What has no words in the language stays in English. */
export function wordsOf(message: Message, language: Language): string {
  if (typeof message === 'string') return language.word(message);
  if (!('key' in message)) return message.unit === undefined ? message.text : length(message);
  const { text, key, values } = message;
  return language.sentence(key)?.replace(/\{(\d+)\}( mm?\b)?/g, (_, index: string, unit = '') => {
    const value = values[Number(index)] ?? '';
    const isLength = typeof value === 'object' && 'number' in value && value.unit !== undefined;
    return wordsOf(value, language) + (isLength && unit ? ` ${lengths().name}` : unit);
  }) ?? text;
}
