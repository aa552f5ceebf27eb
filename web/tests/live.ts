// The live page of a real run in a real browser: live.mjs TRAINER TASK SCREENSHOTS. CHROMIUM names
// the browser; without it the exit status is 77 (skipped).

import assert from "node:assert/strict";
import { join } from "node:path";

import type { Page } from "playwright-core";

import {
  fitsItsWidth,
  inBrowser,
  inEveryGuise,
  numberIn,
  onPage,
  savedBy,
  screenshotsIn,
  sleep,
  textOf,
} from "./in_browser.ts";
import { isDrawnInSightOnly } from "./replay_checks.ts";
import { inFolder, Trainer } from "./trainer.ts";

const [trainer = "", task = "", screenshots = "."] = process.argv.slice(2);
const screenshot = screenshotsIn(screenshots);

const isAbout = (shown: number, value: number): boolean =>
  Math.abs(shown - value) <= 6e-4 * Math.max(1, Math.abs(value));

async function showsTheRun(page: Page): Promise<void> {
  assert.equal(await textOf(page, "#state"), "running");
  await page.locator("#shown", { hasText: /^Episode \d/ }).waitFor();
  assert.ok((await page.locator("#rewards tbody tr").count()) >= 2);
  assert.ok((await page.locator("#lines .pays").count()) >= 1);
  assert.ok((await page.locator(".value-row").count()) >= 3);
  await page.locator("#curve canvas").waitFor();
  await fitsItsWidth(page);
}

/** A paused run: what the page says is what the API says. */
async function numbersAreThoseOfTheApi(page: Page, run: Trainer): Promise<void> {
  await page.locator("#pause").click();
  await page.locator('#state[data-state="paused"]').waitFor();
  await page.locator("#step").click();
  await page.locator("#shown", { hasText: "paused here" }).waitFor();
  await page.locator("#scrub[disabled]").waitFor({ state: "attached" });
  const status = await run.ask("status");
  // Half of the time steps of 5 ms end where two digits may be rounded up or down.
  await page.waitForFunction((time) => {
    const shown = /, ([\d.]+) s/.exec(document.querySelector("#shown")?.textContent ?? "");
    return shown !== null && Math.abs(Number(shown[1]) - time) < 0.006;
  }, status.time);
  assert.match(await textOf(page, "#shown"), new RegExp(`^Episode ${status.episode},`));
  // The step, the reply and the page may each be one step apart for a moment.
  let different = ["nothing was compared"];
  for (let i = 0; i < 100 && different.length > 0; ++i) {
    const { tasks } = await run.ask("list");
    const sums = Object.entries(tasks[0].terms as Record<string, number>).map(
      ([term, sum]): [string, number] => [`tr[data-term="${term}"] .sum`, sum],
    );
    sums.push([`tr[data-sum-of="${tasks[0].task}"] .sum`, tasks[0].return]);
    different = [];
    for (const [place, sum] of sums) {
      const shown = numberIn(await textOf(page, place));
      if (!isAbout(shown, sum)) different.push(`${place}: ${shown} is ${sum}`);
    }
    if (different.length > 0) await sleep(100);
  }
  assert.deepEqual(different, []);
  await page.locator("#pause").click();
  await page.locator('#state[data-state="running"]').waitFor();
}

async function aSliderSetsAParameter(page: Page, run: Trainer): Promise<void> {
  const [task] = (await run.ask("list")).tasks;
  const parameter = task.params.find((each: { minimum?: number; maximum?: number; value: unknown }) =>
    typeof each.value === "number" && each.minimum !== undefined && each.maximum !== undefined);
  assert.ok(parameter, "the task has a parameter with a range");
  const name = `${task.module}.${parameter.name}`;
  const slider = page.locator(`[data-parameter="${name}"] input[type=range]`);
  await slider.focus();
  await page.keyboard.press(parameter.value < parameter.maximum ? "ArrowRight" : "ArrowLeft");
  await page.locator("#changes li", { hasText: name }).first().waitFor();
  const set = await run.ask("get", { name });
  assert.notEqual(set.value, parameter.value);
  const shown = await page.locator(`[data-parameter="${name}"] input[type=number]`).inputValue();
  assert.ok(isAbout(Number(shown), set.value));
}

