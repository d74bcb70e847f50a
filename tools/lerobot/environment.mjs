// SPDX-License-Identifier: MIT
// The numbers of a task that a policy may know: a place for each effector that any task of the data
// set asks of, whichever one has a goal, and of the body what is not the same in all tasks.

const GOAL_NUMBERS = {
  position_m: ['x_m', 'y_m', 'z_m'],
  rotation_xyzw: ['qx', 'qy', 'qz', 'qw'],
  axis: ['axis_x', 'axis_y', 'axis_z'],
  direction: ['direction_x', 'direction_y', 'direction_z'],
  tolerance_m: ['tolerance_x_m', 'tolerance_y_m', 'tolerance_z_m'],
  load_kg: ['load_kg'],
};
const BODY_NUMBERS = ['stature_m', 'mass_kg', 'seat_m'];
const number = (value) => (Number.isFinite(value) ? value : 0);

// A task's goals by the effector's name; a second goal of one effector is that of "left_hand_2".
function goalsByName(task) {
  const goals = new Map();
  for (const goal of task.goals) {
    let name = goal.effector;
    for (let k = 2; goals.has(name); ++k) name = `${goal.effector}_${k}`;
    goals.set(name, goal);
  }
  return goals;
}

export class Environment {
  #tasks = 0;
  #goals = new Map(); // name → { asked: by how many tasks, used: numbers that are not 0 anywhere }
  #ranges = BODY_NUMBERS.map(() => [Infinity, -Infinity]);

  // Shows a task of the data set. All are to be shown before `names` and `values`.
  add(task) {
    ++this.#tasks;
    for (const [name, goal] of goalsByName(task)) {
      const known = this.#goals.get(name) ?? { asked: 0, used: new Set(['position_m']) };
      ++known.asked;
      for (const key of Object.keys(GOAL_NUMBERS)) {
        if (goal[key].some((value) => number(value) !== 0)) known.used.add(key);
      }
      this.#goals.set(name, known);
    }
    BODY_NUMBERS.forEach((key, i) => {
      const [low, high] = this.#ranges[i];
      this.#ranges[i] = [Math.min(low, number(task[key])), Math.max(high, number(task[key]))];
    });
  }

  // The effectors in one order whatever the tasks' own.
  #sorted() {
    return [...this.#goals].sort(([a], [b]) => (a < b ? -1 : 1));
  }
  #keys(known) {
    return Object.keys(GOAL_NUMBERS).filter((key) => known.used.has(key));
  }
  #bodyKeys() {
    return BODY_NUMBERS.filter((_, i) => this.#ranges[i][0] !== this.#ranges[i][1]);
  }

  names() {
    const goals = this.#sorted().flatMap(([name, known]) => {
      const numbers = this.#keys(known).flatMap((key) => GOAL_NUMBERS[key]);
      return [...(known.asked < this.#tasks ? ['asked'] : []), ...numbers].map((one) => `${name}.${one}`);
    });
    return [...goals, ...this.#bodyKeys()];
  }

  // A task's numbers, in the order of `names`; 0 for what it does not ask.
  values(task) {
    const goals = goalsByName(task);
    const values = [];
    for (const [name, known] of this.#sorted()) {
      const goal = goals.get(name);
      if (known.asked < this.#tasks) values.push(goal ? 1 : 0);
      for (const key of this.#keys(known)) {
        values.push(...(goal ? goal[key].map(number) : GOAL_NUMBERS[key].map(() => 0)));
      }
    }
    return [...values, ...this.#bodyKeys().map((key) => number(task[key]))];
  }
}
