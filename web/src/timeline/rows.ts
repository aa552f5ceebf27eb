// The rows of a timeline: each a name, what it is now, and its trace.

import type { BodyLink } from "../data/report_data.ts";
import { endOf, touches, type MetricTrace, type TermTrace, type Timeline } from "../data/timeline.ts";
import { formatNumber, formatTick } from "../data/words.ts";
import { element } from "../page/dom.ts";
import { sideOf } from "../replay/side.ts";
import { axis, bars, extremesOf, line, stretches, TraceCanvas } from "./trace.ts";

const kReturnHeight = 64; // [px]
const kRowHeight = 34;
const kBandHeight = 20;
const kThinHeight = 13;
const kColors = 8; // --series-1 … --series-8

export const termColor = (index: number): string => `--series-${(index % kColors) + 1}`;

export interface Row {
  kind: "return" | "term" | "metric" | "phase" | "contact" | "axis";
  label: HTMLElement;
  trace: TraceCanvas;
  range?: HTMLElement; // the greatest and the least value, at the end of the trace
  /** Shows the values of this sample. */
  show: (sample: number) => void;
}

/** "+0.25", so that what is paid and what is taken stand apart. */
export const formatPaid = (value: number): string =>
  (value > 0 ? "+" : "") + (value === 0 ? "0" : formatNumber(value));

/** What stands above the numbers of what is paid: in how long, and since the start. */
export function headOf({ interval }: Timeline): HTMLElement {
  const span = `${formatTick(Math.round(1e4 * interval) / 10)} ms`;
  return element(
    "div",
    { class: "label head" },
    element("span", { class: "now", title: "what was paid since the value before" }, `in ${span}`),
    element("span", { class: "sum", title: "since the start of the episode" }, "so far"),
  );
}

/** A name with one or two numbers behind it. */
function labelOf(name: string, doc: string, color: string | undefined, numbers: number) {
  const swatch = element("span", { class: "swatch", "aria-hidden": "true" });
  if (color) swatch.style.background = `var(${color})`;
  const outputs = Array.from({ length: numbers }, (_, i) =>
    element("span", { class: i === 0 ? "now" : "sum" }),
  );
  const title = element("span", { class: "name", ...(doc && { title: doc }) }, name);
  const label = element("div", { class: "label" }, swatch, title, ...outputs);
  return { label, outputs };
}

/** The greatest and the least value, and 0 where the trace stands on it. */
function rangeLabel(values: Float64Array, withZero: boolean): HTMLElement {
  const { low, high } = extremesOf(values, withZero);
  const label = element("div", { class: "range" }, element("span", {}, formatTick(high)));
  if (low < high) label.append(element("span", {}, formatTick(low)));
  return label;
}

function returnRow({ total, times }: Timeline, duration: number): Row {
  const { label, outputs } = labelOf("return", "All that was paid, added up", "--accent", 2);
  const draw = line({ times, values: total.sum, duration }, "--accent", true);
  return {
    kind: "return",
    label,
    trace: new TraceCanvas(kReturnHeight, draw),
    range: rangeLabel(total.sum, true),
    show: (sample) => showPayments(outputs, total.paid[sample], total.sum[sample]),
  };
}

function showPayments(outputs: HTMLElement[], paid = 0, sum = 0): void {
  const [now, whole] = outputs as [HTMLElement, HTMLElement];
  now.textContent = formatPaid(paid);
  now.dataset["sign"] = String(Math.sign(paid));
  whole.textContent = formatNumber(sum);
}

function termRow(term: TermTrace, index: number, times: Float64Array, duration: number): Row {
  const { label, outputs } = labelOf(term.name, term.doc, termColor(index), 2);
  const draw = bars({ times, values: term.paid, duration }, termColor(index));
  return {
    kind: "term",
    label,
    trace: new TraceCanvas(kRowHeight, draw),
    range: rangeLabel(term.paid, true),
    show: (sample) => showPayments(outputs, term.paid[sample], term.sum[sample]),
  };
}

function metricRow(metric: MetricTrace, times: Float64Array, duration: number): Row {
  const { name, unit, doc, values } = metric;
  const { label, outputs } = labelOf(unit ? `${name} [${unit}]` : name, doc, undefined, 1);
  const draw = line({ times, values, duration }, "--ink-soft", false);
  return {
    kind: "metric",
    label,
    trace: new TraceCanvas(kRowHeight, draw),
    range: rangeLabel(values, false),
    show: (sample) => ((outputs[0] as HTMLElement).textContent = formatNumber(values[sample])),
  };
}

function phaseRow(
  { names, values }: NonNullable<Timeline["phases"]>,
  times: Float64Array,
  duration: number,
): Row {
  const { label, outputs } = labelOf("phase", "", undefined, 1);
  const nameOf = (value: number): string => names[value] ?? "";
  const draw = stretches({ times, values, duration }, termColor, nameOf);
  return {
    kind: "phase",
    label,
    trace: new TraceCanvas(kBandHeight, draw),
    show: (sample) =>
      ((outputs[0] as HTMLElement).textContent = nameOf(values[sample] ?? -1)),
  };
}

const kSideColors = { left: "--left", right: "--right", trunk: "--ink-soft" };

/** Rows of those links that touch something at some time. */
function contactRows(timeline: Timeline, body: BodyLink[], duration: number): Row[] {
  return body.flatMap(({ name }, link): Row[] => {
    const values = Float64Array.from(timeline.times, (_, sample) =>
      touches(timeline, body.length, sample, link) ? 0 : -1,
    );
    if (values.every((value) => value < 0)) return [];
    const words = name.replaceAll("_", " ");
    const { label } = labelOf(words, "", kSideColors[sideOf(name)], 0);
    const draw = stretches(
      { times: timeline.times, values, duration },
      () => kSideColors[sideOf(name)],
      () => "",
    );
    return [
      {
        kind: "contact",
        label,
        trace: new TraceCanvas(kThinHeight, draw),
        show: (sample) => label.classList.toggle("on", values[sample] === 0),
      },
    ];
  });
}

export function rowsOf(timeline: Timeline, body: BodyLink[]): Row[] {
  const { times, terms, metrics, phases } = timeline;
  const duration = endOf(timeline);
  const seconds = (time: number): string => `${formatTick(time)} s`;
  return [
    returnRow(timeline, duration),
    ...terms.map((term, i) => termRow(term, i, times, duration)),
    ...metrics.map((metric) => metricRow(metric, times, duration)),
    ...(phases ? [phaseRow(phases, times, duration)] : []),
    ...contactRows(timeline, body, duration),
    {
      kind: "axis",
      label: element("div", { class: "label" }),
      trace: new TraceCanvas(20, axis(duration, seconds)),
      show: () => {},
    },
  ];
}
