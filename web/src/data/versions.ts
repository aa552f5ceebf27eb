// Which task was active when: a task that takes the place of another starts a new version.

import type { Report, Task } from "./report_data.ts";

type Versions = Pick<Report, "episode" | "versions">;

/** The task that was active last. */
export function lastTask(report: Pick<Report, "tasks" | "versions">): Task | undefined {
  return report.tasks[report.versions.at(-1)?.task ?? -1];
}

/** The indices of the episodes with which versions start, but for the first one. */
export const versionStarts = ({ episode, versions }: Versions): number[] =>
  versions.slice(1).map(({ first }) => episode.indexOf(first));

/** `values`, but not a number in the episodes of other tasks than `tasks` (indices). */
export function onlyUnder(report: Versions, tasks: number[], values: Float32Array): Float32Array {
  const kept = new Float32Array(values.length).fill(NaN);
  for (const { task, first, last } of report.versions) {
    if (!tasks.includes(task)) continue;
    const begin = report.episode.indexOf(first);
    const end = report.episode.indexOf(last) + 1;
    kept.set(values.subarray(begin, end), begin);
  }
  return kept;
}
