// SPDX-License-Identifier: MIT
// Pieces of work: things in the hands, the name of the present action and its goals. It stands within page_script.js,
// before the scenes are made.
const kThing = { sides: ['#d2b881', '#e9d8b0', '#bfa46a'], edge: '#75623a' };
const kFigure = { measure: Scene.prototype.measure, tell: Scene.prototype.draw, draw: Picture.prototype.draw, box: Picture.prototype.box };

const actionAt = (actions, time) => actions.find(([, , end]) => time < end) ?? actions.at(-1);
const across = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
// Whether a polygon that goes around counter-clockwise from outside shows its outside.
const faces = (points) => points.reduce((sum, [x, y], k) => sum + x * points.at(k - 1)[1] - y * points.at(k - 1)[0], 0) > 0;

// The corners of a cylinder's ends, counter-clockwise from outside; their middles and its radius are known.
function rims(low, high, radius) {
  const axis = high.map((x, k) => x - low[k]);
  const aside = across(axis, Math.abs(axis[1]) > Math.abs(axis[2]) ? [0, 0, 1] : [0, 1, 0]);
  const ahead = across(axis, aside);
  const [u, v] = [aside, ahead].map((way) => way.map((x) => radius * x / Math.hypot(...way)));
  const rim = (middle, turn) => kAround.map(([c, s]) => middle.map((x, k) => x + c * u[k] + turn * s * v[k]));
  return [rim(low, -1), rim(high, 1)];
}

Scene.prototype.measure = function () {
  const { data } = this;
  if (!data.things) return kFigure.measure.call(this);
  const places = (rows, points) => [...rows[0]].flatMap((_, k) => (k % 4 ? [] : [points.map((p) => [0, 1, 2].map((axis) => rows[3 * p + axis][k]))]));
  const boxes = this.motions.flatMap((rows) => data.things.flatMap(([, points]) => places(rows, points)));
  const goals = data.motions.flatMap(({ actions }) => actions.flatMap(([, , , list]) => list));
  this.data = { ...data, goals, boxes: [...data.boxes, ...boxes] };
  kFigure.measure.call(this);
  this.data = data;
};

Scene.prototype.draw = function () {
  kFigure.tell.call(this);
  if (!this.data?.things) return;
  for (const canvas of this.shown) {
    const { actions } = this.data.motions[this.canvases.indexOf(canvas)];
    const [name] = actionAt(actions, this.time);
    if (canvas.nextElementSibling.textContent !== name) canvas.nextElementSibling.textContent = name;
  }
};

Picture.prototype.draw = function (rows) {
  const { scene } = this, { data } = scene;
  if (!data.things) return kFigure.draw.call(this, rows);
  const [, , , goals] = actionAt(data.motions[scene.motions.indexOf(rows)].actions, scene.time);
  this.scene = Object.assign(Object.create(scene), { data: { ...data, goals, boxes: [...data.boxes, ...data.things] } });
  kFigure.draw.call(this, rows);
};

// A thing [radius, points]: a box of eight corners, a cylinder between two points, or a ball.
Picture.prototype.box = function (box) {
  const [radius, points] = box;
  if (Array.isArray(radius)) return kFigure.box.call(this, box);
  const places = points.map(this.place);
  const near = places.reduce((sum, place) => sum + this.see(...place)[2] / places.length, 0);
  const draw = { 8: () => this.sides(places), 2: () => this.cylinder(rims(...places, radius)), 1: () => this.ball(places[0], radius) };
  return { near, draw: draw[places.length] };
};

Picture.prototype.face = function (points, shade) {
  this.cover(points, kThing.sides[shade]);
  this.line(points, kThing.edge, 1, true);
};

Picture.prototype.sides = function (corners) {
  const seen = corners.map((corner) => this.see(...corner));
  for (const [shade, [a, b, c]] of [[1, 2, 4], [2, 4, 1], [4, 1, 2]].entries()) {
    for (const side of [[a, a | b, a | b | c, a | c], [0, c, b | c, b]]) {
      const face = side.map((k) => seen[k]);
      if (faces(face)) this.face(face, shade);
    }
  }
};

Picture.prototype.cylinder = function (ends) {
  const seen = ends.map((rim) => rim.map((place) => this.see(...place)));
  this.face(hull(seen.flat().map(([x, y]) => [x, y, 0])), 0);
  for (const rim of seen) if (faces(rim)) this.face(rim, 1);
};

Picture.prototype.ball = function (middle, radius) {
  const [x, y, , scale] = this.see(...middle);
  this.face(hull([[x, y, radius * scale]]), 0);
};

