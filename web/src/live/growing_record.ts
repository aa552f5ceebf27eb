// The run's episodes: those that were there when the page was opened, and each that is over since.
// However long the run, so many rows at most: then two neighbors become one, their mean.

import { endInWords } from "../data/words.ts";
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
const kMostRows = 8192;
const kMostChanges = 500;

/** The mean of what there is, and over how many it is. */
function merged(first: number, second: number, of: [number, number] = [1, 1]): number {
  if (!Number.isFinite(first)) return second;
  if (!Number.isFinite(second)) return first;
  return (first * of[0] + second * of[1]) / (of[0] + of[1]);
}

export class GrowingRecord {
  /** Of each row the last episode in it. */
  episodes: number[] = [];
  returns: number[] = [];
  changes: Change[] = [];
  readonly curves: GrowingCurve[] = [];
  lastEnd = "";
  best = { episode: 0, value: -Infinity }; // episode 0: there is none
  episodesPerRow = 1;
  private inLastRow = 1; // episodes
  private readonly wallSeconds: number[] = [];

  /** `mostRows`: an even number. */
  constructor(
    report: Report,
    private readonly mostRows = kMostRows,
  ) {
    this.read(report);
  }

  /** As many rows as `episodes` are in; at least one. */
  rowsOf(episodes: number): number {
    return Math.max(1, Math.round(episodes / this.episodesPerRow));
  }

  /** Forgets the oldest changes where there are very many. */
  addChange(change: Change): void {
    this.changes.push(change);
    if (this.changes.length > kMostChanges) this.changes.shift();
  }

  /** What the trainer has in its record now, in the place of what was known. Curves that are still
   * there stay the same objects. */
  read(report: Report): void {
    this.episodes = Array.from(report.episode);
    this.returns = Array.from(report.returns);
    this.changes = report.changes.slice(-kMostChanges);
    [this.episodesPerRow, this.inLastRow] = [1, 1];
    this.best = { episode: 0, value: -Infinity };
    this.returns.forEach((value, i) =>
      this.noteBest(this.episodes[i] ?? 0, value, report.ends[report.endOf[i] ?? -1]?.kind),
    );
    for (const curve of this.curves) curve.values = this.episodes.map(() => NaN);
    for (const each of report.terms) this.take("term", each);
    for (const each of report.metrics) this.take("metric", each);
    for (const each of report.learner) this.take("learner", each);
    for (const { module, values } of report.shadows) {
      this.take("shadow", { name: module, unit: "", doc: "", values });
    }
    while (this.episodes.length > this.mostRows) this.halve();
  }

  /** What the trainer says of changes that were heard of as they happened; whether that is news. */
  takeDifferences(changes: Change[]): boolean {
    let isNews = false;
    for (const change of this.changes) {
      if (change.difference !== undefined) continue;
      const same = changes.find(({ episode, step, text, difference }) =>
        difference !== undefined && episode === change.episode && step === change.step && text === change.text);
      if (same?.difference === undefined) continue;
      change.difference = same.difference;
      isNews = true;
    }
    return isNews;
  }

  /** Adds an episode; one that comes again, since the trainer went back to a checkpoint, takes the
   * place of what was there from it on. `layout`: what is known of names that are new. */
  add(event: EpisodeEvent, layout: Layout | undefined): void {
    const known = this.episodes.findIndex((episode) => episode >= event.episode);
    if (known >= 0) this.cutTo(known);
    if (this.episodes.length >= this.mostRows && this.isLastRowFull) this.halve();
    this.noteBest(event.episode, event.return, event.end.kind);
    const isNewRow = this.episodes.length === 0 || this.isLastRowFull;
    const of: [number, number] = isNewRow ? [0, 1] : [this.inLastRow, 1];
    this.inLastRow = of[0] + 1;
    if (isNewRow) this.addRow();
    const last = this.episodes.length - 1;
    const put = (values: number[], value: number | null): void => {
      values[last] = merged(values[last] ?? NaN, value ?? NaN, of);
    };
    this.episodes[last] = event.episode;
    put(this.returns, event.return);
    const shadows = Object.entries(event.shadows ?? {}).map(([name, shadow]) => [name, shadow.return]);
    const all: [CurveKind, Record<string, number | null>][] = [
      ["term", event.terms],
      ["metric", event.metrics],
      ["learner", event.learner],
      ["shadow", Object.fromEntries(shadows) as Record<string, number>],
    ];
    for (const [kind, values] of all) {
      for (const [name, value] of Object.entries(values)) {
        put(this.curveOf(kind, name, layout).values, value);
      }
    }
    this.lastEnd = endInWords(event.end);
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

  private get isLastRowFull(): boolean {
    return this.inLastRow >= this.episodesPerRow;
  }

  private addRow(): void {
    this.episodes.push(NaN);
    for (const { values } of [{ values: this.returns }, ...this.curves]) values.push(NaN);
  }

  private halve(): void {
    const pairs = Math.ceil(this.episodes.length / 2);
    const isOdd = this.episodes.length % 2 === 1;
    this.episodes = this.episodes.filter((_, i) => i % 2 === 1 || i === this.episodes.length - 1);
    const means = (values: number[]): number[] =>
      Array.from({ length: pairs }, (_, i) => merged(values[2 * i] ?? NaN, values[2 * i + 1] ?? NaN));
    this.returns = means(this.returns);
    for (const curve of this.curves) curve.values = means(curve.values);
    if (!isOdd) this.inLastRow += this.episodesPerRow;
    this.episodesPerRow *= 2;
  }

  private noteBest(episode: number, value: number, end: string | undefined): void {
    if (end !== "diverged" && value > this.best.value) this.best = { episode, value };
  }

  private curveOf(kind: CurveKind, name: string, layout: Layout | undefined): GrowingCurve {
    const found = this.curves.find((curve) => curve.kind === kind && curve.name === name);
    if (found) return found;
    const words = layout?.values.find((value) => value.kind === kind && value.name === name);
    const values = new Array<number>(this.episodes.length).fill(NaN);
    const curve = { kind, name, unit: words?.unit ?? "", doc: words?.doc ?? "", values };
    this.curves.push(curve);
    return curve;
  }

  private cutTo(length: number): void {
    this.inLastRow = this.episodesPerRow; // what is cut off may have begun in the row before
    this.episodes.length = length;
    this.returns.length = length;
    for (const { values } of this.curves) values.length = length;
  }
}
