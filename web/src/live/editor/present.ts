// What the names in the text of a task stand for at one moment of the run.

import { formatThousandths, formatNumber, formatTick } from "../../data/words.ts";
import type { Entry } from "../history.ts";
import type { Parameter } from "../parameters.ts";
import { isFlag, valueInWords } from "../value_words.ts";
import type { Layout, ViewValue } from "../view_frames.ts";

/** A number, or a few of them, that the run tells at each moment. */
export interface Present {
  unit: string;
  width: number; // of the longest words that it may have [characters]
  at: (entry: Entry) => string;
}

/** The moment's task and its parameters. */
export interface PresentTask {
  layout: Layout;
  params: Parameter[];
}

const kNumberWidth = 8;
const kBetween = "  "; // two numbers
const kMostNumbers = 4;
/** What a task reads, by the same names as its text. */
export const kRead: ViewValue["kind"][] = ["goal", "memory", "sensor"];

/** What the reward term pays now. */
export function rateOf(term: string, { layout }: PresentTask): Present | undefined {
  const value = termIn(layout, term);
  if (!value) return undefined;
  return { unit: "per s", width: kNumberWidth, at: ({ rates }) => formatNumber(rates.get(value)) };
}

/** What it has paid in the episode. */
export function sumOf(term: string, { layout }: PresentTask): Present | undefined {
  const value = termIn(layout, term);
  if (!value) return undefined;
  return { unit: "", width: kNumberWidth, at: ({ frame }) => formatNumber(frame.number(value.first)) };
}

const termIn = ({ values }: Layout, term: string): ViewValue | undefined =>
  values.find(({ kind, name }) => kind === "term" && name === term);

/** `name`: as it is written, such as "base.velocity.x"; of what the run does not tell, nothing. */
export function presentOf(name: string, task: PresentTask): Present | undefined {
  if (name === "time") {
    return { unit: "s", width: kNumberWidth, at: ({ frame }) => frame.time.toFixed(2) };
  }
  return paramOf(name, task) ?? elementOf(name, task) ?? someOf(name, task) ?? wholeOf(name, task);
}

function paramOf(name: string, { params }: PresentTask): Present | undefined {
  const param = params.find((each) => each.name === name);
  if (!param || Array.isArray(param.value)) return undefined;
  const { value, unit } = param;
  const words = typeof value === "number" ? formatTick(value) : String(value);
  return { unit, width: words.length, at: () => words };
}

/** One of the numbers of a value. */
function elementOf(name: string, { layout }: PresentTask): Present | undefined {
  for (const value of layout.values) {
    const index = value.elements?.indexOf(name) ?? -1;
    if (index < 0 || !kRead.includes(value.kind)) continue;
    const element = { ...value, first: value.first + index, size: 1 };
    return presentOfValue(element);
  }
  return undefined;
}

/** "base.velocity.xy" */
function someOf(name: string, task: PresentTask): Present | undefined {
  const [, base = "", letters = ""] = /^(.+)\.([xyzw]{2,4})$/.exec(name) ?? [];
  const parts = [...letters].flatMap((letter) => elementOf(`${base}.${letter}`, task) ?? []);
  const [first] = parts;
  if (!first || parts.length < letters.length) return undefined;
  const width = parts.length * (kNumberWidth + kBetween.length) - kBetween.length;
  return { unit: first.unit, width, at: (entry) => parts.map(({ at }) => at(entry)).join(kBetween) };
}

/** All of a value, also where only a part is read that cannot be told which it is. */
function wholeOf(name: string, { layout }: PresentTask): Present | undefined {
  const value = layout.values
    .filter(({ kind, name: own }) => kRead.includes(kind) && leadsTo(own, name))
    .sort((a, b) => b.name.length - a.name.length)[0];
  return value && isReadable(value) ? presentOfValue(value) : undefined;
}

/** At a glance; of flags it is said how many are set. */
export const isReadable = (value: ViewValue): boolean => isFlag(value) || value.size <= kMostNumbers;

const leadsTo = (value: string, name: string): boolean =>
  name === value || (name.startsWith(value) && /[.[]/.test(name[value.length] ?? ""));

/** What is nearly nothing is noise: its digits would only flicker. */
const sensed = (number: number | undefined): string =>
  Math.abs(number ?? NaN) < 1e-3 ? formatThousandths(number ?? 0) : formatNumber(number);

export function presentOfValue(value: ViewValue): Present {
  const numbers = isFlag(value) ? 1 : value.size;
  return {
    unit: value.unit,
    width: numbers * (kNumberWidth + kBetween.length) - kBetween.length,
    at: ({ frame }) => valueInWords(value, frame.valuesOf(value), value.kind === "sensor" ? sensed : formatNumber),
  };
}
