// SPDX-License-Identifier: MIT
// The page that a data set comes with, which says what its numbers are and are not.

const SAYS = {
  'observation.state': 'angles of the joints, rad',
  action: "the next frame's angles, rad; the last frame's are its own",
  'observation.torque': 'torques that the motion needs at the joints, N m',
  'observation.environment_state': 'goals in metres, and what differs between bodies; 0 for what is not asked',
  timestamp: 's from the beginning',
  'next.done': 'true in the last frame',
};

function header({ name, licence }) {
  const lines = ['---'];
  if (licence) lines.push(`license: ${JSON.stringify(licence.toLowerCase())}`);
  if (name) lines.push(`pretty_name: ${JSON.stringify(name)}`);
  lines.push('task_categories: [robotics]', 'tags: [LeRobot]', 'configs:');
  return [...lines, '- config_name: default', '  data_files: data/*/*.parquet', '---'];
}

export function card({ name, licence, body, plan, shards, splits, left, writer, settings }) {
  const rows = writer.features.map((feature) => {
    const shape = feature.width === 1 ? feature.dtype : `${feature.dtype} × ${feature.width}`;
    return `| \`${feature.name}\` | ${shape} | ${SAYS[feature.name] ?? ''} |`;
  });
  const parts = splits.map((split) => `${split.name} ${split.first}:${split.last}`).join(', ');
  const apart = settings.split ? ` A ${settings.split} is in one of them alone.` : '';
  return `${header({ name, licence }).join('\n')}

# ${name || 'Generated reaches'}

${writer.episodes} motions of the body \`${body}\` (${writer.frames} frames at ${settings.fps} Hz, ${writer.tasks} tasks) in
the LeRobot v3 layout, made by shigusa's \`scripts/dataset_to_lerobot\` from ${shards} shards of the plan
\`${plan}\`. Splits by episodes: ${parts}.${apart}

**Nothing here was recorded.** A program computed the motions of a simulated body. \`action\` is where the joints are one
frame later, and no command that a robot's controller was given; there are no pictures. Whether a robot can follow the
motions has to be tried on it. Where the body as a whole stands and is turned is not in the numbers.

| feature | type | meaning |
|---|---|---|
${rows.join('\n')}

Frames are interpolated linearly between the 61 of a motion; an episode's last frame is the motion's last, less than
one frame late where its duration is no multiple of 1/${settings.fps} s. The world has y up and x to the left of the body, which faces z.
Verdicts that were taken: ${settings.verdicts.join(', ')}; left out were ${left.verdict} motions of other verdicts and
${left.unreached} that do not reach their goals. The quantiles in \`meta/stats.json\` are of at most a million frames, evenly spaced.
\`shigusa/task\` and \`shigusa/rank\` in \`meta/episodes\` tell a motion's row in the shards.
`;
}
