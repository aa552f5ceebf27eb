// What remains of a learned return where a policy acts without learning.

import { element } from "./dom.ts";

export const wholePercent = (share: number | null): string =>
  share === null ? "–" : `${Math.round(100 * share)} %`;

export function remainsBar(share: number | null): HTMLElement {
  const part = element("span");
  part.style.width = `${100 * Math.min(Math.max(share ?? 0, 0), 1)}%`;
  return element("span", { class: "remains-bar", "aria-hidden": "true" }, part);
}
