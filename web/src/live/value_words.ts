// What a frame's values are, as text.

import { formatCount, formatNumber, formatTick } from "../data/words.ts";
import type { Frame, ViewValue } from "./view_frames.ts";

export const isFlag = ({ type }: ViewValue): boolean => type.startsWith("bool");
const isWhole = ({ type }: ViewValue): boolean => type.startsWith("int");

/** "true", "0.312", "(0.1, 0, 1)"; of many numbers how many there are. */
export function valueInWords(
  value: ViewValue,
  numbers: Float32Array,
  numberInWords = formatNumber,
): string {
  const format = (number: number): string => {
    if (isFlag(value) && Number.isFinite(number)) return number === 1 ? "true" : "false";
    return isWhole(value) && Number.isFinite(number) ? formatCount(number) : numberInWords(number);
  };
  if (value.size === 1) return format(numbers[0] ?? NaN);
  if (isFlag(value)) {
    const set = numbers.reduce((count, number) => count + (number === 1 ? 1 : 0), 0);
    return `${set} of ${value.size}`;
  }
  if (value.size <= 4) return Array.from(numbers, format).join("  ");
  return `${value.size} numbers`;
}

/** "command 0.3, -0.1 m/s", a line for each goal. */
export function goalsInWords(frame: Frame): string {
  return frame.clip.layout.values
    .filter(({ kind }) => kind === "goal")
    .map((goal) => {
      const numbers = Array.from(frame.valuesOf(goal), (number) =>
        isFlag(goal) ? String(number === 1) : formatTick(number),
      );
      return [goal.name, numbers.join(", "), goal.unit].filter(Boolean).join(" ");
    })
    .join("\n");
}
