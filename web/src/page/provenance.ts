// Where the run comes from: the task's source, and everything the run has noted about itself.

import type { Report, Task } from "../data/report_data.ts";
import { lastTask } from "../data/versions.ts";
import { formatCount } from "../data/words.ts";
import { byId, element } from "./dom.ts";
import { sourceCode } from "./source.ts";

const kNames: [string, string][] = [
  ["task", "Task"],
  ["task_file", "Task file"],
  ["task_hash", "Task hash"],
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

/** All texts of the task that was active last, its own open, then those of the others. */
export function showSources(report: Report): void {
  const last = lastTask(report);
  if (last) showTask(last, "Task ", true);
  const shown = new Set([last?.hash]);
  for (const task of report.tasks) {
    if (!shown.has(task.hash)) showTask(task, `Another task, in ${task.module} `, false);
    shown.add(task.hash);
  }
}

function showTask(task: Task, heading: string, isOpen: boolean): void {
  task.sources.forEach((source, i) => {
    const file = element("span", { class: "note" }, source.file);
    const details = element(
      "details",
      isOpen && i === 0 ? { open: "" } : {},
      element("summary", {}, i === 0 ? heading : "Uses ", file),
      element("pre", { class: "source", tabindex: "0" }, sourceCode(source.text)),
    );
    byId("sources", HTMLElement).append(details);
  });
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
  table.append(row("Faults", `${formatCount(report.faults)} rewards or learning steps were not finite or too large, and were skipped`));
  if (report.violations > 0) {
    table.append(
      row("Violations", `a requirement of the task did not hold ${formatCount(report.violations)} times`),
    );
  }
  table.append(row("Page generated", report.madeAt));
  byId("agent-text", HTMLElement).textContent = report.agentText;
  const notes = byId("notes", HTMLElement);
  notes.append(...report.notes.map((note) => element("li", {}, note)));
  notes.hidden = report.notes.length === 0;
}
