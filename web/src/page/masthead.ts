// What was learned by whom: the head of the page and its key figures.

import type { Report } from "../data/report_data.ts";
import { indexOfMaximum, lastValues } from "../data/statistics.ts";
import { docOfTask } from "../data/task_source.ts";
import { lastTask } from "../data/versions.ts";
import { agentInWords, endInWords, formatCount, formatDate, formatDuration, formatNumber, formatRatio } from "../data/words.ts";
import { byId, element } from "./dom.ts";
import { figure } from "./figure.ts";

const kMeanOf = 100; // episodes at the end of the run

const kStateWords: Record<string, string> = {
  running: "still running",
  interrupted: "interrupted",
  finished: "finished",
};

function episodesInWords(report: Report): string {
  const done = formatCount(report.episode.length);
  const planned = Number(report.run["episodes_planned"]);
  return planned > report.episode.length ? `${done} of ${formatCount(planned)}` : done;
}

function runFacts(report: Report): [string, string | undefined][] {
  const { run } = report;
  return [
    ["Robot", run["robot"]],
    ["Episodes", episodesInWords(report)],
    ["Seed", run["seed"]],
    ["Profile", run["profile"]],
    ["taskc", run["version"]],
    ["Begun", formatDate(run["started_at"])],
  ];
}

export function showMasthead(report: Report): void {
  const { run } = report;
  byId("task-name", HTMLElement).textContent = (run["task"] ?? "").replaceAll("_", " ");
  byId("task-doc", HTMLElement).textContent = docOfTask(lastTask(report)?.sources[0]?.text ?? "");
  byId("agent-words", HTMLElement).textContent = agentInWords(report.modules);
  const state = byId("run-state", HTMLElement);
  state.textContent = kStateWords[run["state"] ?? ""] ?? run["state"] ?? "";
  state.dataset["state"] = run["state"] ?? "";
  const facts = byId("run-facts", HTMLElement);
  for (const [name, value] of runFacts(report)) {
    if (!value) continue;
    facts.append(element("div", {}, element("dt", {}, name), element("dd", {}, value)));
  }
}

export function showKeyFigures(report: Report): void {
  const best = indexOfMaximum(report.returns);
  const count = Math.min(kMeanOf, report.returns.length);
  const last = lastValues(report.returns, count);
  const ratio = report.simulatedSeconds / report.wallSeconds;
  const host = byId("figures", HTMLElement);
  host.append(
    figure(
      "Best return",
      formatNumber(report.returns[best]),
      best < 0 ? "none yet" : `in episode ${formatCount(report.episode[best] ?? 0)}`,
    ),
    figure(
      `Mean of the last ${formatCount(count)}`,
      formatNumber(last.mean),
      `standard deviation ${formatNumber(last.deviation)}`,
    ),
    figure(
      "Simulated",
      formatDuration(report.simulatedSeconds),
      Number.isFinite(ratio)
        ? `in ${formatDuration(report.wallSeconds)}, ${formatRatio(ratio)} × real time`
        : "",
    ),
    endsFigure(report),
  );
}

/** How the episodes ended, as a bar with its words. */
function endsFigure(report: Report): HTMLElement {
  const total = report.ends.reduce((sum, end) => sum + end.count, 0);
  const bar = element("div", { class: "bar", "aria-hidden": "true" });
  const list = element("ul", { class: "ends" });
  const kinds: string[] = [];
  for (const end of report.ends) {
    // The second and third reason of one kind are paler.
    const shade = String(0.62 ** kinds.filter((kind) => kind === end.kind).length);
    kinds.push(end.kind);
    const part = element("span", { "data-kind": end.kind });
    part.style.flexGrow = String(end.count);
    part.style.opacity = shade;
    bar.append(part);
    const words = endInWords(end);
    const share = `${((100 * end.count) / total).toFixed(end.count === total ? 0 : 1)} %`;
    const swatch = element("span", { class: "swatch", "data-kind": end.kind });
    swatch.style.opacity = shade;
    list.append(
      element(
        "li",
        {},
        swatch,
        element("span", { class: "words" }, words),
        element("span", { class: "share", title: `${formatCount(end.count)} episodes` }, share),
      ),
    );
  }
  return element(
    "div",
    { class: "figure wide" },
    element("dt", {}, "How episodes ended"),
    element("dd", {}, bar, list),
  );
}
