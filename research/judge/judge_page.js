// SPDX-License-Identifier: MIT
// Script of the page that shigusa_judge writes: shows a recorded and a generated motion side by side, asks which was
// recorded, and lists the answers. Places are in mm in the world of the reach: x left, y up, z ahead.
'use strict';

const kPause = 0.5; // s between replays, without figures: the record is cut in motion, and a halt would tell
const kTilt = (8 * Math.PI) / 180; // the camera looks down
const kPixelsPerMillimetre = 0.27;
const kCentre = { x: 300, y: 600 }; // pixels, of the floor between the feet
const kClickTravel = 5; // pixels; a longer way of the mouse turns the figures

// Colours of a figure's parts, and of all else.
const kTrunk = '#666666';
const kNear = '#3c3c3c';
const kFar = '#9a9a9a';
const kRim = '#ffffff';
const kShadow = '#e9e9e9';
const kFloor = '#bbbbbb';
const kGoal = '#c8502d';

// Parts of a figure: lines between points with their widths (mm), and the side of a limb.
const kParts = [
  {
    lines: [
      ['pelvis', 'spine', 200],
      ['spine', 'chest', 200],
      ['chest', 'neck', 170],
      ['left_shoulder', 'right_shoulder', 110],
      ['left_hip', 'right_hip', 150],
      ['neck', 'throat', 80],
    ],
  },
  {
    lines: [
      ['head', 'head', 190],
      ['head', 'nose', 40],
    ],
  },
  ...['left', 'right'].flatMap((side) =>
    [
      [['shoulder', 'elbow', 85]],
      [['elbow', 'grip', 65]],
      [['hip', 'knee', 125]],
      [['knee', 'ankle', 90]],
      [
        ['heel', 'ball', 60],
        ['ankle', 'ball', 60],
        ['ball', 'toes', 55],
      ],
    ].map((limb) => ({ side, lines: limb.map(([from, to, width]) => [`${side}_${from}`, `${side}_${to}`, width]) })),
  ),
];

const element = (id) => document.getElementById(id);
const motions = JSON.parse(element('motions').textContent);

const middle = (a, b) => a.map((v, axis) => (v + b[axis]) / 2);

/** Points of a figure at a time (s) of its motion, by name, interpolated between frames. */
function placesAt(frames, frameTime, time) {
  const frame = Math.min(time / frameTime, frames.length - 1);
  const before = Math.floor(frame);
  const after = Math.min(before + 1, frames.length - 1);
  const share = frame - before;
  const places = {};
  motions.points.forEach((name, i) => {
    places[name] = frames[before][i].map((v, axis) => v + share * (frames[after][i][axis] - v));
  });
  places.pelvis = middle(places.left_hip, places.right_hip);
  places.throat = middle(places.neck, places.head);
  return places;
}

/** An orthographic view, turned about the vertical from the view of the right side (rad). */
function viewFrom(turn) {
  const [sin, cos] = [Math.sin(turn), Math.cos(turn)];
  return ([x, y, z]) => {
    const towards = z * sin - x * cos;
    return {
      x: kCentre.x + kPixelsPerMillimetre * (z * cos + x * sin),
      y: kCentre.y - kPixelsPerMillimetre * (y * Math.cos(kTilt) - towards * Math.sin(kTilt)),
      near: towards * Math.cos(kTilt) + y * Math.sin(kTilt),
    };
  };
}

function line(context, from, to, width, colour) {
  context.lineCap = 'round';
  context.lineWidth = width;
  context.strokeStyle = colour;
  context.beginPath();
  context.moveTo(from.x, from.y);
  context.lineTo(to.x + 0.01, to.y); // a line without length would have no caps
  context.stroke();
}

function drawFloor(context, view) {
  for (let at = -1000; at <= 1000; at += 500) {
    line(context, view([at, 0, -1000]), view([at, 0, 1000]), 1, kFloor);
    line(context, view([-1000, 0, at]), view([1000, 0, at]), 1, kFloor);
  }
}

/** A ringed cross. */
function drawGoal(context, at) {
  line(context, { x: at.x - 14, y: at.y }, { x: at.x + 14, y: at.y }, 2, kGoal);
  line(context, { x: at.x, y: at.y - 14 }, { x: at.x, y: at.y + 14 }, 2, kGoal);
  context.beginPath();
  context.arc(at.x, at.y, 9, 0, 2 * Math.PI);
  context.stroke();
}

