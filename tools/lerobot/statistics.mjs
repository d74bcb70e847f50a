// SPDX-License-Identifier: MIT
// Least, greatest, mean and standard deviation of a feature's numbers, of an episode and of all.

// Of numbers (rows × width), along the rows.
export function statisticsOf(values, width) {
  const count = values.length / width;
  const each = (value) => Array.from({ length: width }, () => value);
  const min = each(Infinity);
  const max = each(-Infinity);
  const mean = each(0);
  const squares = each(0);
  values.forEach((value, k) => {
    const i = k % width;
    min[i] = Math.min(min[i], value);
    max[i] = Math.max(max[i], value);
    mean[i] += value / count;
  });
  values.forEach((value, k) => {
    squares[k % width] += (value - mean[k % width]) ** 2;
  });
  return { min, max, mean, std: squares.map((sum) => Math.sqrt(sum / count)), count };
}

// Of the rows of both, by Chan's formula.
export function merged(a, b) {
  if (!a) return b;
  const count = a.count + b.count;
  const mean = a.mean.map((value, i) => value + ((b.mean[i] - value) * b.count) / count);
  const std = a.std.map((value, i) => {
    const apart = ((b.mean[i] - a.mean[i]) ** 2 * a.count * b.count) / count;
    return Math.sqrt((value ** 2 * a.count + b.std[i] ** 2 * b.count + apart) / count);
  });
  return {
    min: a.min.map((value, i) => Math.min(value, b.min[i])),
    max: a.max.map((value, i) => Math.max(value, b.max[i])),
    mean,
    std,
    count,
  };
}
