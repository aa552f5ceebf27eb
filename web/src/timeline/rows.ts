// The rows of a timeline: each a name, what it is now, and its trace.

import type { BodyLink } from "../data/report_data.ts";
import { endOf, touches, type MetricTrace, type TermTrace, type Timeline } from "../data/timeline.ts";
import { formatNumber, formatTick, withUnit } from "../data/words.ts";
import { element } from "../page/dom.ts";
import { sideOf } from "../replay/side.ts";
import {
  axis,
  bars,
  extremesOf,
  line,
  stretches,
  TraceCanvas,
  type TraceData,
} from "./trace.ts";

const kReturnHeight = 64; // [px]
const kRowHeight = 34;
const kBandHeight = 20;
const kThinHeight = 13;
const kColors = 8; // --series-1 … --series-8

export const termColor = (index: number): string => `--series-${(index % kColors) + 1}`;

export interface Row {
  kind: "return" | "term" | "metric" | "joint" | "phase" | "contact" | "axis";
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
function rangeLabel(data: TraceData, withZero: boolean): HTMLElement {
  const { low, high } = extremesOf(data, withZero);
  const label = element("div", { class: "range" }, element("span", {}, formatTick(high)));
  if (low < high) label.append(element("span", {}, formatTick(low)));
  return label;
}

/** The time axis, and another episode on a time axis like this, whose traces are as high. */
interface Axis {
  times: Float64Array; // [sample] [s]
  duration: number; // [s]
  beside: Timeline | undefined;
}

function returnRow({ total }: Timeline, { times, duration, beside }: Axis): Row {
  const { label, outputs } = labelOf("return", "All that was paid, added up", "--accent", 2);
  const data = { times, values: total.sum, duration, beside: beside?.total.sum };
  return {
    kind: "return",
    label,
    trace: new TraceCanvas(kReturnHeight, line(data, "--accent", true)),
    range: rangeLabel(data, true),
    show: (sample) => showPayments(outputs, total.paid[sample], total.sum[sample]),
  };
}

function showPayments(outputs: HTMLElement[], paid = 0, sum = 0): void {
  const [now, whole] = outputs as [HTMLElement, HTMLElement];
  now.textContent = formatPaid(paid);
  now.dataset["sign"] = String(Math.sign(paid));
  whole.textContent = formatNumber(sum);
}

function termRow(term: TermTrace, index: number, { times, duration, beside }: Axis): Row {
  const { label, outputs } = labelOf(term.name, term.doc, termColor(index), 2);
  const other = beside?.terms.find(({ name }) => name === term.name);
  const data = { times, values: term.paid, duration, beside: other?.paid };
  return {
    kind: "term",
    label,
    trace: new TraceCanvas(kRowHeight, bars(data, termColor(index))),
    range: rangeLabel(data, true),
    show: (sample) => showPayments(outputs, term.paid[sample], term.sum[sample]),
  };
}

/** Of a value that is none of the payments. */
function valueRow(
  kind: "metric" | "joint",
  { name, unit, doc, values }: Pick<MetricTrace, "name" | "unit" | "doc" | "values">,
  { times, duration }: Axis,
  beside: Float64Array | undefined,
): Row {
  const { label, outputs } = labelOf(withUnit({ name, unit }), doc, undefined, 1);
  const data = { times, values, duration, beside };
  return {
    kind,
    label,
    trace: new TraceCanvas(kRowHeight, line(data, "--ink-soft", false)),
    range: rangeLabel(data, false),
    show: (sample) => ((outputs[0] as HTMLElement).textContent = formatNumber(values[sample])),
  };
}

function metricRow(metric: MetricTrace, axis: Axis): Row {
  const isAlike = ({ name, unit }: MetricTrace): boolean =>
    name === metric.name && unit === metric.unit;
  return valueRow("metric", metric, axis, axis.beside?.metrics.find(isAlike)?.values);
}

function phaseRow(
  { names, values }: NonNullable<Timeline["phases"]>,
  { times, duration }: Axis,
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
function contactRows(timeline: Timeline, body: BodyLink[], { times, duration }: Axis): Row[] {
  return body.flatMap(({ name }, link): Row[] => {
    const values = Float64Array.from(times, (_, sample) =>
      touches(timeline, body.length, sample, link) ? 0 : -1,
    );
    if (values.every((value) => value < 0)) return [];
    const words = name.replaceAll("_", " ");
    const { label } = labelOf(words, "", kSideColors[sideOf(name)], 0);
    const draw = stretches(
      { times, values, duration },
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

/** The rows of an episode, as long and as high as those of another where that stands beside it. */
export function rowsOf(
  timeline: Timeline,
  body: BodyLink[],
  joints: { name: string; values: Float64Array }[] = [],
  beside?: Timeline,
): Row[] {
  const { times, terms, metrics, phases } = timeline;
  const duration = Math.max(endOf(timeline), beside ? endOf(beside) : 0);
  const common: Axis = { times, duration, beside };
  const seconds = (time: number): string => `${formatTick(time)} s`;
  return [
    returnRow(timeline, common),
    ...terms.map((term, i) => termRow(term, i, common)),
    ...metrics.map((metric) => metricRow(metric, common)),
    ...joints.map((joint) =>
      valueRow("joint", { ...joint, unit: "rad", doc: "" }, common, undefined),
    ),
    ...(phases ? [phaseRow(phases, common)] : []),
    ...contactRows(timeline, body, common),
    {
      kind: "axis",
      label: element("div", { class: "label" }),
      trace: new TraceCanvas(20, axis(duration, seconds)),
      show: () => {},
    },
  ];
}
