// Means of several values, as data and as text.

import { formatNumber } from "./words.ts";

/** A mean with its confidence interval of 95 %; null where there are too few values. */
export interface Estimate {
  count: number;
  mean: number | null;
  low: number | null;
  high: number | null;
  least: number | null;
  greatest: number | null;
}

export type Format = (value: number | undefined) => string;

const orNothing = (value: number | null): number | undefined => value ?? undefined;

/** "12.3", or "–" where there is no value. */
export const mean = (estimate: Estimate, format: Format = formatNumber): string =>
  format(orNothing(estimate.mean));

/** "10.1 … 14.5"; empty where there are too few values for an interval. */
export function interval({ low, high }: Estimate, format: Format = formatNumber): string {
  return low === null || high === null ? "" : `${format(low)} … ${format(high)}`;
}

/** The least and the greatest value; empty of one. */
export function range({ count, least, greatest }: Estimate, format: Format = formatNumber): string {
  return count < 2 ? "" : `${format(orNothing(least))} … ${format(orNothing(greatest))}`;
}
