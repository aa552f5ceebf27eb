// The curves of several runs on one chart, with their mean and its confidence interval.

import type { MeanCurve } from "../data/mean_of_runs.ts";
import type { ChartOptions } from "./episode_chart.ts";

/** Series before those of the runs: low and high; after them comes the mean. */
export const kBeforeRuns = 2;

/** `values` with NaN up to `length`. */
function padded(values: Float32Array, length: number): Float32Array {
  const whole = new Float32Array(length).fill(NaN);
  whole.set(values);
  return whole;
}

export function chartOfRuns(
  episode: Float32Array,
  { mean, low, high }: MeanCurve,
  runs: { name: string; values: Float32Array; color: string }[],
): Pick<ChartOptions, "episode" | "series" | "bands"> {
  const invisible = { color: "--none", kind: "line" as const, width: 0 };
  return {
    episode,
    series: [
      { ...invisible, name: "95 % low", values: low },
      { ...invisible, name: "95 % high", values: high },
      ...runs.map(({ name, values, color }) => ({
        name,
        values: padded(values, episode.length),
        color,
        kind: "line" as const,
        width: 1.25,
      })),
      { name: "mean", values: mean, color: "--ink", kind: "line", width: 2.5 },
    ],
    bands: [{ upper: 1, lower: 0, color: "--band" }],
  };
}
