// SPDX-License-Identifier: MIT
// render_formulas.mjs SITE: sets the formulas of the built pages by KaTeX, so that a reader's browser need not. A formula
// that KaTeX does not understand fails.
import { createRequire } from 'node:module';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const katex = createRequire(import.meta.url)('/usr/share/javascript/katex/katex.js');
const forms = [
  { pattern: /<span class="arithmatex">\\\(([\s\S]*?)\\\)<\/span>/g, displayMode: false },
  { pattern: /<div class="arithmatex">\\\[([\s\S]*?)\\\]<\/div>/g, displayMode: true },
];
const entities = { amp: '&', lt: '<', gt: '>', quot: '"', '#39': "'" };

/** What HTML says with entities. */
const unescaped = (text) => text.replace(/&(amp|lt|gt|quot|#39);/g, (_, name) => entities[name]);

const [site] = process.argv.slice(2);
let failed = 0;
let formulas = 0;
for (const path of readdirSync(site, { recursive: true }).filter((name) => name.endsWith('.html'))) {
  const before = readFileSync(join(site, path), 'utf8');
  let after = before;
  for (const { pattern, displayMode } of forms) {
    after = after.replace(pattern, (_, formula) => {
      formulas += 1;
      try {
        const set = katex.renderToString(unescaped(formula), { displayMode, throwOnError: true, strict: 'error' });
        return displayMode ? `<div class="formula">${set}</div>` : set;
      } catch (error) {
        console.error(`render_formulas: ${path}: ${error.message}`);
        failed += 1;
        return formula;
      }
    });
  }
  if (after.includes('class="arithmatex"')) {
    console.error(`render_formulas: ${path}: a formula is of neither form`);
    failed += 1;
  }
  if (after !== before) writeFileSync(join(site, path), after);
}
if (formulas === 0) console.error(`render_formulas: no formula in ${site}`);
process.exit(failed === 0 && formulas > 0 ? 0 : 1);
