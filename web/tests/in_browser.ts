// What the tests in a real browser have in common. CHROMIUM names the browser.

import assert from "node:assert/strict";
import { existsSync, mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

import axe from "axe-core";
import { chromium, type Browser, type BrowserContextOptions, type Page } from "playwright-core";

export const kPatience = 120_000; // [ms]: the machine may have other things to do
export const kDesktop = { width: 1280, height: 800 };
export const kPhone = { width: 390, height: 844 };
// Without a GPU. Only the robot's picture is drawn by WebGL: a page put together by it, too, would
// take a second for each frame.
const kSoftwareGl = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-compositing"];

const kBrowser = process.env["CHROMIUM"] ?? "";

export type Check = (page: Page) => Promise<void>;

export const sleep = (time: number): Promise<void> => new Promise((done) => setTimeout(done, time));

/** Without a browser the program ends with the exit status 77 (skipped). */
export async function inBrowser(
  check: (browser: Browser) => Promise<void>,
  args = kSoftwareGl,
): Promise<void> {
  if (!existsSync(kBrowser)) {
    console.log("skipped: there is no Chromium (Debian: apt install chromium)");
    process.exit(77);
  }
  const browser = await chromium.launch({ executablePath: kBrowser, args: ["--no-sandbox", ...args] });
  try {
    await check(browser);
  } finally {
    await browser.close();
  }
}

/** A page to be opened, and what it may ask for. */
export interface Address {
  url: string;
  isOwn: (url: string) => boolean;
}

/** Opens it after `prepare`, runs `check`, and fails for anything on the console and for any other request. */
export async function onPage(
  browser: Browser,
  { url, isOwn }: Address,
  options: BrowserContextOptions,
  check: Check,
  prepare: Check = () => Promise.resolve(),
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
    const isOfThePage = /^(data|blob):/.test(request.url()) || isOwn(request.url());
    if (!isOfThePage) complaints.push(`request: ${request.url()}`);
  });
  await prepare(page);
  await page.goto(url);
  await page.locator("html[data-ready=true]").waitFor({ state: "attached" });
  await check(page);
  await page.close();
  assert.deepEqual(complaints, []);
}

export const textOf = async (page: Page, selector: string): Promise<string> =>
  (await page.locator(selector).first().textContent()) ?? "";

/** "−1.250" as the pages write numbers. */
export const numberIn = (text: string): number =>
  Number(text.replace(/\u2212/g, "-").replace(/\u202f/g, ""));

export const fitsItsWidth: Check = async (page) => {
  const overflow = await page.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  assert.equal(overflow, 0, "fits its width");
};

/** Takes pictures into a folder, to be looked at. */
export function screenshotsIn(folder: string): (page: Page, name: string, whole?: boolean) => Promise<void> {
  mkdirSync(folder, { recursive: true });
  return async (page, name, whole = false) => {
    await page.screenshot({ path: join(folder, `${name}.png`), fullPage: whole });
  };
}

/** The file that a button of a chart's `host` saves. */
export async function savedBy(page: Page, host: string, format: "SVG" | "PNG" | "CSV"): Promise<{ name: string; text: string }> {
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    page.locator(host).first().getByRole("button", { name: format, exact: true }).click(),
  ]);
  return { name: file.suggestedFilename(), text: readFileSync(await file.path(), "utf8") };
}

const kGuises: [string, BrowserContextOptions][] = [
  ["", { colorScheme: "light" }],
  ["-dark", { colorScheme: "dark" }],
  ["-narrow", { colorScheme: "light", viewport: kPhone }],
  ["-narrow-dark", { colorScheme: "dark", viewport: kPhone }],
];

/** Light and dark, on a wide screen and on a phone; `check` is told what it is called then. */
export async function inEveryGuise(
  browser: Browser,
  address: Address,
  name: string,
  check: (page: Page, name: string) => Promise<void>,
): Promise<void> {
  for (const [guise, options] of kGuises) {
    await onPage(browser, address, { ...options, bypassCSP: true }, async (page) => {
      await check(page, name + guise);
      await hasNoSeriousFault(page);
    });
  }
}

/** Of those that keep people from using the page. The page's own policy lets in no script of axe-core:
 * open it with `bypassCSP`. */
export const hasNoSeriousFault: Check = async (page) => {
  await page.evaluate(axe.source);
  const { violations } = await page.evaluate(() =>
    (window as unknown as { axe: typeof axe }).axe.run(document, { resultTypes: ["violations"] }),
  );
  const faults = violations
    .filter(({ impact }) => impact === "serious" || impact === "critical")
    .map(({ id, nodes }) => `${id}: ${nodes.map(({ html, failureSummary }) => `${html}\n${failureSummary}`).join("\n")}`);
  assert.deepEqual(faults, []);
  const aloud = await page.locator("output:not([aria-live=off])").count();
  assert.equal(aloud, 0, "numbers are read aloud whenever they change");
};
