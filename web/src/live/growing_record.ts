// The run's episodes: those that were there when the page was opened, and each that is over since.

import type { Change, Report } from "../data/report_data.ts";
import type { Layout } from "./view_frames.ts";

/** An episode, as the trainer tells it when it is over (docs/api.md, "Events"). */
export interface EpisodeEvent {
  episode: number;
  task: string;
  return: number;
  end: { kind: string; reason: string };
  terms: Record<string, number | null>;
  metrics: Record<string, number | null>;
  learner: Record<string, number | null>;
  shadows?: Record<string, { task: string; return: number }>;
  wall_seconds: number;
  simulated_seconds: number;
}

export type CurveKind = "term" | "metric" | "learner" | "shadow";

/** One number of each episode; NaN where there is none. */
export interface GrowingCurve {
  kind: CurveKind;
  name: string;
  unit: string;
  doc: string;
  values: number[];
}

const kLeftOver = 20; // episodes over which the time that is left is estimated

export class GrowingRecord {
  episodes: number[] = [];
  returns: number[] = [];
  changes: Change[] = [];
  readonly curves: GrowingCurve[] = [];
  lastEnd = "";
  private readonly wallSeconds: number[] = [];

  constructor(report: Report) {
    this.read(report);
  }

  /** What the trainer has in its record now, in the place of what was known. Curves that are still
   * there stay the same objects. */
  read(report: Report): void {
    this.episodes = Array.from(report.episode);
    this.returns = Array.from(report.returns);
    this.changes = [...report.changes];
    for (const curve of this.curves) curve.values = this.episodes.map(() => NaN);
    for (const each of report.terms) this.take("term", each);
    for (const each of report.metrics) this.take("metric", each);
    for (const each of report.learner) this.take("learner", each);
    for (const { module, values } of report.shadows) {
      this.take("shadow", { name: module, unit: "", doc: "", values });
    }
  }

  /** What the trainer says of changes that were heard of as they happened; whether that is news. */
  takeDifferences(changes: Change[]): boolean {
    let isNews = false;
    for (const change of this.changes) {
      if (change.difference !== undefined) continue;
      const same = changes.find(({ episode, step, text, difference }) =>
        difference !== undefined && episode === change.episode && step === change.step && text === change.text);
      if (!same) continue;
      change.difference = same.difference;
      isNews = true;
    }
    return isNews;
  }

  /** Adds an episode; one that comes again, since the trainer went back to a checkpoint, takes the
   * place of what was there from it on. `layout`: what is known of names that are new. */
  add(event: EpisodeEvent, layout: Layout | undefined): void {
    const known = this.episodes.indexOf(event.episode);
    if (known >= 0) this.cutTo(known);
    this.episodes.push(event.episode);
    this.returns.push(event.return);
    const shadows = Object.entries(event.shadows ?? {}).map(([name, shadow]) => [name, shadow.return]);
    this.addTo("term", event.terms, layout);
    this.addTo("metric", event.metrics, layout);
    this.addTo("learner", event.learner, layout);
    this.addTo("shadow", Object.fromEntries(shadows) as Record<string, number>, layout);
    for (const { values } of this.curves) {
      if (values.length < this.episodes.length) values.push(NaN);
    }
    this.lastEnd = [event.end.kind, event.end.reason].filter(Boolean).join(": ");
    this.wallSeconds.push(event.wall_seconds);
    if (this.wallSeconds.length > kLeftOver) this.wallSeconds.shift();
  }

  /** [s], for `episodes` more of them; NaN where that cannot be known yet. */
  secondsFor(episodes: number): number {
    const sum = this.wallSeconds.reduce((total, seconds) => total + seconds, 0);
    return (sum / this.wallSeconds.length) * episodes;
  }

  curvesOf(kind: CurveKind): GrowingCurve[] {
    return this.curves.filter((curve) => curve.kind === kind);
  }

  private take(
    kind: CurveKind,
    { name, unit, doc, values }: { name: string; unit?: string; doc: string; values: Float32Array },
  ): void {
    const known = this.curves.find((curve) => curve.kind === kind && curve.name === name);
    if (known) known.values = Array.from(values);
    else this.curves.push({ kind, name, unit: unit ?? "", doc, values: Array.from(values) });
  }

  private addTo(
    kind: CurveKind,
    values: Record<string, number | null>,
    layout: Layout | undefined,
  ): void {
    for (const [name, value] of Object.entries(values)) {
      this.curveOf(kind, name, layout).values.push(value ?? NaN);
    }
  }

  private curveOf(kind: CurveKind, name: string, layout: Layout | undefined): GrowingCurve {
    const found = this.curves.find((curve) => curve.kind === kind && curve.name === name);
    if (found) return found;
    const words = layout?.values.find((value) => value.kind === kind && value.name === name);
    const values = new Array<number>(this.episodes.length - 1).fill(NaN);
    const curve = { kind, name, unit: words?.unit ?? "", doc: words?.doc ?? "", values };
    this.curves.push(curve);
    return curve;
  }

  private cutTo(length: number): void {
    this.episodes.length = length;
    this.returns.length = length;
    for (const { values } of this.curves) values.length = length;
  }
}
