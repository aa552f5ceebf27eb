// Means and ranges of an episode's values. Values that are not finite count as missing.

type Values = ArrayLike<number>;

/**
 * For each value the mean of the last `window` values up to it (of those there are). It begins anew
 * at each index of `starts`, and with the first value where others are missing before it: there not
 * with a single one, which would be chance, but NaN until half of the window is full, or half of
 * what there is up to the next start.
 */
export function runningMean(values: Values, window: number, starts: number[] = []): Float32Array {
  const means = new Float32Array(values.length);
  let sum = 0;
  let count = 0;
  const add = (index: number, sign: number): void => {
    const value = values[index];
    if (value === undefined || !Number.isFinite(value)) return;
    sum += sign * value;
    count += sign;
  };
  const allStarts = [...starts, Array.prototype.findIndex.call(values, Number.isFinite)];
  let first = 0;
  let least = 1;
  for (let i = 0; i < values.length; ++i) {
    if (i > 0 && allStarts.includes(i)) {
      const next = starts.find((start) => start > i) ?? values.length;
      [first, sum, count] = [i, 0, 0];
      least = Math.ceil(Math.min(window, next - i) / 2);
    }
    add(i, 1);
    if (i - window >= first) add(i - window, -1);
    means[i] = count > 0 && i - first + 1 >= least ? sum / count : NaN;
  }
  return means;
}

/** The same of what a shadow says, only where it was there: a mean goes on where there is nothing. */
export const runningMeanWhereThere = (values: Values, window: number): Float32Array =>
  runningMean(values, window).map((mean, i) => (Number.isFinite(values[i]) ? mean : NaN));

/** Numbers of episodes over which the page can take its means. */
export const kWindows = [1, 3, 5, 10, 20, 50, 100, 200, 500, 1000];

/** The greatest window that is at most a tenth of the run. */
export const usualWindow = (episodes: number): number =>
  kWindows.findLast((window) => window * 10 <= episodes) ?? 1;

/** Mean and standard deviation of the last `count` values. */
export function lastValues(values: Values, count: number): { mean: number; deviation: number } {
  const last: number[] = [];
  for (let i = Math.max(0, values.length - count); i < values.length; ++i) {
    const value = values[i] as number;
    if (Number.isFinite(value)) last.push(value);
  }
  const mean = last.reduce((sum, value) => sum + value, 0) / last.length;
  const variance = last.reduce((sum, value) => sum + (value - mean) ** 2, 0) / last.length;
  return { mean, deviation: Math.sqrt(variance) };
}

/** The index of the greatest value; -1 where there is none. */
export function indexOfMaximum(values: Values): number {
  let best = -1;
  for (let i = 0; i < values.length; ++i) {
    const value = values[i] as number;
    if (Number.isFinite(value) && (best < 0 || value > (values[best] as number))) best = i;
  }
  return best;
}
