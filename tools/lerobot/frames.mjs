// SPDX-License-Identifier: MIT
// Frames at a fixed rate, of series that have equally many frames whatever a motion takes.

// The times of a motion's frames (s): 0, 1/fps, … up to the first that is at its end or later. The
// last one has the motion's last frame, which may come less than 1/fps late.
export function frameTimes(duration, fps) {
  const steps = Math.max(1, Math.ceil(duration * fps - 1e-6));
  return Array.from({ length: steps + 1 }, (_, k) => k / fps);
}

// A series (frames × width) at these times, linear between its frames; its first and last one stay
// as they are. Result: (times × width).
export function resampled(series, width, duration, times) {
  const last = series.length / width - 1;
  const values = new Float32Array(times.length * width);
  times.forEach((time, k) => {
    const at = k === times.length - 1 ? last : Math.min((time / duration) * last, last);
    const before = Math.min(Math.floor(at), last - 1);
    const share = at - before;
    for (let i = 0; i < width; ++i) {
      const from = series[before * width + i];
      const to = series[(before + 1) * width + i];
      values[k * width + i] = share === 1 ? to : from + share * (to - from);
    }
  });
  return values;
}

// Each frame's next one; the last frame's is itself.
export function nextFrames(values, width) {
  const next = new Float32Array(values.length);
  next.set(values.subarray(width));
  next.set(values.subarray(values.length - width), values.length - width);
  return next;
}
