// SPDX-License-Identifier: MIT
'use strict';
(() => {
const kLead = 0.4, kRest = 1.4; // s before and after each round
const kAround = Array.from({ length: 32 }, (_, k) => [Math.cos(k * Math.PI / 16), Math.sin(k * Math.PI / 16)]);
const kCircle = Array.from({ length: 49 }, (_, k) => [Math.cos(k * Math.PI / 24), Math.sin(k * Math.PI / 24)]);
const kTones = ['left', 'right', 'middle', 'acting', 'middle'];
const kEye = 5500; // mm from the figure to the viewer
const kSeat = 120; // mm; what stands higher is no foot, but a thigh on a seat
const calm = matchMedia('(prefers-reduced-motion: reduce)');
let colours = {};

const mixed = (a, b, share) => a.map((x, k) => x + (b[k] - x) * share);
const css = (rgb) => `rgb(${rgb.map(Math.round).join()})`;
const between = (x, low, high) => Math.min(Math.max(x, low), high);

// The style sheet's colours; those of the figure as numbers.
function readColours() {
  const style = getComputedStyle(document.documentElement);
  const of = (name) => style.getPropertyValue(`--${name}`).trim();
  colours = {};
  for (const name of ['goal', 'floor', 'ring', 'shadow', 'sole', 'box', 'way', 'panel']) colours[name] = of(name);
  const numbers = (text) => [1, 3, 5].map((k) => parseInt((text.length < 7 ? text.replace(/\w/g, '$&$&') : text).slice(k, k + 2), 16));
  colours.tones = kTones.map((name) => numbers(of(name)));
  colours.far = numbers(of('panel'));
  colours.known = new Map();
}

// Three shades of a tone that is so far away (0 near, 1 far).
function shades(tone, far) {
  const step = Math.round(far * 8), key = tone * 16 + step;
  if (!colours.known.has(key)) {
    const base = mixed(colours.tones[tone], colours.far, 0.035 * step);
    colours.known.set(key, [css(mixed(base, [255, 255, 255], 0.32)), css(base), css(mixed(base, [10, 20, 40], 0.3))]);
  }
  return colours.known.get(key);
}

// The numbers of a code: places of points, three rows of poses for each.
function decoded({ poses, code }) {
  const digits = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
  const rows = [];
  for (let at = 0; at < code.length;) {
    const row = new Float32Array(poses);
    let last = 0, growth = 0;
    for (let k = 0; k < poses; ++k) {
      let value = 0, factor = 1, digit = 32;
      for (; digit & 32; factor *= 32) {
        digit = digits.indexOf(code[at++]);
        value += (digit & 31) * factor;
      }
      const told = value % 2 ? -(value - 1) / 2 : value / 2;
      if (k === 0) last = told;
      else last += growth += told;
      row[k] = last;
    }
    rows.push(row);
  }
  return rows;
}

// Once around discs [x, y, radius]; on the floor they are seen `flat` times as high as wide.
function hull(discs, flat = 1) {
  return kAround.map(([c, s]) => {
    let best = discs[0], most = -Infinity;
    for (const disc of discs) {
      const reach = disc[0] * c + disc[1] * s / flat + disc[2];
      if (reach > most) [best, most] = [disc, reach];
    }
    return [best[0] + best[2] * c, best[1] + best[2] * s * flat];
  });
}

class Scene {
  constructor(section) {
    this.section = section;
    this.canvases = [...section.querySelectorAll('canvas')];
    this.shown = new Set();
    this.button = section.querySelector('.play');
    this.slider = section.querySelector('input');
    this.told = section.querySelector('.time');
    this.tilt = 0.2;
    this.playing = !calm.matches;
    this.loops = !calm.matches;
    this.button.textContent = this.playing ? 'Pause' : 'Play';
  }

  // Reads the figures when they are seen for the first time.
  load() {
    if (this.data) return;
    this.data = JSON.parse(this.section.querySelector('script').textContent);
    this.motions = this.data.motions.map(decoded);
    this.turn = this.data.side * 0.87;
    this.time = calm.matches ? this.data.seconds : -kLead;
    this.measure();
  }

  // The room that all motions take, however they are turned.
  measure() {
    const { goals, boxes, size } = this.data;
    const balls = new Set(this.data.parts.flatMap(([, , , list]) => list.map(([point]) => point)));
    const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    const places = [];
    for (const rows of this.motions) {
      for (const p of balls) {
        for (let k = 0; k < rows[0].length; k += 4) places.push([rows[3 * p][k], rows[3 * p + 1][k], rows[3 * p + 2][k]]);
      }
    }
    for (const [x, , z] of places) {
      [x, z].forEach((value, k) => {
        low[k] = Math.min(low[k], value);
        high[k] = Math.max(high[k], value);
      });
    }
    this.middle = [0, 1].map((k) => (low[k] + high[k]) / 2);
    const near = [...goals, ...boxes.flatMap((box) => box.slice(0, 8))]
      .filter(([x, y, z]) => Math.hypot(x - this.middle[0], z - this.middle[1]) < 0.8 * size && y < 1.6 * size);
    this.reach = 0.25 * size;
    this.top = 0.3 * size;
    for (const [x, y, z] of [...places, ...near]) {
      this.reach = Math.max(this.reach, Math.hypot(x - this.middle[0], z - this.middle[1]) + 0.05 * size);
      this.top = Math.max(this.top, y + 0.07 * size);
    }
  }

  step(seconds) {
    if (!this.playing || !this.data) return;
    this.time += seconds;
    if (this.time < this.data.seconds + (this.loops ? kRest : 0)) return;
    this.time = this.loops ? -kLead : this.data.seconds;
    if (!this.loops) this.play(false);
  }

  play(playing) {
    this.playing = playing;
    if (playing && this.time >= this.data.seconds) this.time = -kLead;
    this.tell();
    wake();
  }

  tell() {
    const time = between(this.time, 0, this.data.seconds);
    this.button.textContent = this.playing ? 'Pause' : 'Play';
    this.slider.value = Math.round(1000 * time / this.data.seconds);
    this.told.textContent = `${time.toFixed(2)} s`;
    if (!this.playing) this.slider.setAttribute('aria-valuetext', this.told.textContent);
  }

  draw() {
    if (this.shown.size === 0) return;
    this.tell();
    for (const canvas of this.shown) new Picture(this, canvas).draw(this.motions[this.canvases.indexOf(canvas)]);
  }
}

// One figure at the time of its scene.
class Picture {
  constructor(scene, canvas) {
    this.scene = scene;
    this.pen = canvas.getContext('2d');
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    this.width = canvas.clientWidth;
    this.height = canvas.clientHeight;
    const size = [Math.round(this.width * ratio), Math.round(this.height * ratio)];
    if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    [this.c, this.s] = [Math.cos(scene.turn), Math.sin(scene.turn)];
    [this.ct, this.st] = [Math.cos(scene.tilt), Math.sin(scene.tilt)];
    const down = scene.reach * this.st;
    this.scale = Math.min(this.width / (2.16 * scene.reach), this.height / (1.04 * (scene.top * this.ct + 2 * down)));
    this.base = this.height - this.scale * (1.1 * down) - 2;
  }

  // Where a place of the world is seen: x, y in pixels, how near it is in mm, and pixels for a mm there.
  see(x, y, z) {
    x -= this.scene.middle[0];
    z -= this.scene.middle[1];
    const right = this.c * x + this.s * z;
    const level = this.c * z - this.s * x;
    const near = level * this.ct + y * this.st;
    const scale = this.scale * kEye / (kEye - between(near, -kEye, kEye / 2));
    return [this.width / 2 + scale * right, this.base - scale * (y * this.ct - level * this.st), near, scale];
  }

  path(points, close = true) {
    points.forEach(([x, y], k) => (k === 0 ? this.pen.moveTo(x, y) : this.pen.lineTo(x, y)));
    if (close) this.pen.closePath();
  }
  cover(points, colour) {
    this.pen.beginPath();
    this.path(points);
    this.pen.fillStyle = colour;
    this.pen.fill();
  }
  line(points, colour, width, close = false) {
    this.pen.beginPath();
    this.path(points, close);
    this.pen.strokeStyle = colour;
    this.pen.lineWidth = width;
    this.pen.stroke();
  }

  draw(rows) {
    const { data, time } = this.scene;
    const last = rows[0].length - 1;
    const at = between(time / data.seconds, 0, 1) * last;
    const k = Math.min(Math.floor(at), Math.max(last - 1, 0)), share = at - k;
    const value = (row) => row[k] + (last > 0 ? (row[k + 1] - row[k]) * share : 0);
    this.place = (p) => [value(rows[3 * p]), value(rows[3 * p + 1]), value(rows[3 * p + 2])];
    this.pen.clearRect(0, 0, this.width, this.height);
    this.pen.lineJoin = this.pen.lineCap = 'round';
    const parts = data.parts.map((part) => this.part(part));
    this.floor(parts);
    const boxes = data.boxes.map((box) => this.box(box));
    const nears = parts.map(({ near }) => near);
    this.range = [Math.min(...nears), Math.max(...nears)];
    for (const piece of [...parts, ...boxes].sort((a, b) => a.near - b.near)) piece.draw();
    data.paths.forEach((point) => this.way(rows, point, at));
    for (const goal of data.goals) this.goal(goal);
  }

  floor(parts) {
    const { middle, reach, data } = this.scene;
    const circle = (radius) => kCircle.map(([c, s]) => this.see(middle[0] + radius * c, 0, middle[1] + radius * s));
    this.cover(circle(reach), colours.floor);
    for (let radius = 250; radius < reach; radius += 250) this.line(circle(radius), colours.ring, radius % 500 ? 0.5 : 1);
    this.pen.beginPath();
    for (const { balls } of parts) {
      this.path(hull(balls.map(([x, , z, radius]) => {
        const seen = this.see(x, 0, z);
        return [seen[0], seen[1], 0.9 * radius * seen[3]];
      }), this.st));
    }
    this.pen.fillStyle = colours.shadow;
    this.pen.fill();
    for (const sole of data.soles) {
      const low = sole.filter(([, y]) => y < kSeat);
      if (low.length > 2) this.line(low.map((corner) => this.see(...corner)), colours.sole, 1.6, true);
    }
  }

  part([tone, setback, , list]) {
    const balls = list.map(([point, radius]) => [...this.place(point), radius]);
    const discs = balls.map(([x, y, z, radius]) => {
      const seen = this.see(x, y, z);
      return [seen[0], seen[1], Math.max(radius * seen[3], 0.6), seen[2]];
    });
    const near = discs.reduce((sum, disc) => sum + disc[3] / discs.length, 0) - setback;
    return { balls, near, draw: () => this.solid(tone, discs, near) };
  }

  // Light from above on the left; long parts have it along one side.
  solid(tone, discs, near) {
    const points = hull(discs);
    const [a, b] = [discs[0], discs[discs.length - 1]];
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const length = Math.hypot(dx, dy);
    let light = [-0.5, -0.866];
    if (discs.length === 2 && length > 1.6 * a[2]) {
      light = [-dy / length, dx / length];
      if (light[0] * 0.5 + light[1] * 0.866 > 0) light = light.map((x) => -x);
    }
    const along = points.map(([x, y]) => x * light[0] + y * light[1]);
    const [low, high] = [Math.min(...along), Math.max(...along)];
    const [mx, my] = discs.reduce(([x, y], disc) => [x + disc[0] / discs.length, y + disc[1] / discs.length], [0, 0]);
    const centre = mx * light[0] + my * light[1];
    const spot = (reach) => [mx + light[0] * (reach - centre), my + light[1] * (reach - centre)];
    const shade = this.pen.createLinearGradient(...spot(high), ...spot(low));
    const far = (this.range[1] - near) / Math.max(this.range[1] - this.range[0], 1);
    const [bright, base, dark] = shades(tone, between(far, 0, 1));
    shade.addColorStop(0, bright);
    shade.addColorStop(0.45, base);
    shade.addColorStop(1, dark);
    this.line(points, colours.panel, 1.6, true);
    this.cover(points, shade);
  }

  box(corners) {
    const radius = corners[8];
    const discs = corners.slice(0, 8).map((corner) => {
      const seen = this.see(...corner);
      return [seen[0], seen[1], radius * seen[3], seen[2]];
    });
    const draw = () => {
      this.cover(hull(discs), colours.box);
      for (let k = 0; k < 8; ++k) {
        for (const side of [1, 2, 4]) if (!(k & side)) this.line([discs[k], discs[k | side]], colours.box, 1);
      }
    };
    return { near: discs.reduce((sum, disc) => sum + disc[3] / 8, 0), draw };
  }

  // The way to a goal: gone, and still to go.
  way(rows, point, at) {
    const seen = (k) => this.see(rows[3 * point][k], rows[3 * point + 1][k], rows[3 * point + 2][k]);
    const all = Array.from(rows[0], (_, k) => seen(k));
    this.pen.globalAlpha = 0.3;
    this.line(all, colours.way, 1.2);
    this.pen.globalAlpha = 0.9;
    this.line([...all.slice(0, Math.floor(at) + 1), this.see(...this.place(point))], colours.way, 2);
    this.pen.globalAlpha = 1;
  }

  // A ring with its plumb line; one that is out of the picture is an arrow to it at the edge.
  goal([x, y, z]) {
    const [sx, sy, , scale] = this.see(x, y, z);
    const room = 14;
    const [px, py] = [between(sx, room, this.width - room), between(sy, room, this.height - room)];
    const inside = Math.hypot(px - sx, py - sy) < 1;
    const radius = inside ? Math.max(30 * scale, 6) : 10;
    if (inside && y > 60) {
      const foot = this.see(x, 0, z);
      this.pen.setLineDash([2, 4]);
      this.line([[sx, sy + radius], foot], colours.goal, 1.2);
      this.pen.setLineDash([]);
    }
    const ring = kAround.map(([c, s]) => [px + radius * c, py + radius * s]);
    this.line(ring, colours.panel, 5, true);
    this.line(ring, colours.goal, 2.4, true);
    if (inside) return;
    const [ax, ay] = [(sx - px) / Math.hypot(sx - px, sy - py), (sy - py) / Math.hypot(sx - px, sy - py)];
    const tip = (ahead, aside) => [px + ahead * ax - aside * ay, py + ahead * ay + aside * ax];
    this.cover([tip(radius - 1, 0), tip(1 - radius, radius * 0.6), tip(1 - radius, -radius * 0.6)], colours.goal);
  }
}

const scenes = [...document.querySelectorAll('.result')].map((section) => new Scene(section));
let before = 0, asked = false;

// Draws as long as something on the screen moves.
function wake() {
  if (asked) return;
  asked = true;
  requestAnimationFrame((now) => {
    asked = false;
    const seconds = between((now - before) / 1000, 0, 0.1);
    before = now;
    for (const scene of scenes) {
      scene.step(seconds);
      scene.draw();
    }
    if (scenes.some(({ playing, shown }) => playing && shown.size > 0)) wake();
  });
}

const seen = new IntersectionObserver((entries) => {
  for (const { target, isIntersecting } of entries) {
    const scene = scenes.find(({ canvases }) => canvases.includes(target));
    if (isIntersecting) scene.load();
    if (isIntersecting) scene.shown.add(target);
    else scene.shown.delete(target);
  }
  wake();
}, { rootMargin: '80px' });
const resized = new ResizeObserver(wake);

function turnBy(scene, across, down) {
  scene.load();
  scene.turn += across;
  scene.tilt = between(scene.tilt + down, 0.05, 1.2);
  wake();
}

function listen(scene, canvas) {
  let last = null;
  canvas.addEventListener('pointerdown', (event) => {
    last = [event.clientX, event.clientY];
    canvas.setPointerCapture(event.pointerId);
    canvas.classList.add('turning');
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!last) return;
    turnBy(scene, (event.clientX - last[0]) / 90, event.pointerType === 'mouse' ? (event.clientY - last[1]) / 150 : 0);
    last = [event.clientX, event.clientY];
  });
  for (const end of ['pointerup', 'pointercancel']) {
    canvas.addEventListener(end, () => {
      last = null;
      canvas.classList.remove('turning');
    });
  }
  seen.observe(canvas);
  resized.observe(canvas);
}

readColours();
for (const scene of scenes) {
  for (const canvas of scene.canvases) listen(scene, canvas);
  scene.button.addEventListener('click', () => {
    scene.load();
    scene.play(!scene.playing);
  });
  scene.slider.addEventListener('input', () => {
    scene.load();
    scene.playing = false;
    scene.time = scene.slider.value / 1000 * scene.data.seconds;
    wake();
  });
  for (const button of scene.section.querySelectorAll('[data-turn]')) {
    button.addEventListener('click', () => turnBy(scene, Number(button.dataset.turn), 0));
  }
  scene.section.querySelector('.controls').hidden = false;
}
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
  readColours();
  wake();
});
calm.addEventListener('change', () => {
  for (const scene of scenes) {
    scene.loops = !calm.matches;
    if (calm.matches && scene.data) scene.time = scene.data.seconds;
    if (calm.matches) scene.playing = false;
  }
  wake();
});
window.addEventListener('beforeprint', () => {
  for (const scene of scenes) {
    scene.load();
    scene.canvases.forEach((canvas) => scene.shown.add(canvas));
    scene.draw();
  }
});
})();
