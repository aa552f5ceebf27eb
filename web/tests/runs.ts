// The page of a folder of runs in a real browser: runs.mjs TRAINER TASK SCREENSHOTS.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";

import type { Browser, Page } from "playwright-core";

import {
  fitsItsWidth,
  inBrowser,
  inEveryGuise,
  numberIn,
  onPage,
  savedBy,
  screenshotsIn,
  textOf,
} from "./in_browser.ts";
import { inFolder, Trainer } from "./trainer.ts";

const [trainer = "", task = "", screenshots = "."] = process.argv.slice(2);
const kRun = "crawling-fast-tree/seed1";
const screenshot = screenshotsIn(screenshots);

const rowOf = (page: Page, run = kRun) => page.locator(`tr[data-run="${run}"]`);
const waitForState = (page: Page, state: string, run = kRun): Promise<void> =>
  rowOf(page, run).locator(`.state[data-state="${state}"]`).waitFor();

async function startsRuns(page: Page): Promise<void> {
  await page.locator("#no-runs").waitFor();
  await page.locator("#start [name=task]").fill(task);
  await page.locator("#start [name=profile]").selectOption("fast-tree");
  await page.locator("#start [name=episodes]").fill("100000");
  await page.locator("#start [name=runs]").fill("2");
  await page.getByRole("button", { name: "Start" }).click();
  await waitForState(page, "running");
  await waitForState(page, "running", "crawling-fast-tree/seed2");
  await page.locator("#curves canvas").waitFor();
  await page.locator("#curves-key", { hasText: "mean of the runs" }).waitFor();
}

async function refusesWhatCannotBe(page: Page): Promise<void> {
  await page.locator("#start [name=task]").fill("nowhere.task");
  await page.getByRole("button", { name: "Start" }).click();
  await page.locator("#start-refusal", { hasText: "no such file" }).waitFor();
}

/** What the page says of a run that stands still is what the API says. */
async function pausesAndResumes(page: Page, server: Trainer): Promise<void> {
  await rowOf(page).getByRole("button", { name: "Pause" }).click();
  await waitForState(page, "paused");
  const { runs } = await server.ask("runs");
  const run = runs.find(({ name }: { name: string }) => name === kRun);
  assert.equal(run.state, "paused");
  await page.waitForFunction(
    ([row, episodes]) => document.querySelector(`${row} .episodes span`)?.textContent?.startsWith(episodes as string),
    [`tr[data-run="${kRun}"]`, `${run.episodes} `] as const,
  );
  const mean = numberIn(await textOf(page, `tr[data-run="${kRun}"] .mean output`));
  assert.ok(Math.abs(mean - run.mean_return) <= 1e-3 * Math.max(1, Math.abs(mean)));
  await rowOf(page).getByRole("button", { name: "Resume" }).click();
  await waitForState(page, "running");
}

async function comparesThoseThatAreChosen(page: Page): Promise<void> {
  await page.locator("#choose-none").click();
  await page.locator("#comparison").waitFor({ state: "hidden" });
  await rowOf(page).locator("input[type=checkbox]").check();
  await page.locator("#curves-key li", { hasText: kRun }).waitFor();
  assert.equal(await page.locator("#curves-key li").count(), 1);
  await page.locator("#choose-all").click();
  await page.locator("#curves-key", { hasText: "confidence interval" }).waitFor();
  const { name, text } = await savedBy(page, "#curves-export", "CSV");
  assert.equal(name, "runs.csv");
  assert.match(text, /^episode,95 % low,95 % high,.*,mean\n1,/);
}

async function opensARun(page: Page, browser: Browser): Promise<void> {
  const link = rowOf(page).getByRole("link", { name: "Open" });
  const address = (await link.getAttribute("href")) ?? "";
  const { host } = new URL(address);
  await onPage(browser, { url: address, isOwn: (url) => new URL(url).host === host }, {}, async (run) => {
    assert.match(await textOf(run, "#run-words"), /seed1/);
  });
}

async function stopsARun(page: Page): Promise<void> {
  await rowOf(page).getByRole("button", { name: "Stop" }).click();
  await waitForState(page, "stopped");
  const report = (await rowOf(page).getByRole("link", { name: "Report" }).getAttribute("href")) ?? "";
  const response = await page.request.get(new URL(report, page.url()).href);
  assert.match(await response.text(), /learning run/);
}

await inBrowser(async (browser) =>
  inFolder(async (folder) => {
    const runs = join(folder, "runs");
    mkdirSync(runs);
    const server = await Trainer.serve(trainer, [runs, "--jobs", "2"], runs);
    try {
      await onPage(browser, server.page, { colorScheme: "light" }, async (page) => {
        await startsRuns(page);
        await refusesWhatCannotBe(page);
        await pausesAndResumes(page, server);
        await comparesThoseThatAreChosen(page);
        await fitsItsWidth(page);
        await opensARun(page, browser);
      });
      await inEveryGuise(browser, server.page, "runs", async (page, name) => {
        await page.locator("#curves canvas").waitFor();
        await fitsItsWidth(page);
        await screenshot(page, name, true);
      });
      await onPage(browser, server.page, {}, stopsARun);
    } finally {
      server.kill();
    }
  }),
);
