// Builds the page of a study from the data that it carries.

import "uplot/dist/uPlot.min.css";
import "../style/theme.css";
import "../style/page.css";
import "../style/charts.css";
import "../style/replay.css";
import "../style/study.css";

import { interval, mean } from "../data/estimate.ts";
import { formatCount, formatDate, formatDuration } from "../data/words.ts";
import { byId, element } from "../page/dom.ts";
import { settingWords } from "../page/settings.ts";
import { row, table } from "../page/table.ts";
import type { Other } from "../replay/companion.ts";
import { showComparison } from "./comparison.ts";
import { decodeStudy, type Experiment, type Study } from "./data.ts";
import { idOf, showExperiment } from "./experiment.ts";
import { titleOf } from "./groups.ts";
import { ReplayDialog } from "./replay_dialog.ts";
import { count } from "./words.ts";

function showMasthead({ folder, experiments, madeAt }: Study): void {
  byId("study-name", HTMLElement).textContent = folder;
  const runs = experiments.flatMap((experiment) => experiment.runs);
  const finished = runs.filter((run) => run.state === "finished").length;
  const minutes = runs.reduce((sum, run) => sum + run.cpu_minutes, 0);
  const episodes = runs.reduce((sum, run) => sum + run.episodes, 0);
  const facts = [
    ["Experiments", formatCount(experiments.length)],
    ["Runs", formatCount(runs.length)],
    ["Finished", formatCount(finished)],
    ["Episodes", formatCount(episodes)],
    ["CPU time", formatDuration(60 * minutes)],
    ["Page generated", formatDate(madeAt)],
  ] as const;
  for (const [name, value] of facts) {
    byId("study-facts", HTMLElement).append(
      element("div", {}, element("dt", {}, name), element("dd", {}, value)),
    );
  }
}

function overviewRow(experiment: Experiment, index: number): HTMLTableRowElement {
  const { runs, final_return, episodes_to_80_percent, cpu_minutes_to_80_percent } = experiment;
  const finished = runs.filter((run) => run.state === "finished").length;
  return row([
    element(
      "span",
      {},
      element("a", { href: `#${idOf(index)}` }, experiment.name),
      ...settingWords(experiment),
    ),
    `${formatCount(finished)} of ${formatCount(runs.length)}`,
    (experiment.is_settled || final_return.count === 0 ? "" : "so far ") + mean(final_return),
    interval(final_return),
    mean(experiment.best_return),
    mean(episodes_to_80_percent, count),
    mean(cpu_minutes_to_80_percent),
    formatCount(experiment.groups.length),
  ]);
}

function showOverview({ experiments }: Study): void {
  const heads = [
    ...["Experiment", "Runs finished", "Final return", "95 %", "Best", "Episodes to 80 %"],
    ...["CPU min to 80 %", "Groups"],
  ];
  const overview = table(heads, experiments.map(overviewRow));
  overview.classList.add("overview");
  byId("overview", HTMLElement).append(overview);
}

function showNotes(notes: string[]): void {
  const list = byId("notes", HTMLElement);
  list.append(...notes.map((note) => element("li", {}, note)));
  list.hidden = notes.length === 0;
}

/** What can be replayed. */
const recordedIn = ({ experiments }: Study): Other[] =>
  experiments.flatMap((experiment) =>
    experiment.groups.flatMap((group) => {
      const { recording: replay } = group;
      return replay ? [{ title: titleOf(experiment, group), replay, scenery: experiment }] : [];
    }),
  );

function main(): void {
  const study = decodeStudy(byId("report-data", HTMLElement).textContent ?? "");
  showMasthead(study);
  showOverview(study);
  showComparison(study.experiments, byId("comparison", HTMLElement));
  showNotes(study.notes);
  const dialog = new ReplayDialog(recordedIn(study));
  study.experiments.forEach((experiment, i) => {
    byId("experiments", HTMLElement).append(
      showExperiment(experiment, i, study.path, (group, title) => {
        if (group.recording) dialog.show(group.recording, experiment, title);
      }),
    );
  });
  requestAnimationFrame(() => (document.documentElement.dataset["ready"] = "true"));
}

main();
