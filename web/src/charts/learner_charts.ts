// One small chart for each number that the learner shows of itself, such as its learning rate.

import type { LearnerCurve, Report } from "../data/report_data.ts";
import { formatCount, formatNumber } from "../data/words.ts";
import { onThemeChange } from "../page/dom.ts";
import { EpisodeChart } from "./episode_chart.ts";
import { addValueCard } from "./value_card.ts";

function addChart(episode: Float32Array, curve: LearnerCurve, host: HTMLElement): void {
  const card = addValueCard(host, curve, curve.doc, () => chart);
  const showValue = (index: number | null): void => {
    const at = index ?? episode.length - 1;
    const value = formatNumber(curve.values[at]);
    card.value.textContent = `episode ${formatCount(episode[at] ?? 0)}: ${value}`;
  };
  const chart: EpisodeChart = new EpisodeChart(card.chart, {
    episode,
    series: [{ name: curve.name, values: curve.values, color: "--accent", kind: "line", hasGaps: true }],
    height: 190,
    label: `${curve.name} in each episode.`,
    onHover: showValue,
  });
  onThemeChange(() => chart.redraw());
  showValue(null);
}

export function showLearner(report: Report, host: HTMLElement): void {
  for (const curve of report.learner) addChart(report.episode, curve, host);
}
