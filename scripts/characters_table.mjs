// SPDX-License-Identifier: MIT
// characters_table.mjs FOLDER FILES: used by check_characters. Prints a table of FOLDER/*.json, one file per character, and
// sums over it; fails if a sum is beyond its floor or ceiling. FILES is the number of named characters, 0 for all.
import { readFileSync, readdirSync } from 'node:fs';

const [work, asked] = process.argv.slice(2);
const lines = readdirSync(work).sort().filter((name) => name.endsWith('.json')).map((name) => readFileSync(`${work}/${name}`, 'utf8'));
const rows = lines.filter(Boolean).map(JSON.parse);
const goals = rows.flatMap((row) => Object.values(row.goals));
const names = Object.keys(rows[0]?.goals ?? {});
const isMade = (goal, least) => goal.met && [...goal.verdicts].filter((v) => v !== 'i').length >= least;
const cell = (goal) => [goal.verdicts ? `\`${goal.verdicts}\`` : 'refused', goal.met || !goal.verdicts ? '' : 'not met', goal.longer && `${goal.longer.toFixed(2)} ×`,
  goal.deepest_mm === undefined ? '' : `${goal.deepest_mm} (${goal.deeper_mm}) mm`].filter(Boolean).join(', ');
console.log(`| file | ${names.join(' | ')} |\n|---|${'---|'.repeat(names.length)}`);
for (const { file, goals } of rows) console.log(`| \`${file}\` | ${Object.values(goals).map(cell).join(' | ')} |`);
const share = (holds) => (100 * goals.filter(holds).length) / goals.length;
// what is told to be impossible is counted as such, and not once more by how deep it is
const most = (key) => Math.max(...goals.filter(({ verdicts }) => verdicts[0] !== 'i').map((goal) => goal[key] ?? 0));
const isMeasured = (goal) => !goal.verdicts || (Number.isFinite(goal.deepest_mm) && Number.isFinite(goal.deeper_mm));
// what is counted, how much of it there is, the floor or the ceiling, and which of these it is
const sums = [
  ['characters that are read', rows.length, asked > 0 ? +asked : 16, 1],
  ['first choices that are possible, %', share((goal) => goal.met && goal.verdicts[0] === 'p'), 80, 1],
  ['first choices that are impossible, or none, %', share((goal) => !/^[ps]/.test(goal.verdicts)), 13, -1],
  ['goals with three motions that could be made, %', share((goal) => isMade(goal, 3)), 55, 1],
  ['goals whose depths were measured, %', share(isMeasured), asked > 0 ? 0 : 81, 1],
  ["longest first choice, times the built-in person's", most('longer'), 1.75, -1],
  ['deepest vertex, mm', most('deepest_mm'), 180, -1],
  ['deepest vertex beyond where it began, mm', most('deeper_mm'), 125, -1],
];
console.log('\n| | | at least, at most |\n|---|---|---|');
for (const [name, value, bound, sign] of sums) console.log(`| ${name} | ${+value.toFixed(2)} | ${bound} |`);
const broken = sums.filter(([, value, bound, sign]) => !(sign * value >= sign * bound));
for (const [name, value, bound] of broken) console.error(`check_characters: ${name}: ${value.toFixed(2)}, not ${bound}`);
process.exit(broken.length ? 1 : 0);
