// What a change of a run made of its task.

import type { Change } from "../data/report_data.ts";
import { element } from "./dom.ts";

/** `words` and, where another task came, what differs in it. */
export function withDifference(words: string, { difference }: Change): Node[] {
  const nodes: Node[] = [document.createTextNode(words)];
  if (difference) nodes.push(element("pre", { class: "difference" }, difference.trimEnd()));
  return nodes;
}
