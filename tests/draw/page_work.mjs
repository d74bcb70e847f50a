// SPDX-License-Identifier: MIT
// page_work.mjs PAGE: runs the script of a page of a piece of work on figures of one ball that goes with three things
// in their middles, and looks at where these are drawn and what is told.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';

const kDigits = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
const kWays = [[[0, 300, 0], [100, 600, 50], [150, 900, 200]], [[900, 300, 0], [900, 300, 0], [900, 300, 0]], [[-500, 700, 100], [-400, 500, 0], [-400, 900, 0]]];
const kRadius = [0, 60, 80];
const kFromMiddle = [
  [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [0, 1, 2].map((axis) => (k >> axis & 1 ? 100 : -100))),
  [[0, -90, 0], [0, 90, 0]],
  [[0, 0, 0]],
];

// The code of numbers, see page_figures.hpp.
function coded(numbers) {
  let last = 0, growth = 0, text = '';
  numbers.forEach((number, k) => {
    const told = number - last - growth;
    if (k > 0) growth = number - last;
    last = number;
    for (let left = told < 0 ? 1 - 2 * told : 2 * told, more = true; more; left = Math.floor(left / 32)) {
      more = left >= 32;
      text += kDigits[left % 32 + (more ? 32 : 0)];
    }
  });
  return text;
}

// a ball of the figure in the middle of each thing, then the points of the things
const ways = [...kWays, ...kFromMiddle.flatMap((points, thing) => points.map((point) => kWays[thing].map((place) => place.map((x, k) => x + point[k]))))];
const figures = {
  size: 1700, side: 1, seconds: 4, paths: [], goals: [], soles: [], boxes: [],
  parts: [0, 1, 2].map((point) => [0, 0, 0, [[point, 10]]]),
  things: [[0, [3, 4, 5, 6, 7, 8, 9, 10]], [60, [11, 12]], [80, [13]]],
  motions: [{
    poses: 3, actions: [['grasp', 0, 1, []], ['goals', 1, 4, [[100, 800, 100]]]],
    code: ways.map((way) => [0, 1, 2].map((axis) => coded(way.map((place) => place[axis]))).join('')).join(''),
  }],
};

let drawn = [];
class Pen {
  beginPath() { this.lines = []; }
  moveTo(x, y) { this.lines.push([[x, y]]); }
  lineTo(x, y) { this.lines.at(-1).push([x, y]); }
  closePath() {}
  clearRect() { drawn = []; }
  setTransform() {}
  setLineDash() {}
  createLinearGradient() { return { addColorStop() {} }; }
  fill() { drawn.push({ fill: this.fillStyle, lines: this.lines }); }
  stroke() { drawn.push({ stroke: this.strokeStyle, lines: this.lines }); }
}
const element = (more = {}) => ({
  on: {}, dataset: {}, classList: { add() {}, remove() {} }, setAttribute() {},
  addEventListener(name, does) { this.on[name] = does; }, ...more,
});
const pen = new Pen();
const told = element();
const canvas = element({ clientWidth: 400, clientHeight: 400, getContext: () => pen, nextElementSibling: told });
const found = { '.play': element(), input: element(), '.time': element(), '.controls': element(), script: { textContent: JSON.stringify(figures) } };
const section = { querySelector: (name) => found[name], querySelectorAll: (name) => (name === 'canvas' ? [canvas] : []) };
const frames = [];
const browser = {
  document: { documentElement: {}, querySelectorAll: () => [section] },
  window: element({ devicePixelRatio: 1 }),
  matchMedia: () => element({ matches: true }),
  getComputedStyle: () => ({ getPropertyValue: (name) => (name === '--goal' ? '#ff0000' : '#809060') }),
  requestAnimationFrame: (does) => frames.push(does),
  IntersectionObserver: function (does) { return { observe: (target) => does([{ target, isIntersecting: true }]) }; },
  ResizeObserver: function () { return { observe() {} }; },
};
const script = readFileSync(process.argv[2], 'utf8').match(/<script>([^]*)<\/script>/)[1];
new Function(...Object.keys(browser), script)(...Object.values(browser));

const range = (points, axis) => [Math.min(...points.map((p) => p[axis])), Math.max(...points.map((p) => p[axis]))];
const centre = (points) => [0, 1].map((axis) => (range(points, axis)[0] + range(points, axis)[1]) / 2);
for (const [at, name, rings] of [[0, 'grasp', 0], [200, 'grasp', 0], [300, 'goals', 1], [1000, 'goals', 1]]) {
  found.input.value = at;
  found.input.on.input();
  for (const frame of frames.splice(0)) frame(at);
  assert.equal(told.textContent, name);
  assert.equal(drawn.filter(({ stroke }) => stroke === '#ff0000').length > 0, rings > 0, `the goal at ${at}`);
  // colours of things are their own; the balls of the figure have gradients
  const faces = drawn.filter(({ fill }) => typeof fill === 'string' && fill !== '#809060').map(({ lines: [line] }) => line);
  const balls = drawn.filter(({ fill }) => typeof fill === 'object').map(({ lines: [line] }) => centre(line));
  assert.equal(balls.length, 3);
  for (const ball of balls) {
    const around = faces.filter((line) => range(line, 0)[0] - 1 < ball[0] && ball[0] < range(line, 0)[1] + 1).flat();
    const away = centre(around).map((x, k) => Math.abs(x - ball[k]));
    assert.ok(Math.max(...away) < 3, `at ${at} a thing is ${away} px from where its middle is`);
  }
  // of a box up to three faces are seen, of a cylinder its side and up to one end
  assert.ok(faces.length >= 4 && faces.length <= 6, `${faces.length} faces`);
  assert.ok(drawn.flatMap(({ lines }) => lines.flat()).flat().every((x) => x >= -1 && x <= 401), 'all is in the picture');
}
