// What happened to the run, the last of it first.

import { changeWords } from "../charts/change_marks.ts";
import type { Change } from "../data/report_data.ts";
import { withDifference } from "../page/difference.ts";
import { byId, element } from "../page/dom.ts";

const kMost = 100;

export function showChanges(changes: Change[]): void {
  const items = changes
    .slice(-kMost)
    .reverse()
    .map((change) => element("li", {}, ...withDifference(changeWords(change), change)));
  const nothing = element("li", { class: "note" }, "Nothing was changed yet.");
  byId("changes", HTMLElement).replaceChildren(...(items.length > 0 ? items : [nothing]));
}