/** The learner without a task: the trainer says why not, and nothing has changed. */
async function aRewiringIsRefusedWithAReason(page: Page, run: Trainer): Promise<void> {
  await page.locator('[data-port="task.reward"]').first().waitFor();
  const before = await run.ask("graph", { format: "json" });
  await page.getByText("Connections as a list").click();
  const row = page.locator("#graph-list li", { hasText: "task.reward → learner.reward" });
  await row.getByRole("button").click();
  await page.locator("#graph-cut").click();
  await page.locator("#graph-refusal", { hasText: "learner" }).waitFor();
  assert.deepEqual(await run.ask("graph", { format: "json" }), before);
}

/** Edit, see the error, mend it, try it as a shadow, promote it, and go back. */
async function aTaskIsEdited(page: Page, run: Trainer): Promise<void> {
  await page.locator("#editor-open").click();
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+End");
  await page.keyboard.type("\nmetric extra = base.positio.x");
  await page.locator(".cm-lintRange-error").first().waitFor();
  assert.ok(await page.locator("#editor-try").isDisabled());
  await page.locator("#editor-text").scrollIntoViewIfNeeded();
  await screenshot(page, "live-error");
  for (let i = 0; i < 2; ++i) await page.keyboard.press("Backspace");
  await page.keyboard.type("n.x");
  await page.locator(".cm-lintRange-error").waitFor({ state: "detached" });
  await page.locator("#editor-try:not([disabled])").waitFor();
  await page.keyboard.press("Control+s");
  await page.locator('.task-card[data-module="edited"]').waitFor();
  await page.locator('tr[data-sum-of="edited"]').waitFor();
  await page.locator("#curve-key", { hasText: "shadow edited" }).waitFor();
  const card = page.locator('.task-card[data-module="edited"]');
  await card.getByRole("button", { name: "Promote" }).click();
  await page.locator('.task-card[data-module="edited"][data-role="active"]').waitFor();
  const { tasks } = await run.ask("list");
  assert.equal(tasks.find((each: { module: string }) => each.module === "edited").role, "active");
  await page.locator('[data-value="extra"]').waitFor();
  await page.locator('.task-card[data-module="task"]').getByRole("button", { name: "Promote" }).click();
  await page.locator('.task-card[data-module="task"][data-role="active"]').waitFor();
}

/** The equations of the text, and what it would have paid. */
async function anEpisodeIsJudged(page: Page, run: Trainer): Promise<void> {
  await page.locator("#editor-page .katex").first().waitFor();
  await page.locator("#editor-revert").click();
  await page.locator("#what-if-now").click();
  const rows = page.locator("#what-if-result tr[data-what-if]");
  await rows.first().waitFor();
  const judged = await run.ask("rescore", {
    file: task,
    episode: Number(await page.locator("#what-if-episode").inputValue()),
  });
  const { old } = judged;
  const returned = page.locator('tr[data-what-if="return"] td');
  assert.ok(isAbout(numberIn((await returned.nth(1).textContent()) ?? ""), old.return));
  assert.equal(await returned.nth(3).textContent(), "0");
  const namesOf = (what: "terms" | "metrics"): Set<string> =>
    new Set([...Object.keys(old[what]), ...Object.keys(judged.new[what])]);
  assert.equal(await rows.count(), 1 + namesOf("terms").size + namesOf("metrics").size);
}

/** At the equations stand the numbers of the moment that one has gone to. */
async function equationsSayTheMoment(page: Page, run: Trainer): Promise<void> {
  const slider = page.locator("#editor-scrub:not([disabled])");
  const read = (name: string): Promise<string> => textOf(page, `#editor-page [data-read="${name}"] .value`);
  const [{ terms, params }] = (await run.ask("list")).tasks;
  const areThoseOfTheRewards = (names: string[]): boolean =>
    names.every((term) => {
      const textsIn = (selector: string): (string | null)[] =>
        [...document.querySelectorAll(selector)].map(({ textContent }) => textContent);
      const [rate, , sum] = textsIn(`#rewards tr[data-term="${term}"] output`);
      const said = textsIn(`#editor-page [data-term="${term}"] .value`);
      return said.length === 2 && said[0] === rate && said[1] === sum;
    });
  for (const [key, isMoment] of [
    ["End", (time: number) => time > 0],
    ["PageDown", (time: number) => time > 0],
    ["Home", (time: number) => time === 0],
  ] as const) {
    await slider.focus();
    await page.keyboard.press(key);
    await page.locator("#shown", { hasText: "held at this moment" }).waitFor();
    await page.waitForFunction(areThoseOfTheRewards, Object.keys(terms));
    await page.waitForFunction(() => {
      const said = document.querySelector('#editor-page [data-read="time"] .value')?.textContent;
      return said === undefined || document.querySelector("#shown")?.textContent?.includes(`, ${said} s`);
    });
    assert.ok(isMoment(Number(await slider.inputValue())));
  }
  for (const { name, value } of params) {
    if (await page.locator(`#editor-page [data-read="${name}"]`).count()) {
      assert.ok(isAbout(numberIn(await read(name)), value), name);
    }
  }
  await page.locator("#editor-page").scrollIntoViewIfNeeded();
  await screenshot(page, "live-equations");
  await page.locator("#editor-play").click();
  await page.locator("#shown", { hasText: "in real time" }).waitFor();
}

