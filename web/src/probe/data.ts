// What the page of a probe shows: the JSON that runtime/analysis/probe/probe_page.cpp writes, decoded.

import { decodeFloats } from "../data/base64.ts";
import type { AgentModule, BodyLink, GroundShape } from "../data/report_data.ts";
import type { Strip } from "../page/snapshots.ts";
import type { Replay } from "../replay/motion.ts";

/** A motion that a search has found. */
export interface Find {
  name: string; // A, B, …
  run: string;
  seed: number;
  episode: number;
  return: number;
  seconds: number; // that it lasted
  end: { kind: string; reason: string };
  searches: number; // that found such a motion
  frequency: number | null; // of the motion [Hz], where its search knows one
  greatest_speed: number; // of the base [m/s]
  greatest_height: number; // [m]
  beyond: string[]; // what no sound simulation has: "a speed of 13.1 m/s"
  terms: { name: string; doc: string; value: number; share: number }[];
  metrics: { name: string; unit: string; doc: string; value: number | null }[];
  modules: Record<string, AgentModule>; // of the search's agent
  strip: Strip; // of the whole episode
  repetition: Strip | null; // of one period, where the motion is repeated
  recording: Replay;
}

export interface Probe {
  folder: string;
  task: string;
  source: string; // the task's own text
  robot: string;
  profile: string;
  searches: number;
  episodes: number; // of all searches
  diverged: number; // as many of these
  cpu_minutes: number;
  finds: Find[]; // the best first
  left_out: number; // that would follow
  notes: string[];
  body: BodyLink[];
  ground: GroundShape;
  madeAt: string;
}

interface EncodedFind extends Omit<Find, "recording"> {
  recording: Omit<Replay, "poses"> & { poses: string };
}

/** The probe as `text` (JSON) says it. */
export function decodeProbe(text: string): Probe {
  const encoded = JSON.parse(text) as Omit<Probe, "finds"> & { finds: EncodedFind[] };
  const finds = encoded.finds.map((find) => ({
    ...find,
    recording: { ...find.recording, poses: decodeFloats(find.recording.poses) },
  }));
  return { ...encoded, finds };
}
