// Where the run comes from: the task's source, and everything the run has noted about itself.

import type { Report } from "../data/report_data.ts";
import { commentStart } from "../data/task_source.ts";
import { formatCount } from "../data/words.ts";
import { byId, element } from "./dom.ts";

const kNames: [string, string][] = [
  ["task", "Task"],
  ["task_file", "Task file"],
  ["task_hash", "Hash of the task"],
  ["robot", "Robot"],
  ["profile", "Profile"],
  ["seed", "Seed"],
  ["episodes_planned", "Episodes planned"],
  ["version", "taskc version"],
  ["compiler", "Compiler"],
  ["started_at", "Started"],
  ["finished_at", "Finished"],
  ["state", "State"],
];

/** The source, line by line, with numbers; comments stand back. */
export function showSource(report: Report): void {
  const code = byId("task-source", HTMLElement);
  for (const line of report.taskSource.replace(/\n$/, "").split("\n")) {
    const comment = commentStart(line);
    const row = element("span", { class: "line" }, line.slice(0, comment));
    row.append(element("span", { class: "comment" }, line.slice(comment)), "\n");
    code.append(row);
  }
  byId("task-file", HTMLElement).textContent = report.run["task_file"] ?? "";
}

function row(name: string, value: string): HTMLElement {
  return element("tr", {}, element("th", { scope: "row" }, name), element("td", {}, value));
}

export function showProvenance(report: Report): void {
  const table = byId("provenance", HTMLElement);
  for (const [key, name] of kNames) {
    const value = report.run[key];
    if (value) table.append(row(name, value));
  }
  const known = new Set(kNames.map(([key]) => key));
  for (const [key, value] of Object.entries(report.run)) {
    if (!known.has(key)) table.append(row(key, value));
  }
  table.append(row("Faults", `${formatCount(report.faults)} rewards were not finite and not paid`));
  table.append(row("Page made", report.madeAt));
  byId("agent-text", HTMLElement).textContent = report.agentText;
  const notes = byId("notes", HTMLElement);
  notes.append(...report.notes.map((note) => element("li", {}, note)));
  notes.hidden = report.notes.length === 0;
}
