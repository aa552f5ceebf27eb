// What the trainer shows of its episodes, decoded (docs/api.md, "The view").

import type { ToldGoal } from "../data/report_data.ts";

export interface PhaseWords {
  name: string;
  doc: string;
  source: number;
  line: number;
}

/** One of the things that the numbers of a frame say. */
export interface ViewValue {
  kind: "term" | "metric" | "goal" | "phase" | "memory" | "sensor" | "log" | "shadow";
  name: string;
  type: string;
  unit: string;
  doc: string;
  size: number;
  elements?: string[]; // where it has several numbers
  source?: number; // index among the task's texts
  line?: number; // from 1
  phases?: PhaseWords[];
  first: number; // its first number in a frame
}

export interface Layout {
  module: string;
  task: string;
  hash: string;
  links: number;
  poses: number; // links, then things
  size: number; // of a frame
  values: ViewValue[];
}

/** An instant, or an episode from its start to its end. */
export interface Clip {
  layout: Layout;
  isEpisode: boolean;
  episode: number;
  steps: number; // time steps at the last frame
  frames: number;
  interval: number; // between two frames [s]
  isOver: boolean;
  numbers: Float32Array; // [frame][layout.size]
}

const kHeader = 7; // doubles
const kOfEpisode = 3; // time, return, actions
const kOfPose = 7;

export const poseOffset = kOfEpisode;
export const poseSize = (layout: Layout): number => layout.poses * kOfPose;
export const contactOffset = (layout: Layout): number => kOfEpisode + poseSize(layout);

export function decodeLayout(text: string): Layout {
  const layout = JSON.parse(text) as Layout;
  let first = contactOffset(layout) + layout.links;
  for (const value of layout.values) {
    value.first = first;
    first += value.size;
  }
  if (first !== layout.size) throw new Error("a frame's layout does not add up");
  return layout;
}

export function decodeClip(layout: Layout, bytes: ArrayBuffer): Clip {
  const header = new Float64Array(bytes, 0, kHeader);
  const at = (index: number): number => header[index] as number;
  const numbers = new Float32Array(bytes, kHeader * Float64Array.BYTES_PER_ELEMENT);
  const frames = at(3);
  if (numbers.length !== frames * layout.size) throw new Error("a frame is cut off");
  return {
    layout,
    isEpisode: at(0) === 1,
    episode: at(1),
    steps: at(2),
    frames,
    interval: at(4),
    isOver: at(5) === 1,
    numbers,
  };
}

/** One frame of a clip. */
export class Frame {
  private readonly begin: number;

  constructor(
    readonly clip: Clip,
    readonly index: number,
  ) {
    this.begin = index * clip.layout.size;
  }

  get time(): number {
    return this.number(0);
  }
  get return(): number {
    return this.number(1);
  }
  get actions(): number {
    return this.number(2);
  }
  get poses(): Float32Array {
    return this.part(poseOffset, poseSize(this.clip.layout));
  }
  get contacts(): Float32Array {
    return this.part(contactOffset(this.clip.layout), this.clip.layout.links);
  }

  number(offset: number): number {
    return this.clip.numbers[this.begin + offset] ?? NaN;
  }
  valuesOf({ first, size }: ViewValue): Float32Array {
    return this.part(first, size);
  }

  private part(offset: number, size: number): Float32Array {
    return this.clip.numbers.subarray(this.begin + offset, this.begin + offset + size);
  }
}

const sensorIn = ({ clip }: Frame, name: string): ViewValue | undefined =>
  clip.layout.values.find((value) => value.kind === "sensor" && value.name === name);

/** Of all contacts of each link, [link][x, y, z] [N], where the task reads them. */
export function forcesIn(frame: Frame): Float32Array | undefined {
  const sensor = sensorIn(frame, "contact_force");
  return sensor && frame.valuesOf(sensor);
}

/** By the names of the joints [N m], where the task reads them. */
export function torquesIn(frame: Frame): Map<string, number> {
  const sensor = sensorIn(frame, "joint.torque");
  const torques = sensor ? frame.valuesOf(sensor) : new Float32Array();
  const jointIn = (element: string): string => /\[(.*)\]$/.exec(element)?.[1] ?? element;
  return new Map(sensor?.elements?.map((element, i) => [jointIn(element), torques[i] ?? NaN]));
}

/** As they hold in this frame. */
export const goalsIn = (frame: Frame): ToldGoal[] =>
  frame.clip.layout.values
    .filter(({ kind }) => kind === "goal")
    .map((goal) => ({ ...goal, time: frame.time, value: [...frame.valuesOf(goal)] }));
