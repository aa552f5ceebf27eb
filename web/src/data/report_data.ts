// What the page shows: the JSON that runtime/analysis/report/report_data.cpp writes into the page, decoded.

import { decodeFloats } from "./base64.ts";
import type { Estimate } from "./estimate.ts";
import { decodeTimeline, type EncodedTimeline, type Timeline } from "./timeline.ts";

/** What a link hangs on: plugins/robot/robot_description.h. */
export interface Joint {
  name: string;
  kind: "hinge" | "continuous" | "slider";
  parent: number; // index of the link
  axis: [number, number, number];
  stops?: [number, number]; // [rad]
  radius?: number; // of a slider's pinion [m]
  offset?: [number, number, number]; // of a slider's link from its parent, at angle 0 [m]
}

/** A link of the robot, or a thing of its world; lengths in meters, `axis` 0, 1, 2 = x, y, z of the link's own frame. */
export interface BodyLink {
  name: string;
  shape: "box" | "capsule" | "cylinder" | "sphere" | "convex";
  size: [number, number, number]; // box: full extents
  radius: number; // capsule, cylinder, sphere
  length: number; // capsule: total, both caps included; cylinder
  axis: number;
  points?: [number, number, number][]; // convex: the shape is their hull
  // Of the shape in the link's frame, where it is not around the center and along the axes.
  position?: [number, number, number];
  orientation?: [number, number, number, number]; // w, x, y, z
  thing?: true;
  mass?: number; // of a link, about its center [kg]; not of a run of before it was recorded
  joint?: Joint;
}

/** What the robot stands on. */
export interface GroundShape {
  normal: [number, number, number]; // of the plane through the origin
  blocks: { low_x: number; high_x: number; height: number }[]; // of stairs
  hills?: {
    columns: number;
    rows: number;
    size: [number, number]; // along x and y [m]
    center: [number, number];
    heights: number[]; // row by row, the one with the least y first [m]
  };
}

/** What a replay shows besides the motion. */
export interface Scenery {
  body: BodyLink[];
  ground: GroundShape;
}

export interface EpisodeEnd {
  kind: string;
  reason: string;
  count: number;
}

export interface Curve {
  name: string;
  unit: string;
  reduction: string; // of a metric or a log: last, sum, max, min, mean; "" for a reward term
  doc: string;
  tasks: number[]; // indices of the tasks that have it
  values: Float32Array; // one for each episode; NaN where there is none
}

/** What the learner shows of itself. */
export interface LearnerCurve {
  name: string;
  unit: string;
  doc: string;
  values: Float32Array; // one for each episode; NaN where there is none
}

/** A task that was loaded. */
export interface Task {
  module: string;
  name: string;
  file: string;
  hash: string;
  sources: Source[]; // its own first
}

/** The episodes, both ends included, in which a task was the active one. */
export interface Version {
  task: number; // index
  first: number;
  last: number;
}

/** A task module that was evaluated beside the active one; its returns. */
export interface Shadow {
  module: string;
  tasks: number[]; // indices
  values: Float32Array; // one for each episode; NaN where it was none
}

/** What was done to the run while it learned. */
export interface Change {
  episode: number; // in which it took effect
  step: number; // time steps done in that episode before it
  at: string;
  kind: string;
  text: string;
  difference?: string; // in meaning, line by line, of the task that came from the one before
}

/** What the run had learned after an episode, acting in a profile without learning. */
export interface Evaluation {
  profile: string;
  checkpoint_episode: number;
  return: Estimate; // over the episodes of the evaluation
  learned_return: number | null;
  share: number | null; // of the learned return
  ends: Record<string, number>; // how many episodes ended so
}

/** From a time on, what the robot was told. */
export interface ToldGoal {
  time: number; // since the start of the episode [s]
  name: string;
  type: string; // "vec2"
  unit: string;
  value: number[]; // 0 or 1 for a bool
}

