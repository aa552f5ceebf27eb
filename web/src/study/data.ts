// What the page of a study shows: the JSON that runtime/analysis/study/study_report.cpp writes, decoded.

import { decodeFloats } from "../data/base64.ts";
import type { Estimate } from "../data/estimate.ts";
import type { AgentModule, BodyLink, GroundShape, Setting } from "../data/report_data.ts";
import type { Strip } from "../page/snapshots.ts";
import type { Replay } from "../replay/motion.ts";

export interface Metric {
  name: string;
  unit: string;
  reduction: string;
  doc: string;
  value: Estimate;
}

export interface Term {
  name: string;
  doc: string;
  value: Estimate;
  share: number | null; // of the sum of all terms' magnitudes, with its sign
}

/** What remains where the runs act in a profile without learning. */
export interface Evaluation {
  profile: string;
  learned_return: Estimate; // of the runs that were evaluated
  return: Estimate; // of the same runs
  share: number | null; // of the two means
  median_share: number | null; // of the runs' own shares
}

export interface StudyRun {
  name: string;
  seed: number;
  state: string;
  episodes: number;
  episodes_planned: number;
  final_return: number | null;
  best_return: number | null;
  episodes_to_80_percent: number | null;
  cpu_minutes_to_80_percent: number | null;
  cpu_minutes: number;
  metrics: Record<string, number>;
  group: number | null; // index
  curve: Float32Array; // moving average at the experiment's episodes; shorter where the run is
}

/** Runs that ended in the same behavior. */
export interface Group {
  name: string; // A, B, …
  runs: number[]; // indices
  typical: number; // the run in the middle
  share: number; // of the runs that ended
  sentences: string[]; // that people wrote
  final_return: Estimate;
  metrics: Metric[];
  recording?: Replay; // of the typical run's last episode
  strip?: Strip; // of the same
}

/** With the weights that the runs had, and with the new ones. */
export interface BeforeAfter<Value> {
  before: Value;
  after: Value;
}

/** What the user's preferences between the runs say of the task's weights. */
export interface Preferences {
  is_consistent: boolean;
  preferences: {
    better: string; // the name of a run, or RUN:EPISODE
    worse: string;
    is_tie: boolean;
    probability: BeforeAfter<number>;
    holds: BeforeAfter<boolean>;
    is_contradicted: boolean;
  }[];
  weights: {
    name: string;
    unit: string;
    before: number;
    after: number;
    low: number;
    high: number;
  }[];
  notes: string[];
}

/** Means over the runs with their 95 % confidence intervals; NaN where there are none. */
export interface Means {
  mean: Float32Array;
  low: Float32Array;
  high: Float32Array;
}

export interface Curve extends Means {
  episodes: Float32Array;
}

/** Of a metric or a reward term, at the episodes of the experiment's curve. */
export interface ValueCurve extends Means {
  name: string;
  unit: string;
}

export interface Experiment {
  name: string;
  task: string;
  task_file: string;
  robot: string;
  profile: string;
  version: string;
  settings: Setting[];
  command: string; // that makes the runs again; empty where it was not written down
  mean_over: number; // episodes
  is_settled: boolean; // all but the runs' own figures are of finished runs; else of all so far
  final_return: Estimate;
  best_return: Estimate;
  episodes_to_80_percent: Estimate;
  cpu_minutes_to_80_percent: Estimate;
  cpu_minutes: Estimate;
  metrics: Metric[];
  terms: Term[];
  evaluations: Evaluation[];
  groups: Group[];
  runs: StudyRun[];
  preferences?: Preferences; // where any were stated
  curve: Curve;
  metricCurves: ValueCurve[];
  termCurves: ValueCurve[];
  modules: Record<string, AgentModule>;
  agentText: string;
  source: string; // the task's own text
  body: BodyLink[];
  ground: GroundShape;
}

export interface Study {
  folder: string; // its name
  path: string; // as the user called it
  madeAt: string;
  experiments: Experiment[];
  notes: string[];
}

type Encoded<Value> = {
  [Key in keyof Value]: Value[Key] extends Float32Array ? string : Value[Key];
};
interface EncodedGroup extends Omit<Group, "recording"> {
  recording?: Encoded<Replay>;
}
interface EncodedExperiment
  extends Omit<Experiment, "curve" | "metricCurves" | "termCurves" | "runs" | "groups"> {
  curve: Encoded<Curve>;
  metricCurves: Encoded<ValueCurve>[];
  termCurves: Encoded<ValueCurve>[];
  runs: Encoded<StudyRun>[];
  groups: EncodedGroup[];
}

const decodeGroup = ({ recording, ...group }: EncodedGroup): Group => ({
  ...group,
  ...(recording && { recording: { ...recording, poses: decodeFloats(recording.poses) } }),
});

const decodeMeans = <Value extends Encoded<Means>>(
  encoded: Value,
): Omit<Value, keyof Means> & Means => ({
  ...encoded,
  mean: decodeFloats(encoded.mean),
  low: decodeFloats(encoded.low),
  high: decodeFloats(encoded.high),
});

const decodeExperiment = (experiment: EncodedExperiment): Experiment => ({
  ...experiment,
  curve: {
    ...decodeMeans(experiment.curve),
    episodes: decodeFloats(experiment.curve.episodes),
  },
  metricCurves: experiment.metricCurves.map(decodeMeans),
  termCurves: experiment.termCurves.map(decodeMeans),
  runs: experiment.runs.map((run) => ({ ...run, curve: decodeFloats(run.curve) })),
  groups: experiment.groups.map(decodeGroup),
});

/** The study as `text` (JSON) says it. */
export function decodeStudy(text: string): Study {
  const encoded = JSON.parse(text) as Omit<Study, "experiments"> & {
    experiments: EncodedExperiment[];
  };
  return { ...encoded, experiments: encoded.experiments.map(decodeExperiment) };
}
