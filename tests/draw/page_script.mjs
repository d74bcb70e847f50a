// SPDX-License-Identifier: MIT
// page_script.mjs PAGE: runs the script of a page of motions with a pen that remembers, on a figure
// of two balls and a limb between them, and looks at what it draws.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';

const kSize = 400; // px of the canvas
const kDigits = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
// A ball that rolls to the left and then rises, and another one that stays (mm).
const kRolling = [[0, 100, 0], [150, 100, 80], [300, 100, 150], [450, 250, 150], [600, 400, 150]];
const kStaying = [-200, 600, 100];

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

const box = (low, high) => [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [0, 1, 2].map((axis) => (k >> axis & 1 ? high : low)[axis]));
const figures = {
  size: 1700, side: 1, seconds: 4,
  parts: [[3, 0, 0, [[1, 100]]], [2, 0, 0, [[0, 60]]], [0, 500, 0, [[1, 100], [0, 60]]]],
  goals: [kRolling[4], [9000, 100, 0]],
  paths: [1],
  soles: [box([-50, 0, -50], [50, 0, 50]).slice(0, 4), [[0, 500, 0], [50, 500, 0], [50, 500, 50]]],
  boxes: [[...box([-100, 0, 300], [100, 200, 400]), 0]],
  motions: [{
    poses: 5,
    code: kStaying.map((x) => coded([x, x, x, x, x])).join('') +
      [0, 1, 2].map((axis) => coded(kRolling.map((place) => place[axis]))).join(''),
  }],
};

// All that is drawn: fills and strokes with their lines, of one frame.
let drawn = [];
class Pen {
  beginPath() { this.lines = []; }
  moveTo(x, y) { this.lines.push([[x, y]]); }
  lineTo(x, y) { this.lines.at(-1).push([x, y]); }
  closePath() {}
  clearRect() { drawn = []; }
  setTransform() {}
  setLineDash() {}
  createLinearGradient(...ends) {
    const stops = [];
    return { ends, stops, addColorStop: (share, colour) => stops.push([share, ...colour.match(/\d+/g).map(Number)]) };
  }
  fill() { drawn.push({ fill: this.fillStyle, lines: this.lines }); }
  stroke() { drawn.push({ stroke: this.strokeStyle, lines: this.lines, alpha: this.globalAlpha }); }
}

// What the script asks of a browser.
const element = (more = {}) => ({
  on: {}, dataset: {}, classList: { add() {}, remove() {} }, setAttribute() {}, setPointerCapture() {},
  addEventListener(name, does) { this.on[name] = does; }, ...more,
});
const pen = new Pen();
const found = {
  '.play': element(), input: element(), '.time': element(), '.controls': element(),
  script: { textContent: JSON.stringify(figures) },
};
const turned = element({ dataset: { turn: '1' } });
const canvas = element({ clientWidth: kSize, clientHeight: kSize, getContext: () => pen });
const section = { querySelector: (name) => found[name], querySelectorAll: (name) => [name === 'canvas' ? canvas : turned] };
const frames = [];
const watcher = (does) => ({ observe: (target) => does([{ target, isIntersecting: true }]) });
const names = ['left', 'right', 'middle', 'acting', 'goal', 'floor', 'ring', 'shadow', 'sole', 'box', 'way', 'panel'];
const colour = (name) => `#8090${60 + names.indexOf(name)}`;
const browser = {
  document: { documentElement: {}, querySelectorAll: () => [section] },
  window: element({ devicePixelRatio: 1 }),
  matchMedia: () => element({ matches: true }), // calm: it does not play by itself
  getComputedStyle: () => ({ getPropertyValue: (name) => colour(name.slice(2)) }),
  requestAnimationFrame: (does) => frames.push(does),
  IntersectionObserver: function (does) { return watcher(does); },
  ResizeObserver: function () { return { observe() {} }; },
};
let now = 0;
function show() {
  now += 100;
  for (const frame of frames.splice(0)) frame(now);
}
const strokes = (name) => drawn.filter(({ stroke }) => stroke === colour(name)).map(({ lines: [line] }) => line);
const fills = (name) => drawn.filter(({ fill }) => fill === colour(name)).flatMap(({ lines }) => lines);
const range = (line, axis) => [Math.min(...line.map((p) => p[axis])), Math.max(...line.map((p) => p[axis]))];
const width = (line) => range(line, 0)[1] - range(line, 0)[0];
const centre = (line) => [0, 1].map((axis) => (range(line, axis)[0] + range(line, axis)[1]) / 2);
const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
// The figure's pieces, the largest first: the limb and the two balls.
const pieces = () => drawn.filter(({ fill }) => typeof fill === 'object')
  .map(({ fill, lines: [line] }, order) => ({ ...fill, line, order })).sort((p, q) => width(q.line) - width(p.line));
