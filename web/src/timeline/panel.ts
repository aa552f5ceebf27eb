// The timeline of a recorded episode under its replay: what it paid, measured and touched, with a
// cursor at the time of the replay. A click leads there.

import type { Recording, Report } from "../data/report_data.ts";
import { endOf, sampleAt, type Timeline } from "../data/timeline.ts";
import { endInWords, formatNumber, formatTime } from "../data/words.ts";
import { element, onThemeChange } from "../page/dom.ts";
import { angleTrace, jointsOf } from "../replay/joints.ts";
import { LitSource } from "./lit_source.ts";
import { headOf, rowsOf, type Row } from "./rows.ts";

interface Parts {
  section: HTMLElement; // hidden where there is no timeline
  rows: HTMLElement;
  now: HTMLElement; // the time and what it is about, in words
  source?: HTMLElement; // for the task's text, if that is to be shown
}

const kHeadings: Partial<Record<Row["kind"], string>> = {
  term: "reward",
  metric: "metrics",
  joint: "joint angles",
  contact: "contacts",
};

export class TimelinePanel {
  private readonly source: LitSource | undefined;
  private readonly overlay = element("div", { class: "plot" });
  private readonly cursor = element("div", { class: "cursor" });
  private readonly pointer = element("div", { class: "pointer", hidden: "" });
  private readonly ahead = element("div", { class: "ahead" });
  private rows: Row[] = [];
  private recording: Recording | undefined;
  private beside: Timeline | undefined;
  private picked: number | undefined; // link
  private time = 0;

  /** `seek` is called with the time that is chosen. */
  constructor(
    private readonly report: Pick<Report, "tasks" | "body">,
    private readonly parts: Parts,
    private readonly seek: (time: number) => void,
  ) {
    this.source = parts.source && new LitSource(parts.source);
    this.overlay.append(this.ahead, this.pointer, this.cursor);
    this.connectPointer();
    new ResizeObserver(() => this.redraw()).observe(parts.rows);
    onThemeChange(() => this.redraw());
  }

  /** `beside`: of an episode that is shown in step with this one. */
  show(recording: Recording, beside?: Timeline): void {
    const isNew = recording !== this.recording;
    const { timeline } = recording;
    [this.recording, this.beside] = [recording, beside];
    this.parts.section.hidden = timeline === undefined;
    if (!timeline) return;
    this.makeRows();
    if (isNew) this.source?.show(this.report.tasks[recording.task], timeline);
    this.setTime(isNew ? 0 : this.time);
  }

  hide(): void {
    this.recording = undefined;
    this.parts.section.hidden = true;
  }

  /** Shows the angles of the joints of this link. */
  pick(link: number | undefined): void {
    this.picked = link;
    if (!this.recording?.timeline) return;
    this.makeRows();
    this.setTime(this.time);
  }

  private makeRows(): void {
    const { recording, picked } = this;
    const { body } = this.report;
    const { timeline } = recording ?? {};
    if (!recording || !timeline) return;
    const joints = picked === undefined ? [] : jointsOf(body, picked);
    const angles = joints.map((joint) => ({
      name: joint.name,
      values: angleTrace(joint, recording, timeline.times),
    }));
    this.rows = rowsOf(timeline, body, angles, this.beside);
    this.parts.rows.replaceChildren(...this.cells(headOf(timeline)), this.overlay);
    this.redraw();
  }

  setTime(time: number): void {
    this.time = time;
    const timeline = this.recording?.timeline;
    if (!timeline) return;
    const sample = sampleAt(timeline, time);
    for (const row of this.rows) row.show(sample);
    this.source?.setSample(timeline, sample);
    const part = `${(100 * time) / Math.max(this.duration, 1e-9)}%`;
    this.cursor.style.left = part;
    this.ahead.style.left = part;
    this.parts.now.textContent = this.words(timeline, sample);
  }

  /** Of the time axis [s]. */
  private get duration(): number {
    const ends = [this.recording?.timeline, this.beside].map((each) => (each ? endOf(each) : 0));
    return Math.max(...ends);
  }

  private words(timeline: Timeline, sample: number): string {
    const { kind = "", reason = "" } = this.recording?.end ?? {};
    const words = [
      `${formatTime(this.time, this.duration)} s`,
      `return ${formatNumber(timeline.total.sum[sample])}`,
    ];
    if (sample === timeline.times.length - 1) words.push(endInWords({ kind, reason }));
    return words.join("  ·  ");
  }

  private cells(head: HTMLElement): HTMLElement[] {
    let kind = "";
    const cells = [head];
    let line = 2; // of the grid; the head is the first
    const place = (cell: HTMLElement): HTMLElement => {
      cell.style.setProperty("--row", String(line));
      return cell;
    };
    for (const row of this.rows) {
      const heading = kHeadings[row.kind];
      if (row.kind !== kind && heading) {
        cells.push(place(element("div", { class: "heading" }, heading)));
        ++line;
      }
      kind = row.kind;
      row.label.dataset["kind"] = row.kind;
      cells.push(place(row.label), place(row.trace.element));
      if (row.range) cells.push(place(row.range));
      ++line;
    }
    this.overlay.style.setProperty("--row", String(line));
    return cells;
  }

  private redraw(): void {
    const width = this.overlay.clientWidth;
    for (const row of this.rows) row.trace.redraw(width);
  }

  private connectPointer(): void {
    const timeAt = (event: PointerEvent): number => {
      const { left, width } = this.overlay.getBoundingClientRect();
      const part = Math.min(Math.max((event.clientX - left) / width, 0), 1);
      return part * this.duration;
    };
    this.overlay.addEventListener("pointerdown", (event) => {
      this.overlay.setPointerCapture(event.pointerId);
      this.seek(timeAt(event));
    });
    this.overlay.addEventListener("pointermove", (event) => {
      if (this.overlay.hasPointerCapture(event.pointerId)) this.seek(timeAt(event));
      this.pointer.hidden = event.pointerType === "touch";
      this.pointer.style.left = `${event.offsetX}px`;
    });
    this.overlay.addEventListener("pointerleave", () => (this.pointer.hidden = true));
  }
}
