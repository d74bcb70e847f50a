// SPDX-License-Identifier: MIT
// The view leaves as a film that a browser plays.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { openStudio, openTab, settled, take, visit } from './support.mjs';
import { readWebm } from './webm.mjs';

const { site, browser } = await visit();

const open = (options = {}) => openStudio(browser, site.url, { viewport: { width: 940, height: 620 }, ...options });

const kLate = 0.25; // s: how much later than it is drawn a slow machine's recorder may get a film's first picture
const kTick = 0.0005; // s: half of a WebM's unit of time

const kFaint = 30; // opacity, of 255, that compression leaves of nothing

/** The moment and the side that are shown, as text: what turning round and back leaves of a number is none. */
const shown = () => JSON.stringify([window.shigusa.time, window.shigusa.look()], (_, value) => (typeof value === 'number' ? value.toFixed(6) : value));

/** Plays a film: its size, its length, and of four moments the opacity of a corner, the share that is opaque, and how much differs from the moment before. */
async function played(context, bytes) {
  const player = await context.newPage(); // the page itself may play none
  const result = await player.evaluate(async (base64) => {
    const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const video = document.createElement('video');
    video.muted = true;
    video.src = URL.createObjectURL(new Blob([data], { type: 'video/webm' }));
    await new Promise((done, failed) => {
      video.onloadeddata = done;
      video.onerror = () => failed(new Error(video.error.message));
    });
    const canvas = new OffscreenCanvas(video.videoWidth, video.videoHeight);
    const pen = canvas.getContext('2d', { willReadFrequently: true });
    const moments = [];
    let before = null;
    for (const share of [0, 0.35, 0.7, 1]) {
      const sought = new Promise((done) => {
        video.onseeked = done;
      });
      video.currentTime = Math.min(share * video.duration, video.duration - 0.05);
      await sought;
      pen.clearRect(0, 0, canvas.width, canvas.height);
      pen.drawImage(video, 0, 0);
      const pixels = pen.getImageData(0, 0, canvas.width, canvas.height).data;
      let changed = 0;
      let opaque = 0;
      for (let k = 3; k < pixels.length; k += 4) if (pixels[k] > 200) ++opaque;
      if (before) for (let k = 0; k < pixels.length; k += 4) if (Math.abs(pixels[k] - before[k]) > 40) ++changed;
      moments.push({ corner: pixels[3], opaque: opaque / (pixels.length / 4), changed: changed / (pixels.length / 4) });
      before = pixels;
    }
    return { width: video.videoWidth, height: video.videoHeight, duration: video.duration, moments };
  }, bytes.toString('base64'));
  await player.close();
  return result;
}

async function filmed(page, choices) {
  await openTab(page, 'take');
  for (const [name, value] of Object.entries(choices)) {
    const field = page.locator(`[data-film="${name}"]`);
    if (typeof value === 'boolean') await field.setChecked(value);
    else await field.selectOption(value);
  }
  const bytes = await take(page, 'film');
  await page.waitForFunction(() => window.shigusa.state.notice?.key === 'filmSaved');
  assert.deepEqual([...bytes.subarray(0, 4)], [0x1a, 0x45, 0xdf, 0xa3], 'an EBML header');
  return { ...await played(page.context(), bytes), file: readWebm(bytes) };
}

/** Every picture is there, at its own time, and each second one that stands for itself, where the file's table says. */
function assertWhole({ seconds, pictures, clusters, cues }, count, fps) {
  assert.equal(pictures.length, count);
  pictures.forEach(({ time_s }, k) => assert.ok(Math.abs(time_s - k / fps) <= kTick, `picture ${k} is at ${time_s} s`));
  assert.ok(Math.abs(seconds - count / fps) < 1e-9, `${seconds} s`);
  assert.ok(pictures.every(({ isKey }, k) => isKey || k % fps !== 0));
  assert.deepEqual(cues, clusters);
}

