// What is checked of the charts of a report, and of what is saved of them.

import assert from "node:assert/strict";

import type { Page } from "playwright-core";

import { savedBy, type Check } from "./in_browser.ts";

const rowsOf = (csv: string): string[][] => csv.trimEnd().split("\n").map((row) => row.split(","));

/** As many rows as episodes, under the names of what is drawn. */
async function savesNumbers(page: Page, host: string, file: string, names: string[]): Promise<void> {
  const { name, text } = await savedBy(page, host, "CSV");
  assert.equal(name, `${file}.csv`);
  const [head, ...rows] = rowsOf(text);
  assert.deepEqual(head, ["episode", ...names]);
  const { length } = await page.evaluate(() => {
    const { episode } = JSON.parse(document.querySelector("#report-data")?.textContent ?? "") as { episode: string };
    return new Float32Array(Uint8Array.from(atob(episode), (byte) => byte.charCodeAt(0)).buffer);
  });
  assert.equal(rows.length, length);
}

export const savesItsCharts: Check = async (page) => {
  const { terms, metrics } = await page.evaluate(() => {
    type Named = { name: string }[];
    const data = document.querySelector("#report-data")?.textContent ?? "";
    return JSON.parse(data) as { terms: Named; metrics: Named };
  });
  const [metric = ""] = metrics.map(({ name }) => name);
  await savesNumbers(page, "#curve-export", "returns", ["return", "mean"]);
  await savesNumbers(page, "#terms-export", "terms", terms.map(({ name }) => name));
  await savesNumbers(page, "#metrics article", metric, [metric, "mean"]);
  const { text: drawing } = await savedBy(page, "#terms-export", "SVG");
  for (const { name } of terms) assert.ok(drawing.includes(`<title>${name}</title>`), name);
  assert.match((await savedBy(page, "#learner article", "PNG")).text, /^.PNG/);
};
