// Pictures of a replay, side by side.

import { formatTime } from "../data/words.ts";
import { element } from "./dom.ts";

export interface Strip {
  times: number[]; // [s]
  png: string; // base64
}

/** The pictures side by side, each above its time. */
export function snapshots({ times, png }: Strip): HTMLElement {
  const last = times.at(-1) ?? 0;
  const captions = times.map((time) => element("li", {}, `${formatTime(time, last).trim()} s`));
  return element(
    "figure",
    { class: "snapshots", tabindex: "0" },
    element("img", {
      src: `data:image/png;base64,${png}`,
      alt: `${times.length} snapshots from 0 to ${last.toFixed(2)} s`,
    }),
    element("ol", {}, ...captions),
  );
}