const rolling = () => pieces()[1].line;

// Where a place is seen, reckoned anew: by a viewer 5.5 m away, turned and above by so much.
const [kLow, kHigh] = [[-200, 0], [600, 150]]; // of x and z
function reckoned(place, turn, tilt) {
  const [x, z] = [place[0] - (kLow[0] + kHigh[0]) / 2, place[2] - (kLow[1] + kHigh[1]) / 2];
  const level = z * Math.cos(turn) - x * Math.sin(turn);
  const near = level * Math.cos(tilt) + place[1] * Math.sin(tilt);
  const larger = 5500 / (5500 - near);
  return [larger * (x * Math.cos(turn) + z * Math.sin(turn)), larger * (place[1] * Math.cos(tilt) - level * Math.sin(tilt)), near];
}
// The same on the picture, whose scale and floor are told by where one place is drawn.
function viewer(turn, tilt, [known, drawnAt]) {
  const [across, up] = reckoned(known, turn, tilt);
  const scale = (drawnAt[0] - kSize / 2) / across;
  return (place) => {
    const [x, y] = reckoned(place, turn, tilt);
    return [kSize / 2 + scale * x, drawnAt[1] - scale * (y - up)];
  };
}

const script = readFileSync(process.argv[2], 'utf8').match(/<script>([^]*)<\/script>/)[1];
new Function(...Object.keys(browser), script)(...Object.values(browser));

