// Estimates and groups as text.

import { formatCount, formatNumber } from "../data/words.ts";
import type { Estimate, Group } from "./data.ts";

type Format = (value: number | undefined) => string;

const orNothing = (value: number | null): number | undefined => value ?? undefined;

/** "12.3", or "–" where there is no value. */
export const mean = (estimate: Estimate, format: Format = formatNumber): string =>
  format(orNothing(estimate.mean));

/** "10.1 … 14.5"; empty where there are too few runs for an interval. */
export function interval({ low, high }: Estimate, format: Format = formatNumber): string {
  return low === null || high === null ? "" : `${format(low)} … ${format(high)}`;
}

/** The least and the greatest value; empty of one run. */
export function range({ count, least, greatest }: Estimate, format: Format = formatNumber): string {
  return count < 2 ? "" : `${format(orNothing(least))} … ${format(orNothing(greatest))}`;
}

/** What "–" stands for where a whole number is missing. */
export const count: Format = (value) => (value === undefined ? "–" : formatCount(value));

export const runs = (number: number): string =>
  number === 1 ? "1 run" : `${formatCount(number)} runs`;

/** "5 of 7 runs, 71 %" */
export function shareOf(group: Group): string {
  const all = Math.round(group.runs.length / group.share);
  return `${formatCount(group.runs.length)} of ${runs(all)}, ${(100 * group.share).toFixed(0)} %`;
}

const kColors = 8; // --series-1 … --series-8

/** The colour of a group, by its name in the style sheet. */
export const colorOf = (group: number | null): string =>
  group === null ? "--ink-faint" : `--series-${(group % kColors) + 1}`;
