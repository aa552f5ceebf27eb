// The pictures of the live page in docs/images, and others to be looked at; made by hand:
// pictures.mjs TRAINER TASK FOLDER [WIDTH], of windows of this width only. CHROMIUM names the browser.
// What the documentation shows in its text has no size in its name.

import { join, resolve } from "node:path";

import type { Page } from "playwright-core";

import { inBrowser, kDesktop, kPhone, onPage, screenshotsIn, sleep } from "./in_browser.ts";
import { inFolder, Trainer } from "./trainer.ts";

const [trainer = "", task = "", pictures = "."] = process.argv.slice(2, 5).map((path) => resolve(path));
const width = process.argv[5];
const kRun = join("runs", "crawling");
const kWords = ["--profile", "fast-tree", "--agent", "motion_search", "--episodes", "6000", "--seed", "1"];
const kLearned = 250; // episodes, until there is something to be seen
const kWatched = 6000; // [ms]
const kSizes = [kDesktop, { width: 1920, height: 1080 }, kPhone];

const screenshot = screenshotsIn(pictures);

async function hasLearned(run: Trainer): Promise<void> {
  while ((await run.ask("status")).episodes_done < kLearned) await sleep(1000);
}

/** The head of the page, and the editor with the equations and their numbers. */
async function pictured(page: Page, guise: string): Promise<void> {
  await page.locator("#shown", { hasText: /^Episode \d/ }).waitFor();
  await page.locator("#curve canvas").waitFor();
  await sleep(kWatched);
  await screenshot(page, `live${guise}`);
  await page.locator("#editor-open").click();
  await page.locator("#editor-page .present").first().waitFor();
  await page.locator("#editor-page").evaluate((equations) => {
    equations.scrollTop = 0;
    document.querySelector("#editor")?.scrollIntoView();
    scrollBy(0, -12);
  });
  await sleep(500);
  await screenshot(page, `live_editor${guise}`);
  await page.locator("#editor-page").evaluate((equations) => equations.scrollIntoView());
  await screenshot(page, `live_equations${guise}`);
}

await inBrowser(async (browser) =>
  inFolder(async (folder) => {
    process.chdir(folder); // so that the page names the run as it is named here
    const run = await Trainer.serve(trainer, [task, ...kWords, "--out", kRun], kRun);
    try {
      await hasLearned(run);
      for (const viewport of kSizes.filter((size) => !width || size.width === Number(width))) {
        for (const colorScheme of ["light", "dark"] as const) {
          const isShown = viewport === kDesktop && colorScheme === "light";
          const guise = isShown ? "" : `-${viewport.width}x${viewport.height}-${colorScheme}`;
          await onPage(browser, run.page, { viewport, colorScheme }, (page) => pictured(page, guise));
        }
      }
    } finally {
      run.kill();
    }
  }),
);
