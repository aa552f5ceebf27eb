// What became of the run while it learned: its changes, and which task was active when.

import type { Change, Report } from "../data/report_data.ts";
import { formatCount, formatDate } from "../data/words.ts";
import { withDifference } from "./difference.ts";
import { byId, element } from "./dom.ts";
import { row, table } from "./table.ts";

function changeRow(change: Change): HTMLElement {
  const { episode, step, text, at } = change;
  const place = formatCount(episode) + (step > 0 ? `, step ${formatCount(step)}` : "");
  return row([place, element("div", {}, ...withDifference(text, change)), formatDate(at)]);
}

function versionRows(report: Report): HTMLElement[] {
  return report.versions.map(({ task, first, last }) => {
    const { name = "", file = "", hash = "" } = report.tasks[task] ?? {};
    const episodes = `${formatCount(first)} – ${formatCount(last)}`;
    return row([episodes, name, file, element("code", {}, hash.slice(0, 8))]);
  });
}

/** Shows nothing of a run that was left alone. */
export function showHistory(report: Report): void {
  const section = byId("history-section", HTMLElement);
  section.hidden = report.changes.length === 0 && report.versions.length < 2;
  if (section.hidden) return;
  const host = byId("history", HTMLElement);
  if (report.changes.length > 0) {
    const changes = table(["Episode", "Change", "When"], report.changes.map(changeRow));
    changes.classList.add("changes-table");
    host.append(changes);
  }
  if (report.versions.length > 1) {
    const versions = table(["Episodes", "Active task", "File", "Hash"], versionRows(report));
    versions.classList.add("versions-table");
    host.append(versions);
  }
}