/** `poses` holds [frame][link][7]: x, y, z [m], then the quaternion w, x, y, z. */
export interface Recording {
  episode: number;
  best: boolean;
  task: number; // index of the one that paid
  end: { kind: string; reason: string };
  frames: number;
  interval: number; // between two frames [s]
  goals: ToldGoal[]; // in the order of time
  poses: Float32Array;
  timeline?: Timeline; // of a run by a version that records it
}

export interface AgentModule {
  type?: string;
  [parameter: string]: unknown;
}

/** One of the texts that the task is made of. */
export interface Source {
  file: string;
  text: string;
}

/** What the user has set in the agent or the task of a run. */
export interface Setting {
  name: string; // "task.fall_penalty"
  value: string;
  origin: string; // "--set", or the place in a file
}

export interface Report extends Scenery {
  run: Record<string, string>;
  settings: Setting[];
  command: string; // that makes the run again; empty where it was not written down
  tasks: Task[];
  versions: Version[]; // in the order of the episodes
  shadows: Shadow[];
  changes: Change[];
  evaluations: Evaluation[];
  agentText: string;
  modules: Record<string, AgentModule>;
  madeAt: string;
  episode: Float32Array; // the episodes' numbers
  returns: Float32Array;
  endOf: number[]; // index into `ends`, one for each episode
  ends: EpisodeEnd[];
  simulatedSeconds: number;
  wallSeconds: number;
  faults: number;
  violations: number;
  terms: Curve[];
  metrics: Curve[];
  logs: Curve[];
  goals: Curve[]; // of each element the mean over the episode
  phases: Curve[]; // two of each: the time that it lasted, and its return
  learner: LearnerCurve[];
  recordings: Recording[]; // in the order of their episodes
  notes: string[]; // what was left out, in sentences
}

interface EncodedCurve extends Omit<Curve, "values"> {
  values: string;
}
interface EncodedLearnerCurve extends Omit<LearnerCurve, "values"> {
  values: string;
}
interface EncodedShadow extends Omit<Shadow, "values"> {
  values: string;
}
interface EncodedRecording extends Omit<Recording, "poses" | "timeline"> {
  poses: string;
  timeline: EncodedTimeline;
}
export interface EncodedReport extends Omit<
  Report,
  | "episode"
  | "returns"
  | "terms"
  | "metrics"
  | "logs"
  | "goals"
  | "phases"
  | "learner"
  | "shadows"
  | "recordings"
> {
  episode: string;
  returns: string;
  terms: EncodedCurve[];
  metrics: EncodedCurve[];
  logs: EncodedCurve[];
  goals: EncodedCurve[];
  phases: EncodedCurve[];
  learner: EncodedLearnerCurve[];
  shadows: EncodedShadow[];
  recordings: EncodedRecording[];
}

const decodeValues = <Encoded extends { values: string }>(
  curve: Encoded,
): Omit<Encoded, "values"> & { values: Float32Array } => ({
  ...curve,
  values: decodeFloats(curve.values),
});

/** The report as `text` (JSON) says it. */
export const decodeReport = (text: string): Report =>
  decodeParsed(JSON.parse(text) as EncodedReport);

/** The same of the object that the text stands for. */
export function decodeParsed(encoded: EncodedReport): Report {
  return {
    ...encoded,
    episode: decodeFloats(encoded.episode),
    returns: decodeFloats(encoded.returns),
    terms: encoded.terms.map(decodeValues),
    metrics: encoded.metrics.map(decodeValues),
    logs: encoded.logs.map(decodeValues),
    goals: encoded.goals.map(decodeValues),
    phases: encoded.phases.map(decodeValues),
    learner: encoded.learner.map(decodeValues),
    shadows: encoded.shadows.map(decodeValues),
    recordings: encoded.recordings.map(decodeRecording),
  };
}

function decodeRecording({ timeline: encoded, ...recording }: EncodedRecording): Recording {
  const timeline = decodeTimeline(encoded, recording);
  return { ...recording, poses: decodeFloats(recording.poses), ...(timeline && { timeline }) };
}