function drawFigure(context, places, view, turn) {
  const nearSide = Math.cos(turn) > 0 ? 'right' : 'left';
  const drawn = kParts.map(({ lines, side }) => ({
    lines: lines.map(([from, to, width]) => [view(places[from]), view(places[to]), kPixelsPerMillimetre * width]),
    near: lines.reduce((sum, [from, to]) => sum + view(places[from]).near + view(places[to]).near, 0) / lines.length,
    colour: !side ? kTrunk : side === nearSide ? kNear : kFar,
  }));
  const onFloor = ([x, , z]) => view([x, 0, z]);
  for (const [from, to, width] of kParts.flatMap((part) => part.lines)) {
    line(context, onFloor(places[from]), onFloor(places[to]), 0.8 * kPixelsPerMillimetre * width, kShadow);
  }
  drawn.sort((a, b) => a.near - b.near);
  for (const { lines, colour } of drawn) {
    for (const [from, to, width] of lines) line(context, from, to, width + 3, kRim);
    for (const [from, to, width] of lines) line(context, from, to, width, colour);
  }
}

const durationOf = (reach) => (reach.recorded.length - 1) * reach.frame_time;

/** Draws a reach's motion, "recorded" or "generated", at a time (s) into a canvas; after its end only the goal. */
function draw(canvas, reach, kind, time, turn) {
  const context = canvas.getContext('2d');
  const view = viewFrom(turn);
  context.fillStyle = '#ffffff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  drawFloor(context, view);
  if (time <= durationOf(reach)) drawFigure(context, placesAt(reach[kind], reach.frame_time, time), view, turn);
  drawGoal(context, view(reach.goal));
}

// Sides of the recorded motions, drawn anew whenever the page is loaded.
const sides = motions.reaches.map(() => (Math.random() < 0.5 ? 'left' : 'right'));
const answers = [];
let shownAt = performance.now(); // ms

function replay(now) {
  const reach = motions.reaches[answers.length];
  if (!reach) return;
  const turn = (Number(element('turn').value) * Math.PI) / 180;
  const time = (Math.max(now - shownAt, 0) / 1000) % (durationOf(reach) + kPause);
  for (const side of ['left', 'right']) {
    draw(element(side), reach, side === sides[answers.length] ? 'recorded' : 'generated', time, turn);
  }
  requestAnimationFrame(replay);
}

function showEnd() {
  const right = answers.filter((answer) => answer.right).length;
  const text = JSON.stringify({ right, of: answers.length, answers }, null, 2);
  element('asked').hidden = true;
  element('end').hidden = false;
  element('result').textContent =
    `${right} of ${answers.length} right. Somebody who guesses has ${answers.length / 2} in the mean.`;
  element('answers').textContent = text;
  element('download').href = URL.createObjectURL(new Blob([text], { type: 'application/json' }));
}

function showNext() {
  shownAt = performance.now();
  const number = answers.length + 1;
  element('count').textContent = number > sides.length ? '' : `${number} of ${sides.length}`;
  if (number > sides.length) showEnd();
}

function choose(chosen) {
  if (answers.length === sides.length) return;
  const recorded = sides[answers.length];
  const seconds = Math.round(performance.now() - shownAt) / 1000;
  const reach = motions.reaches[answers.length].name;
  answers.push({ reach, recorded, chosen, right: chosen === recorded, seconds });
  showNext();
}

function turnBy(degrees) {
  const turn = Number(element('turn').value) + degrees;
  element('turn').value = ((turn + 540) % 360) - 180;
}

for (const side of ['left', 'right']) {
  const canvas = element(side);
  let travel = 0;
  canvas.addEventListener('pointerdown', (event) => {
    travel = 0;
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!event.buttons) return;
    travel += Math.abs(event.movementX) + Math.abs(event.movementY);
    turnBy(event.movementX / 2);
  });
  canvas.addEventListener('click', () => {
    if (travel < kClickTravel) choose(side);
  });
  element(`choose_${side}`).addEventListener('click', () => choose(side));
}
addEventListener('keydown', (event) => {
  if (event.repeat || !['ArrowLeft', 'ArrowRight'].includes(event.key)) return;
  event.preventDefault(); // of the view's slider
  choose(event.key === 'ArrowLeft' ? 'left' : 'right');
});

showNext();
requestAnimationFrame(replay);
