// SPDX-License-Identifier: MIT
// A shard's tasks with their goals, and what a task is in words.

const TASK_COLUMNS = ['task', 'person', 'status', 'stature_m', 'mass_kg', 'seat_m'];
const GOAL_COLUMNS = [
  'task',
  'effector',
  'position_m',
  'rotation_xyzw',
  'axis',
  'direction',
  'tolerance_m',
  'load_kg',
];

// The tasks of a shard by their numbers: { person, reached, stature_m, …, goals, obstacles }.
export function tasksOf(shard) {
  const tasks = new Map();
  const facts = shard.columns('tasks', TASK_COLUMNS);
  for (let row = 0; row < facts.task.rows; ++row) {
    tasks.set(facts.task.at(row), {
      person: facts.person.at(row),
      reached: ['reached', 'unsteady'].includes(facts.status.word(row)),
      stature_m: facts.stature_m.at(row),
      mass_kg: facts.mass_kg.at(row),
      seat_m: facts.seat_m.at(row),
      goals: [],
      obstacles: 0,
    });
  }
  const goals = shard.columns('goals', GOAL_COLUMNS);
  for (let row = 0; row < goals.task.rows; ++row) {
    const goal = { effector: goals.effector.at(row), load_kg: [goals.load_kg.at(row)] };
    for (const name of GOAL_COLUMNS.slice(2, -1)) goal[name] = [...goals[name].block(row)];
    tasks.get(goals.task.at(row)).goals.push(goal);
  }
  const obstacles = shard.columns('obstacles', ['task']).task;
  for (let row = 0; row < obstacles.rows; ++row) ++tasks.get(obstacles.at(row)).obstacles;
  return tasks;
}

// "0.25", and no "-0.00".
const metres = (value) => value.toFixed(2).replace(/^-(0\.0*)$/, '$1');
const place = (point) => `(${point.map(metres).join(', ')}) m`;

function goalWords(goal) {
  const effector = goal.effector.replace(/^(left|right)_([a-z]+)$/, '$1 $2');
  const box = goal.tolerance_m.some((side) => side > 0) ? ` ± ${place(goal.tolerance_m)}` : '';
  const turned = Number.isNaN(goal.rotation_xyzw[0]) && Number.isNaN(goal.axis[0]) ? '' : ', turned as asked,';
  const load = goal.load_kg[0] > 0 ? ` holding ${Number(goal.load_kg[0].toFixed(1))} kg` : '';
  return `${place(goal.position_m)}${box}${turned} with the ${effector}${load}`;
}

// "reach (0.25, 0.55, 0.50) m with the right hand holding 5 kg".
export function sentence(task) {
  const seat = task.seat_m > 0 ? `, seated at ${metres(task.seat_m)} m` : '';
  const obstacles = task.obstacles > 0 ? `, around ${task.obstacles} obstacle${task.obstacles > 1 ? 's' : ''}` : '';
  return `reach ${task.goals.map(goalWords).join(' and ')}${seat}${obstacles}`;
}
