// The live page of a real run in a real browser: live.mjs TRAINER TASK SCREENSHOTS. CHROMIUM names
// the browser; without it the exit status is 77 (skipped).

import assert from "node:assert/strict";
import { spawn, type ChildProcess } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { chromium, type Browser, type BrowserContextOptions, type Page } from "playwright-core";

const [trainer = "", task = "", screenshots = "."] = process.argv.slice(2);
const kBrowser = process.env["CHROMIUM"] ?? "";
const kSoftwareGl = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const kPatience = 120_000; // [ms]: the machine may have other things to do
const kDesktop = { width: 1280, height: 800 };
const kPhone = { width: 390, height: 844 };

interface Control {
  url: string;
  token: string;
}

const sleep = (time: number): Promise<void> => new Promise((done) => setTimeout(done, time));

async function startTrainer(folder: string): Promise<[ChildProcess, Control]> {
  const run = join(folder, "run");
  const words = ["serve", task, "--profile", "fast-tree", "--episodes", "100000", "--seed", "1"];
  const process = spawn(trainer, [...words, "--out", run, "--quiet"], { stdio: "inherit" });
  for (const end = Date.now() + kPatience; Date.now() < end; await sleep(50)) {
    const file = join(run, "control.json");
    if (existsSync(file)) return [process, JSON.parse(readFileSync(file, "utf8")) as Control];
  }
  throw new Error("the trainer does not serve");
}

class Run {
  constructor(readonly control: Control) {}

  get page(): string {
    return `${this.control.url}?token=${this.control.token}`;
  }
  async ask(command: string, args: object = {}): Promise<any> {
    const response = await fetch(`${this.control.url}api/${command}`, {
      method: "POST",
      headers: { Authorization: `Bearer ${this.control.token}` },
      body: JSON.stringify(args),
    });
    const reply = (await response.json()) as { ok: boolean; value: unknown; error: string };
    assert.ok(reply.ok, reply.error);
    return reply.value;
  }
}

/** Fails for anything on the console, and for any request that does not go to the trainer. */
async function onPage(
  browser: Browser,
  run: Run,
  options: BrowserContextOptions,
  check: (page: Page) => Promise<void>,
): Promise<void> {
  const page = await browser.newPage({ viewport: kDesktop, ...options });
  page.setDefaultTimeout(kPatience);
  const complaints: string[] = [];
  page.on("console", (message) => {
    const isRefusal = message.text().includes("status of 422"); // what is asked for on purpose
    if (message.type() === "error" && !isRefusal) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(String(error.stack)));
  page.on("request", (request) => {
    const { host } = new URL(run.control.url);
    const isOurs = /^(data|blob):/.test(request.url()) || new URL(request.url()).host === host;
    if (!isOurs) complaints.push(`request: ${request.url()}`);
  });
  await page.goto(run.page);
  await page.locator("html[data-ready=true]").waitFor({ state: "attached" });
  await check(page);
  await page.close();
  assert.deepEqual(complaints, []);
}

const textOf = async (page: Page, selector: string): Promise<string> =>
  (await page.locator(selector).first().textContent()) ?? "";

/** "−1.250" as the page writes numbers. */
const numberIn = (text: string): number => Number(text.replace(/\u2212/g, "-").replace(/\u202f/g, ""));

const isAbout = (shown: number, value: number): boolean =>
  Math.abs(shown - value) <= 6e-4 * Math.max(1, Math.abs(value));

const screenshot = (page: Page, name: string, fullPage = false): Promise<unknown> =>
  page.screenshot({ path: join(screenshots, `${name}.png`), fullPage });

async function showsTheRun(page: Page): Promise<void> {
  assert.equal(await textOf(page, "#state"), "running");
  await page.locator("#shown", { hasText: /^Episode \d/ }).waitFor();
  assert.ok((await page.locator("#rewards tbody tr").count()) >= 2);
  assert.ok((await page.locator("#lines .pays").count()) >= 1);
  assert.ok((await page.locator(".value-row").count()) >= 3);
  await page.locator("#curve canvas").waitFor();
  const overflow = await page.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  assert.equal(overflow, 0, "fits its width");
}

/** A paused run: what the page says is what the API says. */
async function numbersAreThoseOfTheApi(page: Page, run: Run): Promise<void> {
  await page.getByRole("button", { name: "Pause" }).click();
  await page.locator('#state[data-state="paused"]').waitFor();
  await page.locator("#step").click();
  await page.locator("#shown", { hasText: "paused here" }).waitFor();
  const status = await run.ask("status");
  // Half of the time steps of 5 ms end where two digits may be rounded up or down.
  await page.waitForFunction((time) => {
    const shown = /, ([\d.]+) s/.exec(document.querySelector("#shown")?.textContent ?? "");
    return shown !== null && Math.abs(Number(shown[1]) - time) < 0.006;
  }, status.time);
  assert.match(await textOf(page, "#shown"), new RegExp(`^Episode ${status.episode},`));
  // The step, the reply and the page may each be one step apart for a moment.
  let { tasks } = await run.ask("list");
  const ofTask = `tr[data-sum-of="${tasks[0].task}"] .sum`;
  for (let i = 0; i < 100 && !isAbout(numberIn(await textOf(page, ofTask)), tasks[0].return); ++i) {
    await sleep(100);
    ({ tasks } = await run.ask("list"));
  }
  for (const [term, sum] of Object.entries(tasks[0].terms as Record<string, number>)) {
    const shown = numberIn(await textOf(page, `tr[data-term="${term}"] .sum`));
    assert.ok(isAbout(shown, sum), `${term}: ${shown} is ${sum}`);
  }
  assert.ok(isAbout(numberIn(await textOf(page, ofTask)), tasks[0].return));
  await page.getByRole("button", { name: "Resume" }).click();
  await page.locator('#state[data-state="running"]').waitFor();
}

async function aSliderSetsAParameter(page: Page, run: Run): Promise<void> {
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
async function aRewiringIsRefusedWithAReason(page: Page, run: Run): Promise<void> {
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
async function aTaskIsEdited(page: Page, run: Run): Promise<void> {
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

if (!existsSync(kBrowser)) {
  console.log("skipped: there is no Chromium (Debian: apt install chromium)");
  process.exit(77);
}
mkdirSync(screenshots, { recursive: true });
const folder = mkdtempSync(join(tmpdir(), "live-"));
const [child, control] = await startTrainer(folder);
const run = new Run(control);
const browser = await chromium.launch({ executablePath: kBrowser, args: ["--no-sandbox", ...kSoftwareGl] });
try {
  await onPage(browser, run, { colorScheme: "light" }, async (page) => {
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
    await aRewiringIsRefusedWithAReason(page, run);
    await aTaskIsEdited(page, run);
    await screenshot(page, "live-whole", true);
  });
  for (const [name, options] of [
    ["live-dark", { colorScheme: "dark" }],
    ["live-narrow", { colorScheme: "light", viewport: kPhone }],
    ["live-narrow-dark", { colorScheme: "dark", viewport: kPhone }],
  ] as const) {
    await onPage(browser, run, options, async (page) => {
      await showsTheRun(page);
      await sleep(4000);
      await screenshot(page, name);
      await screenshot(page, `${name}-whole`, true);
    });
  }
} finally {
  await browser.close();
  child.kill("SIGKILL");
  rmSync(folder, { recursive: true, force: true });
}
