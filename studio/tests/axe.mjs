// SPDX-License-Identifier: MIT
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** What axe finds serious within an element of a page, as lines of text. */
export async function seriousFindings(page, selector) {
  await page.evaluate(`${axe}; 0`); // not as an element, which the page forbids
  return page.evaluate(async (within) => {
    const { violations } = await window.axe.run(within);
    return violations.filter(({ impact }) => impact === 'serious' || impact === 'critical')
      .flatMap(({ id, nodes }) => nodes.map(({ html }) => `${id}: ${html}`));
  }, selector);
}
