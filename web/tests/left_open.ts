// The live page of a real run, left open for hours: what it and the trainer need must stay the same. Made by
// hand: left_open.mjs TRAINER TASK [HOURS]. CHROMIUM names the browser.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";

import type { CDPSession, Page } from "playwright-core";

import { inBrowser, onPage, sleep } from "./in_browser.ts";
import { inFolder, Trainer } from "./trainer.ts";

const [trainer = "", task = "", hours = "8"] = process.argv.slice(2);
const kSamples = 16;
const kWindow = { width: 420, height: 320 }; // software draws it
const kPace = "4"; // × real time: thirty pictures a second all the time
const kMostRows = 8192;
const kRow = 1 / 1024; // [MB]

interface Sample {
  episodes: number;
  heap: number; // of the page's script [MB]
  nodes: number;
  listeners: number;
  trainer: number; // [MB]
}

/** What is left when the garbage is gone. */
async function sampleOf(devtools: CDPSession, run: Trainer): Promise<Sample> {
  for (let i = 0; i < 3; ++i) await devtools.send("HeapProfiler.collectGarbage");
  const { metrics } = await devtools.send("Performance.getMetrics");
  const metric = (name: string): number => metrics.find((each) => each.name === name)?.value ?? NaN;
  const { pid, episodes_done: episodes } = (await run.ask("status")) as { pid: number; episodes_done: number };
  const [, kilobytes] = /VmRSS:\s*(\d+)/.exec(readFileSync(`/proc/${pid}/status`, "utf8")) ?? [];
  return {
    episodes,
    heap: metric("JSHeapUsedSize") / 2 ** 20,
    nodes: metric("Nodes"),
    listeners: metric("JSEventListeners"),
    trainer: Number(kilobytes) / 1024,
  };
}

async function samplesOf(page: Page, run: Trainer): Promise<Sample[]> {
  const devtools = await page.context().newCDPSession(page);
  await devtools.send("Performance.enable");
  const samples: Sample[] = [];
  while (samples.length <= kSamples) {
    if (samples.length > 0) await sleep((Number(hours) * 3600_000) / kSamples);
    const sample = await sampleOf(devtools, run);
    samples.push(sample);
    const words = Object.entries(sample).map(([name, value]: [string, number]) => `${name} ${Number(value.toFixed(1))}`);
    console.log(`${new Date().toISOString()}  ${words.join(", ")}`);
  }
  return samples;
}

/** At the end against the middle: before that there is what is only made once. A page keeps some numbers of
 * each of the first 8,192 episodes, for the curves; of more it keeps means. */
function staysTheSame(samples: Sample[]): void {
  const middle = samples[kSamples / 2] as Sample;
  const end = samples.at(-1) as Sample;
  const kept = Math.min(end.episodes, kMostRows) - Math.min(middle.episodes, kMostRows);
  assert.ok(end.heap < 1.05 * middle.heap + kept * kRow + 0.5, "the heap grows");
  assert.ok(end.nodes < 1.05 * middle.nodes + 20, "the page has more and more elements");
  assert.ok(end.listeners <= middle.listeners + 5, "more and more is listened to");
  assert.ok(end.trainer < 1.05 * middle.trainer + 1, "the trainer grows");
}

await inBrowser(async (browser) =>
  inFolder(async (folder) => {
    const out = join(folder, "run");
    const words = [task, "--profile", "fast-tree", "--episodes", "100000000", "--out", out];
    const run = await Trainer.serve(trainer, words, out);
    try {
      await onPage(browser, run.page, { viewport: kWindow }, async (page) => {
        await page.locator("#pace").selectOption(kPace);
        await page.locator("#editor-open").click();
        await page.locator("#editor-page .katex").first().waitFor();
        staysTheSame(await samplesOf(page, run));
      });
    } finally {
      run.kill();
    }
  }),
);
