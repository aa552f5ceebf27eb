// Runs and groups as text.

import { seriesColor } from "../charts/series.ts";
import type { Format } from "../data/estimate.ts";
import { formatCount } from "../data/words.ts";
import type { Group } from "./data.ts";

/** What "–" stands for where a whole number is missing. */
export const count: Format = (value) => (value === undefined ? "–" : formatCount(value));

export const runs = (number: number): string =>
  number === 1 ? "1 run" : `${formatCount(number)} runs`;

/** "5 of 7 runs, 71 %" */
export function shareOf(group: Group): string {
  const all = Math.round(group.runs.length / group.share);
  return `${formatCount(group.runs.length)} of ${runs(all)}, ${(100 * group.share).toFixed(0)} %`;
}

/** The color of a group, by its name in the style sheet. */
export const colorOf = (group: number | null): string =>
  group === null ? "--ink-faint" : seriesColor(group);
