// What the lets of the text that is edited are worth at the moment that is shown: the language server
// works it out from the numbers of the run.

import { formatNumber } from "../../data/words.ts";
import type { Entry } from "../history.ts";
import { valueInWords } from "../value_words.ts";
import type { ViewValue } from "../view_frames.ts";
import { isReadable, kRead, presentOfValue, type Present, type PresentTask } from "./present.ts";

/** By the names of sensors, params, memory and goals: their elements. */
export type KnownNumbers = Record<string, number[]>;

/** Of the result of the request `task/lets` (docs/editors.md). */
export interface LetWorth {
  name: string;
  type: string;
  unit: string;
  numbers: number[];
}

const kEvery = 200; // [ms]

const valueOf = ({ name, type, unit, numbers }: LetWorth): ViewValue => ({
  kind: "memory",
  name,
  type,
  unit,
  doc: "",
  size: numbers.length,
  first: 0,
});

export function knownAt({ frame }: Entry, { layout, params }: PresentTask): KnownNumbers {
  const known: KnownNumbers = { time: [frame.time] };
  for (const value of layout.values) {
    const numbers = [...frame.valuesOf(value)];
    if (kRead.includes(value.kind) && numbers.every(Number.isFinite)) known[value.name] = numbers;
  }
  for (const { name, value } of params) {
    if (!Array.isArray(value) && typeof value !== "string") known[name] = [Number(value)];
  }
  return known;
}

export class Lets {
  private worth = new Map<string, LetWorth>();
  private lastAsked = -Infinity;
  private isAsked = false;

  /** `onNames`: others are known than before. */
  constructor(
    private readonly ask: (known: KnownNumbers) => Promise<LetWorth[] | null>,
    private readonly onNames: () => void,
  ) {}

  /** To be called for each moment that is shown; asks no more often than is worth reading. */
  async update(entry: Entry, task: PresentTask): Promise<void> {
    if (this.isAsked || performance.now() < this.lastAsked + kEvery) return;
    this.isAsked = true;
    this.lastAsked = performance.now();
    const found = await this.ask(knownAt(entry, task)).catch(() => null);
    this.isAsked = false;
    if (found) this.take(found);
  }

  presentOf(name: string): Present | undefined {
    const worth = this.worth.get(name);
    const value = worth && valueOf(worth);
    return value && isReadable(value) ? { ...presentOfValue(value), at: () => this.wordsOf(name) } : undefined;
  }

  private wordsOf(name: string): string {
    const worth = this.worth.get(name);
    return worth ? valueInWords(valueOf(worth), Float32Array.from(worth.numbers), formatNumber) : "–";
  }

  private take(found: LetWorth[]): void {
    const before = this.worth;
    this.worth = new Map(found.map((worth) => [worth.name, worth]));
    const isNew = ({ name, type, unit }: LetWorth): boolean =>
      before.get(name)?.type !== type || before.get(name)?.unit !== unit;
    if (found.length !== before.size || found.some(isNew)) this.onNames();
  }
}
