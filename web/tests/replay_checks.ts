// What is checked of two replays in step, of what is drawn beside the robot, and of when it is drawn.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

import type { Page } from "playwright-core";

import { sleep, textOf } from "./in_browser.ts";

/** How many pixels of the stage are about of the color that the style sheet calls `name`. */
async function pixelsOf(page: Page, name: string): Promise<number> {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const png = await page.locator("#stage").screenshot();
  return page.evaluate(
    async ([base64, color]) => {
      const image = new Image();
      image.src = `data:image/png;base64,${base64}`;
      await image.decode();
      const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
      if (!context) return 0;
      context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue(color as string);
      context.fillRect(0, 0, 1, 1);
      const wanted = [...context.getImageData(0, 0, 1, 1).data];
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) {
        if ([0, 1, 2].every((k) => Math.abs((data[i + k] ?? 0) - (wanted[k] ?? 0)) < 12)) ++count;
      }
      return count;
    },
    [png.toString("base64"), name],
  );
}

/** A robot that moves costs nothing where it is scrolled away, and is drawn again where it is seen. */
export async function isDrawnInSightOnly(page: Page): Promise<void> {
  await page.evaluate(() => {
    const { prototype } = WebGL2RenderingContext;
    const { dataset } = document.documentElement;
    const clear = prototype.clear;
    prototype.clear = function (this: WebGL2RenderingContext, mask) {
      dataset["pictures"] = String(Number(dataset["pictures"] ?? 0) + 1);
      clear.call(this, mask);
    };
    scrollTo(0, document.body.scrollHeight);
  });
  const drawn = (): Promise<string | null> => page.locator("html").getAttribute("data-pictures");
  await sleep(1000); // a picture may be under way
  const before = await drawn();
  await sleep(1000);
  assert.equal(await drawn(), before);
  await page.locator("#stage").scrollIntoViewIfNeeded();
  await page.waitForFunction((count) => document.documentElement.dataset["pictures"] !== count, before ?? undefined);
}

/** The center of mass and the contact points appear and go. */
export async function drawsWhatIsSwitchedOn(page: Page): Promise<void> {
  await page.locator("#scrub").fill("4");
  for (const [aid, color] of [["mass", "--mass"], ["points", "--touch"]] as const) {
    const input = page.locator(`[data-aid="${aid}"]`);
    assert.ok((await pixelsOf(page, color)) < 20, `${aid}: not asked for`);
    await input.check();
    assert.ok((await pixelsOf(page, color)) > 40, `${aid} is drawn`);
    await input.uncheck();
    assert.ok((await pixelsOf(page, color)) < 20, `${aid} is gone`);
  }
  assert.ok(await page.locator('[data-aid="goals"]').isHidden(), "this task has none");
}

/** The sample's robot holds its ankles at -0.6 rad all the time. */
export async function showsTheJointsOfALink(page: Page): Promise<void> {
  await page.locator("#picked").selectOption("left ankle");
  await page.locator("#joints", { hasText: /left_ankle_pitch {2}−0\.600 rad, −34\.38°/ }).waitFor();
  const rows = page.locator('.timeline .label[data-kind="joint"]');
  const names = await rows.locator(".name").allTextContents();
  const pitch = names.findIndex((name) => name === "left_ankle_pitch [rad]");
  assert.equal(await rows.nth(pitch).locator(".now").textContent(), "−0.600");
  assert.ok((await pixelsOf(page, "--mass")) < 20);
  await page.locator("#picked").selectOption("");
  assert.equal(await rows.count(), 0);
  assert.equal(await textOf(page, "#joints"), "");
}

/** A click on the robot picks what it hits, beside it nothing. */
export async function picksALinkByAClick(page: Page): Promise<void> {
  const stage = page.locator("#stage canvas");
  await stage.scrollIntoViewIfNeeded();
  const box = await stage.boundingBox();
  assert.ok(box);
  await stage.click({ position: { x: box.width / 2, y: box.height / 2 } });
  assert.notEqual(await page.locator("#picked").inputValue(), "");
  await stage.click({ position: { x: box.width / 2, y: 40 } });
  assert.equal(await page.locator("#picked").inputValue(), "");
}

/** Another episode beside the first one: one time, two places, two timelines of one length. */
export async function replaysTwoInStep(page: Page): Promise<void> {
  assert.ok(await page.locator("#other-stage").isHidden());
  const first = await page.locator("#recording").inputValue();
  await page.locator("#other").selectOption({ index: 1 });
  assert.ok(await page.locator("#other-stage canvas").isVisible());
  assert.match(await textOf(page, "#stage-title"), /^episode \d+, return /);
  assert.match(await textOf(page, "#other-title"), /^episode \d+, return /);
  assert.equal(await textOf(page, "#other-timeline-heading"), await textOf(page, "#other-title"));
  await page.locator("#scrub").fill("4");
  await page.waitForFunction(
    () => /x [−\d]/.test(document.querySelector("#other-place")?.textContent ?? ""),
  );
  assert.notEqual(await textOf(page, "#place"), await textOf(page, "#other-place"));
  for (const section of ["timeline", "other-timeline"]) {
    assert.match(await textOf(page, `#${section}-now`), /^\s*4\.00 s/);
  }
  const [cursor, other] = await page.locator(".timeline .cursor").all();
  const [a, b] = [await cursor?.boundingBox(), await other?.boundingBox()];
  assert.ok(Math.abs((a?.x ?? 0) - (b?.x ?? 1e3)) < 2, "both cursors stand below each other");
  const ranges = await page.locator(".timeline .range:first-of-type").allTextContents();
  assert.equal(ranges[0], ranges[1], "the traces are of one scale");
  await page.locator("#recording").selectOption({ index: 3 }); // the second one stays
  assert.ok(await page.locator("#other-stage canvas").isVisible());
  await page.locator("#other").selectOption("");
  assert.ok(await page.locator("#other-stage").isHidden());
  assert.ok(await page.locator("#other-timeline").isHidden());
  await page.locator("#recording").selectOption(first);
}

/** In the dialog of a study: the typical runs of two groups. */
export async function replaysTwoGroups(page: Page): Promise<void> {
  await page.locator("#other").selectOption({ index: 2 });
  assert.match(await textOf(page, "#other-title"), /^crawling, group B: seed \d, episode 40$/);
  await page.locator("#other-place", { hasText: /^x / }).waitFor();
  await page.locator("#other").selectOption("");
}

/** The film of an episode begins with the mark of its kind. */
export async function savesAFilm(page: Page): Promise<void> {
  await page.locator("#scrub").fill("0");
  await page.locator("#speed").selectOption("4");
  const [saved] = await Promise.all([page.waitForEvent("download"), page.locator("#film").click()]);
  await page.locator("#speed").selectOption("1");
  assert.match(saved.suggestedFilename(), /^episode \d+, return .*\.(webm|mp4)$/);
  const bytes = readFileSync(await saved.path());
  const isWebm = bytes.subarray(0, 4).equals(Buffer.from([0x1a, 0x45, 0xdf, 0xa3]));
  assert.ok(isWebm || bytes.subarray(4, 8).toString() === "ftyp");
  assert.ok(bytes.length > 20_000, `${bytes.length} bytes`);
  assert.equal(await textOf(page, "#film"), "save a film");
}