// at the end of the motion
show();
const scale = width(strokes('ring')[0]) / 500; // px a mm, on the floor in the middle
const near = (value, expected) => assert.ok(Math.abs(value / expected - 1) < 0.12, `${value} is not about ${expected}`);
near(width(rolling()), 200 * scale);
const see = viewer(0.87, 0.2, [kRolling[0], strokes('way')[0][0]]);
for (const [place, seen] of [
  [kRolling[1], strokes('way')[0][1]], [kRolling[4], centre(rolling())], [kStaying, centre(pieces()[2].line)],
  [[600, 0, 150], strokes('goal')[0][1]], ...figures.soles[0].map((corner, k) => [corner, strokes('sole')[0][k]]),
  [figures.boxes[0][0], strokes('box')[0][0]], [figures.boxes[0][7], strokes('box').at(-1)[1]],
]) assert.ok(apart(see(place), seen) < 0.1, `${place} is seen at ${seen}`);
// the picture holds all of it and has little room beside it
const everything = drawn.flatMap(({ lines }) => lines.flat());
const [wide, high] = [0, 1].map((axis) => range(everything, axis));
assert.ok(wide[0] >= 0 && wide[1] <= kSize && high[0] >= 0 && high[1] <= kSize);
assert.ok(Math.max(wide[1] - wide[0], high[1] - high[0]) > 0.85 * kSize);
// what is farther is painted first; the limb is set back
const depths = pieces().map(({ order }, k) => [order, k === 0 ? -500 : reckoned(k === 1 ? kRolling[4] : kStaying, 0.87, 0.2)[2]]);
depths.sort((p, q) => p[0] - q[0]).reduce((before, now) => (assert.ok(before[1] < now[1]), now));
// the limb's outline goes around the balls, touches them and is nowhere within them
const [limb, ...discs] = pieces();
for (const axis of [0, 1]) assert.deepEqual(range(limb.line, axis), range(discs.flatMap(({ line }) => line), axis));
for (const p of limb.line) {
  const beyond = discs.map(({ line }) => apart(p, centre(line)) - width(line) / 2);
  assert.ok(Math.abs(Math.min(...beyond)) < 0.2);
}
// lit from above, balls from the left too and the limb from across it
for (const [k, { ends: [x0, y0, x1, y1], stops, line }] of pieces().entries()) {
  assert.deepEqual(stops.map(([share]) => share).map(Math.round), [0, 0, 1]);
  assert.ok(stops[0][1] > stops[1][1] && stops[1][1] > stops[2][1]);
  assert.ok(y0 < y1);
  if (k > 0) assert.ok(x0 < x1 && Math.abs(apart([x0, y0], [x1, y1]) / width(line) - 1) < 0.02);
  if (k > 0) assert.ok(apart([(x0 + x1) / 2, (y0 + y1) / 2], centre(line)) < 0.5);
}
const [one, other] = discs.map(({ line }) => centre(line));
const [x0, y0, x1, y1] = limb.ends;
assert.ok(Math.abs((x1 - x0) * (other[0] - one[0]) + (y1 - y0) * (other[1] - one[1])) < 1);
const shadow = fills('shadow')[0];
near(width(shadow), 0.9 * 200 * scale);
near(centre(shadow)[1] - centre(rolling())[1], 400 * Math.cos(0.2) * scale);
const [all, gone] = strokes('way');
assert.equal(all.length, 5);
assert.ok(apart(all[4], centre(rolling())) < 0.1);
assert.ok(apart(gone.at(-1), all[4]) < 0.1);
// a ring about the goal that is met, with its plumb line down to the shadow
const [plumb, ring, away] = strokes('goal');
assert.ok(apart(centre(ring), all[4]) < 0.1);
assert.ok(apart(plumb[1], centre(shadow)) < 0.1);
assert.ok(apart(plumb[0], centre(ring)) > 5);
// the other one is beyond the right edge: an arrow to there, within its ring
const [arrow] = fills('goal');
assert.ok(centre(away)[0] > kSize - 20);
for (const p of arrow) assert.ok(apart(p, centre(away)) < width(away) / 2 + 1);
assert.ok(arrow[0][0] > arrow[1][0] + 10 && arrow[0][0] > arrow[2][0] + 10);
assert.ok(apart(arrow[1], arrow[2]) > 10);
assert.equal(new Set(strokes('box').map(String)).size, 12);
assert.equal(strokes('sole').length, 1);
assert.equal(strokes('sole')[0].length, 4);

// at any time the ball is on its way
for (const at of [0, 1, 2, 3, 4]) {
  found.input.value = 250 * at;
  found.input.on.input();
  show();
  assert.ok(apart(strokes('way')[0][at], centre(rolling())) < 0.1, `pose ${at}`);
  assert.equal(strokes('way')[1].length, at + 2);
  assert.equal(found['.time'].textContent, `${at}.00 s`);
}
found.input.value = 125;
found.input.on.input();
show();
const [begin, next] = strokes('way')[0];
assert.ok(apart(centre(rolling()), [0, 1].map((axis) => (begin[axis] + next[axis]) / 2)) < 1);

// a button turns it, and a mouse that drags it, from above too
const seenFrom = (turn, tilt) => {
  show();
  const [way] = strokes('way');
  assert.ok(apart(viewer(turn, tilt, [kRolling[0], way[0]])(kRolling[4]), way[4]) < 0.1, `from ${turn}, ${tilt}`);
};
turned.on.click();
seenFrom(1.87, 0.2);
canvas.on.pointerdown({ clientX: 10, clientY: 10 });
canvas.on.pointermove({ clientX: 55, clientY: 25, pointerType: 'mouse' });
seenFrom(2.37, 0.3);
canvas.on.pointermove({ clientX: 145, clientY: 999, pointerType: 'touch' });
seenFrom(3.37, 0.3);
canvas.on.pointerup();
canvas.on.pointermove({ clientX: 0, clientY: 0, pointerType: 'mouse' });
turned.on.click();
seenFrom(4.37, 0.3);

// it plays from before its beginning to its end, once
found['.play'].on.click();
for (let played = 0; found['.play'].textContent === 'Pause'; ++played) {
  assert.ok(played < 60);
  show();
}
assert.equal(found['.time'].textContent, '4.00 s');
assert.equal(found.input.value, 1000);
