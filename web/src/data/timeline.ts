// What a recorded episode paid, measured and touched: the JSON that
// runtime/analysis/report/report_timeline.cpp writes, decoded.

import { decodeBytes, decodeFloats } from "./base64.ts";

/** What something paid: since the sample before, and since the start of the episode. */
export interface Payments {
  paid: Float64Array; // [sample]
  sum: Float64Array; // [sample]
}

export interface TermTrace extends Payments {
  name: string;
  doc: string;
}

export interface MetricTrace {
  name: string;
  unit: string;
  reduction: string;
  doc: string;
  values: Float64Array; // [sample]; NaN where there is none
}

/** A sample at each frame of the recording, and one at the end of the episode. */
export interface Timeline {
  interval: number; // between two frames [s]
  times: Float64Array; // [sample], ascending [s]
  total: Payments; // its sum at the end is the episode's return
  terms: TermTrace[];
  metrics: MetricTrace[];
  phases?: { names: string[]; values: Float64Array }; // the number of the present one, [sample]
  contacts: Uint8Array; // [sample][link]: bit i % 8 of byte i / 8
}

interface Encoded {
  end: number;
  returns: string;
  terms: { name: string; doc: string; values: string }[];
  metrics: { name: string; unit: string; reduction: string; doc: string; values: string }[];
  phases?: { names: string[]; values: string };
  contacts: string;
}

export type EncodedTimeline = Encoded | null;

function paymentsOf(paid: Float64Array): Payments {
  const sum = new Float64Array(paid.length);
  let before = 0;
  paid.forEach((value, i) => (sum[i] = before += value));
  return { paid, sum };
}

/** Of a recording with so many frames. Where it ends with its last frame, both are one sample. */
export function decodeTimeline(
  encoded: EncodedTimeline | undefined,
  { frames, interval }: { frames: number; interval: number },
): Timeline | undefined {
  if (!encoded) return undefined;
  const isOne = encoded.end <= (frames - 1) * interval + 1e-6;
  const count = isOne ? frames : frames + 1;
  const times = Float64Array.from({ length: count }, (_, i) =>
    i < frames ? i * interval : encoded.end,
  );
  const samples = (text: string): Float64Array => {
    const values = Float64Array.from(decodeFloats(text));
    if (isOne) values[frames - 1] = values[frames] as number;
    return values.subarray(0, count);
  };
  const payments = (text: string): Payments => {
    const paid = Float64Array.from(decodeFloats(text));
    if (isOne) paid[frames - 1]! += paid[frames] as number;
    return paymentsOf(paid.subarray(0, count));
  };
  const { phases } = encoded;
  return {
    interval,
    times,
    total: payments(encoded.returns),
    terms: encoded.terms.map(({ values, ...term }) => ({ ...term, ...payments(values) })),
    metrics: encoded.metrics.map((metric) => ({ ...metric, values: samples(metric.values) })),
    ...(phases && { phases: { names: phases.names, values: samples(phases.values) } }),
    contacts: decodeBytes(encoded.contacts),
  };
}

/** When the episode was over [s]. */
export const endOf = ({ times }: Timeline): number => times.at(-1) ?? 0;

/** The index of the last sample not after `time` [s]. */
export function sampleAt({ times, interval }: Timeline, time: number): number {
  const last = times.length - 1;
  if (time >= (times[last] ?? 0) - 1e-6) return last;
  return Math.min(Math.max(0, Math.floor(time / interval + 1e-6)), Math.max(0, last - 1));
}

/** Whether a link touched something, of a robot with `links` of them. */
export function touches({ contacts }: Timeline, links: number, sample: number, link: number): boolean {
  const bytes = Math.ceil(links / 8);
  return (((contacts[sample * bytes + (link >> 3)] ?? 0) >> (link & 7)) & 1) === 1;
}

const kTellingSpan = 0.4; // over which payments are added to find the best moment [s]
const kAway = 0.1; // of the episode, at its start and its end, that tells little

/** The middle of the stretch that paid most: what to show of an episode first [s]. */
export function tellingTime({ total, times, interval }: Timeline): number {
  const half = Math.max(1, Math.round(kTellingSpan / interval / 2));
  const last = times.length - 1;
  const first = Math.ceil(kAway * last) + half;
  let best = Math.floor(last / 2);
  let most = -Infinity;
  for (let i = first; i <= last - first; ++i) {
    const paid = (total.sum[i + half] as number) - (total.sum[i - half] as number);
    if (paid > most) [best, most] = [i, paid];
  }
  return times[best] ?? 0;
}
