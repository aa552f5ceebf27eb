// What several runs have in common: at each episode the mean of their values, with its confidence
// interval of 95 % (Student's t) where at least two have got there.

export interface MeanCurve {
  mean: Float32Array;
  low: Float32Array;
  high: Float32Array;
}

/** The 97.5 % quantiles of Student's t for 1 to 30 degrees of freedom; Abramowitz and Stegun, 26.10. */
const kQuantiles = [
  12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.16, 2.145,
  2.131, 2.12, 2.11, 2.101, 2.093, 2.086, 2.08, 2.074, 2.069, 2.064, 2.06, 2.056, 2.052, 2.048, 2.045,
  2.042,
];
const kNormal = 1.95996;

/** Of more degrees of freedom the first terms of its expansion (26.7.5), right to 0.0001. */
export function quantileOfT(freedom: number): number {
  const listed = kQuantiles[freedom - 1];
  if (listed !== undefined) return listed;
  const [z3, z5] = [kNormal ** 3, kNormal ** 5];
  return (
    kNormal + (z3 + kNormal) / (4 * freedom) + (5 * z5 + 16 * z3 + 3 * kNormal) / (96 * freedom ** 2)
  );
}

export function meanOfRuns(curves: Float32Array[]): MeanCurve {
  const length = Math.max(0, ...curves.map((curve) => curve.length));
  const filled = (): Float32Array => new Float32Array(length).fill(NaN);
  const [mean, low, high] = [filled(), filled(), filled()];
  for (let i = 0; i < length; ++i) {
    let [count, sum, squares] = [0, 0, 0];
    for (const curve of curves) {
      const value = curve[i];
      if (value === undefined || !Number.isFinite(value)) continue;
      count += 1;
      sum += value;
    }
    if (count === 0) continue;
    const middle = sum / count;
    mean[i] = middle;
    if (count < 2) continue;
    for (const curve of curves) {
      const value = curve[i];
      if (value !== undefined && Number.isFinite(value)) squares += (value - middle) ** 2;
    }
    const half = quantileOfT(count - 1) * Math.sqrt(squares / (count - 1) / count);
    [low[i], high[i]] = [middle - half, middle + half];
  }
  return { mean, low, high };
}