/** What is saved of a card is what the trainer has recorded. */
async function aCardIsSaved(page: Page, run: Trainer): Promise<void> {
  await page.locator("#curves").scrollIntoViewIfNeeded();
  await page.locator("#curves article canvas").first().waitFor();
  const [{ terms }] = (await run.ask("list")).tasks;
  const term = await textOf(page, "#curves article h3");
  assert.ok(Object.keys(terms).includes(term));
  const { name, text } = await savedBy(page, "#curves article", "CSV");
  assert.equal(name, `${term}.csv`);
  assert.match(text, new RegExp(`^episode,${term},mean\\n1,`));
  assert.match((await savedBy(page, "#curves article", "SVG")).text, /^<svg .*<\/svg>\n$/s);
}

/** A term that the episode was not paid: what it would have brought, and what its let is worth, at once. */
async function anEditIsJudgedAtOnce(page: Page, run: Trainer): Promise<void> {
  await page.locator("#what-if-follow").check();
  const sum = async (column: number): Promise<number> =>
    numberIn((await page.locator('tr[data-what-if="bonus"] td').nth(column).textContent()) ?? "");
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+End");
  const lines = ["", "on end_of_action {", "  let twice = 2 * fall_penalty", "  reward bonus = twice", "}", ""];
  await page.keyboard.insertText(lines.join("\n")); // as one pastes it: nothing is completed
  await page.locator('tr[data-what-if="bonus"]').waitFor();
  assert.ok((await sum(2)) > 0);
  const [{ params }] = (await run.ask("list")).tasks;
  const penalty = params.find(({ name }: { name: string }) => name === "fall_penalty").value;
  for (const place of ['[data-let="twice"]', '[data-read="twice"]']) {
    assert.ok(isAbout(numberIn(await textOf(page, `#editor-page ${place} .value`)), 2 * penalty), place);
  }
  await page.locator("#editor-text").scrollIntoViewIfNeeded();
  await screenshot(page, "live-what-if");
  await page.locator("#what-if-follow").uncheck();
  await page.locator("#editor-revert").click();
}

await inBrowser(async (browser) =>
  inFolder(async (folder) => {
    const out = join(folder, "run");
    const words = [task, "--profile", "fast-tree", "--episodes", "100000", "--seed", "1", "--out", out];
    const run = await Trainer.serve(trainer, words, out);
    try {
      await onPage(browser, run.page, { colorScheme: "light" }, async (page) => {
        const isThere = await page.evaluate(() => {
          const [navigation] = performance.getEntriesByType("navigation");
          return (navigation as PerformanceNavigationTiming).domContentLoadedEventEnd;
        });
        console.log(`the page is there after ${isThere.toFixed(0)} ms`);
        await showsTheRun(page);
        await numbersAreThoseOfTheApi(page, run);
        await aSliderSetsAParameter(page, run);
        await page.evaluate(() => scrollTo(0, 0));
        await sleep(3000);
        await screenshot(page, "live");
        await isDrawnInSightOnly(page);
        await aRewiringIsRefusedWithAReason(page, run);
        await aTaskIsEdited(page, run);
        await anEpisodeIsJudged(page, run);
        await equationsSayTheMoment(page, run);
        await anEditIsJudgedAtOnce(page, run);
        await aCardIsSaved(page, run);
        await screenshot(page, "live-whole", true);
      });
      await inEveryGuise(browser, run.page, "live-seen", async (page, name) => {
        await showsTheRun(page);
        await sleep(4000);
        await screenshot(page, name);
        await page.locator("#editor-open").click();
        await page.locator("#editor-page .katex").first().waitFor();
        await screenshot(page, `${name}-whole`, true);
      });
    } finally {
      run.kill();
    }
  }),
);