test('a film has the size and the length that were asked for, moves, and has a background or none', { timeout: 300_000 }, async () => {
  const { page, context, errors } = await open({ seen: true });
  await settled(page);
  await page.waitForFunction(() => !window.shigusa.state.playing);
  const before = await page.evaluate(shown);
  const { duration_s: duration } = await page.evaluate(() => window.shigusa.document.result.candidates[window.shigusa.chosen].summary);
  const plain = await filmed(page, { size: '640 × 360', fps: '24', plays: '2' });
  assert.deepEqual([plain.width, plain.height], [640, 360]);
  assertWhole(plain.file, Math.round(2 * duration * 24), 24);
  assert.ok(Math.abs(plain.duration - plain.file.seconds) < 0.01, `${plain.duration} s of ${plain.file.seconds}`);
  assert.ok(plain.moments.slice(1).every(({ changed }) => changed > 0.002), JSON.stringify(plain.moments));
  assert.ok(plain.moments.every(({ corner }) => corner === 255));

  // the camera goes round: each picture from another side; in the night of one moment, for its six seconds
  const long = Boolean(process.env.SHIGUSA_LONG);
  const turning = await filmed(page, { plays: long ? '0' : '1', turntable: true, transparent: true });
  assertWhole(turning.file, long ? 6 * 24 : Math.round(duration * 24), 24);
  assert.ok(turning.file.pictures.every(({ hasAlpha }) => hasAlpha));
  assert.ok(turning.moments.slice(1).every(({ changed }) => changed > 0.01), JSON.stringify(turning.moments));
  assert.ok(turning.moments.every(({ corner, opaque }) => corner < kFaint && opaque > 0.02 && opaque < 0.5), JSON.stringify(turning.moments));
  assert.equal(await page.evaluate(shown), before, 'all is as it was');
  assert.deepEqual(errors, []);
  await context.close();
});

test('a browser that encodes no pictures records what is played', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await open({ seen: true });
  await settled(page);
  await page.evaluate(() => {
    delete window.VideoEncoder;
  });
  const { duration_s: duration } = await page.evaluate(() => window.shigusa.document.result.candidates[window.shigusa.chosen].summary);
  // how long the page drew nothing: the last picture may come as late
  await page.evaluate(() => {
    window.longest = 0;
    let last = performance.now();
    const tick = (now) => {
      window.longest = Math.max(window.longest, (now - last) / 1000);
      last = now;
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  });
  const film = await filmed(page, { size: '640 × 360', fps: '24', plays: '2' });
  const late = kLate + await page.evaluate(() => window.longest);
  assert.deepEqual([film.width, film.height], [640, 360]);
  // a recorder takes what a busy machine draws of it
  assert.ok(film.duration > duration && film.duration < 2 * duration + late, `${film.duration} s of twice ${duration}`);
  assert.ok(film.moments.slice(1).some(({ changed }) => changed > 0.002), JSON.stringify(film.moments));
  assert.deepEqual(errors, []);
  await context.close();
});

test('a film can be stopped, and a browser that records none says so', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  await openTab(page, 'take');
  await page.locator('[data-film="plays"]').selectOption('0');
  await page.click('[data-format="film"]');
  await page.waitForFunction(() => document.querySelector('.filming progress').value > 0);
  assert.equal(await page.locator('[data-format="film"]').isDisabled(), true);
  assert.deepEqual(await seriousFindings(page, '#panel-take'), []);
  await page.click('[data-film="cancel"]');
  await page.waitForFunction(() => window.shigusa.state.notice?.key === 'filmCancelled');
  assert.equal(await page.locator('.filming').isVisible(), false);
  const { width, height } = await page.locator('canvas.view').evaluate((canvas) => ({ width: canvas.width / canvas.clientWidth, height: canvas.height / canvas.clientHeight }));
  assert.ok(Math.abs(width - height) < 0.01, 'the view has its own size again');
  await page.evaluate(() => {
    delete window.MediaRecorder;
    delete window.VideoEncoder;
  });
  await page.click('[data-format="film"]');
  await page.locator('.message', { hasText: 'does not record WebM films' }).waitFor();
  assert.deepEqual(errors, []);
  await context.close();
});
