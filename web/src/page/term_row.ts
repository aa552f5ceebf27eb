// A reward term, and its share of all that was paid and taken.

import { formatNumber } from "../data/words.ts";
import { element } from "./dom.ts";
import { row } from "./table.ts";

function percentOf(share: number | null): string {
  if (share === null) return "–";
  const isNothing = share !== 0 && Math.abs(share) < 5e-5;
  return isNothing ? "< 0.01 %" : `${formatNumber(100 * share)} %`;
}

/** What a term paid, with a bar for its share: to the right paid, to the left taken. */
export function termRow(
  { name, doc, share }: { name: string; doc: string; share: number | null },
  paid: string,
): HTMLTableRowElement {
  const bar = element("span", { class: "share-bar" });
  const part = element("span", { class: (share ?? 0) < 0 ? "taken" : "paid" });
  part.style.width = `${50 * Math.abs(share ?? 0)}%`;
  bar.append(part);
  const title = element("span", doc ? { title: doc } : {}, name);
  return row([title, bar, percentOf(share), paid]);
}
