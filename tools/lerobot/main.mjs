// SPDX-License-Identifier: MIT
// main.mjs DIR OUT: see README.md.
import { parseArgs } from 'node:util';

const USAGE = `usage: dataset_to_lerobot DIR OUT [OPTION…]: a folder of shards as a LeRobot v3 data set
  --fps N            frames a second (20; 1 to 1000)
  --split BY         splits train, validation and test by person or by region, as the folder's index.h5
                     has them ('shigusa dataset merge DIR')
  --body NAME        table of motions, where the shards have several
  --verdict WORDS    of possible, strains, impossible, with commas between them (possible,strains)
  --file-mb N        the most that a file has before it is packed (100)`;
const VERDICTS = ['possible', 'strains', 'impossible'];

class UsageError extends Error {}

function number(values, name, { low, high, whole }) {
  const value = Number(values[name]);
  if (!(value >= low && value <= high) || (whole && !Number.isInteger(value))) {
    throw new UsageError(`--${name} is '${values[name]}'; allowed is ${low} to ${high}${whole ? ', whole' : ''}`);
  }
  return value;
}

function settingsOf(values) {
  const verdicts = values.verdict.split(',');
  const wrong = verdicts.find((word) => !VERDICTS.includes(word));
  if (wrong !== undefined) {
    throw new UsageError(`--verdict has '${wrong}'; allowed are ${VERDICTS.join(', ')}`);
  }
  if (!['person', 'region', undefined].includes(values.split)) {
    throw new UsageError(`--split is '${values.split}'; allowed are person and region`);
  }
  return {
    fps: number(values, 'fps', { low: 1, high: 1000, whole: true }),
    split: values.split,
    body: values.body,
    verdicts,
    fileMegabytes: number(values, 'file-mb', { low: 0.01, high: 1000, whole: false }),
  };
}

function parsed(argv) {
  try {
    return parseArgs({
      args: argv,
      allowPositionals: true,
      options: {
        fps: { type: 'string', default: '20' },
        split: { type: 'string' },
        body: { type: 'string' },
        verdict: { type: 'string', default: 'possible,strains' },
        'file-mb': { type: 'string', default: '100' },
        help: { type: 'boolean', default: false },
      },
    });
  } catch (error) {
    throw new UsageError(error.message);
  }
}

async function main(argv) {
  const { values, positionals } = parsed(argv);
  if (values.help) return console.log(USAGE);
  if (positionals.length !== 2) throw new UsageError(`${positionals.length} folders; there are two, DIR and OUT`);
  const [folder, out] = positionals;
  const settings = settingsOf(values);
  // DuckDB and h5wasm are loaded only once there is work for them
  const { convert } = await import('./convert.mjs');
  const made = await convert(folder, out, settings);
  const { writer, left, splits } = made;
  console.log(
    `${out}: ${writer.episodes} episodes, ${writer.frames} frames, ${writer.tasks} tasks of ${made.body}, ` +
      `from ${made.shards} shards (${splits.map((split) => `${split.name} ${split.last - split.first}`).join(', ')}); left out: ` +
      `${left.unreached} motions that do not reach their goals, ${left.verdict} of other verdicts`,
  );
}

try {
  await main(process.argv.slice(2));
} catch (error) {
  console.error(`dataset_to_lerobot: ${error.message}`);
  if (error instanceof UsageError) console.error(USAGE);
  process.exitCode = error instanceof UsageError ? 2 : 1;
}
