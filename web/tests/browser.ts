// The pages in a real browser: browser.mjs FULL_PAGE FIRST_PAGE TUNED_PAGE STUDY_PAGE PROBE_PAGE
// SCREENSHOTS, where FULL_PAGE shows a run with recordings, FIRST_PAGE one with a single episode and
// none, TUNED_PAGE one with changes and a shadow, STUDY_PAGE many runs, and PROBE_PAGE searches.
// CHROMIUM names the browser; without it the exit status is 77 (skipped).

import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

import type { Browser, BrowserContextOptions, Page } from "playwright-core";

import { savesItsCharts } from "./chart_checks.ts";
import {
  fitsItsWidth,
  hasNoSeriousFault,
  inBrowser,
  onPage as onPageAt,
  screenshotsIn,
  textOf,
  type Check,
} from "./in_browser.ts";
import {
  drawsWhatIsSwitchedOn,
  isDrawnInSightOnly,
  picksALinkByAClick,
  replaysTwoGroups,
  replaysTwoInStep,
  savesAFilm,
  showsTheJointsOfALink,
} from "./replay_checks.ts";

const [fullPage = "", firstPage = "", tunedPage = "", studyPage = "", probePage = "", screenshots = "."] =
  process.argv.slice(2);

/** Opens `file`, which asks for nothing else. */
async function onPage(
  browser: Browser,
  file: string,
  options: BrowserContextOptions,
  check: Check,
): Promise<void> {
  const [path = "", fragment] = file.split("#");
  const url = pathToFileURL(path).href + (fragment ? `#${fragment}` : "");
  const address = { url, isOwn: (asked: string) => asked.startsWith("file:") };
  await onPageAt(browser, address, { viewport: { width: 1280, height: 900 }, ...options }, check);
}

/** How many pixels of what `selector` shows are colored, as the robot's limbs are. */
async function colorfulPixels(page: Page, selector: string): Promise<number> {
  const png = await page.locator(selector).screenshot();
  return page.evaluate(async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    if (!context) return 0;
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    let colorful = 0;
    for (let i = 0; i < data.length; i += 4) {
      const [r = 0, g = 0, b = 0] = data.subarray(i, i + 3);
      if (Math.max(r, g, b) - Math.min(r, g, b) > 60) ++colorful;
    }
    return colorful;
  }, png.toString("base64"));
}

const secondsOf = async (page: Page): Promise<number> =>
  Number.parseFloat(await textOf(page, "#clock"));

const showsTheRun: Check = async (page) => {
  assert.ok(await page.locator("#evaluations-section").isHidden());
  assert.equal(await textOf(page, "h1"), "crawling");
  assert.match(await textOf(page, "#agent-words"), /Q\(λ\)/);
  assert.match(await textOf(page, "#settings"), /^task\.fall_penalty = 8\.0trainer train tasks/);
  assert.ok((await page.locator("#figures .figure").count()) === 4);
  assert.equal(await page.locator("#curve canvas").count(), 1);
  assert.equal(await page.locator("#term-legend button").count(), 3);
  assert.equal(await page.locator("#metrics canvas").count(), 2);
  assert.equal(await page.locator("#logs canvas").count(), 1);
  assert.equal(await page.locator("#learner canvas").count(), 1);
  assert.match(await textOf(page, "#learner output"), /^episode .*: \d/);
  assert.match(await textOf(page, "#logs h3"), /^speed \[m\/s\]$/);
  assert.match(await textOf(page, "#sources details[open]"), /task crawling for humanoid/);
  assert.equal(await page.locator("#sources details").count(), 2);
};

const drawsTheStrip: Check = async (page) => {
  assert.equal(await page.locator("#strip button").count(), 8);
  for (let i = 1; i <= 8; ++i) {
    const pixels = await colorfulPixels(page, `#strip li:nth-child(${i}) canvas`);
    assert.ok(pixels > 500, `snapshot ${i} shows the robot`);
  }
  await page.locator("#strip button").nth(7).click();
  const duration = Number(await page.locator("#scrub").getAttribute("max"));
  assert.ok(Math.abs((await secondsOf(page)) - duration) < 0.01);
};

const playsByKeys: Check = async (page) => {
  await page.keyboard.press("Home");
  assert.equal(await secondsOf(page), 0);
  await page.keyboard.press("ArrowRight");
  assert.equal(await secondsOf(page), 0.02);
  await page.keyboard.press("Space");
  await page.locator('#play[data-state="playing"]').waitFor();
  await page.waitForFunction(
    () => Number.parseFloat(document.querySelector("#clock")?.textContent ?? "") > 0.1,
  );
  await page.keyboard.press("Space");
  await page.locator('#play[data-state="paused"]').waitFor();
};

const playsUnseen: Check = async (page) => {
  await page.keyboard.press("Home");
  await page.keyboard.press("Space");
  await isDrawnInSightOnly(page);
  await page.keyboard.press("End");
  await page.locator('#play[data-state="paused"]').waitFor();
};

const scrubs: Check = async (page) => {
  await page.locator("#scrub").fill("4");
  assert.equal(await secondsOf(page), 4);
};

const replaysAMark: Check = async (page) => {
  const mark = page.locator(".mark").first();
  await mark.click();
  assert.equal(await mark.getAttribute("aria-pressed"), "true");
  assert.equal(await page.locator("#recording").inputValue(), "0");
  await page.locator('#play[data-state="playing"]').waitFor();
  await page.keyboard.press("Space");
  await page.locator('#play[data-state="paused"]').waitFor();
};

const showsValuesOfAnEpisode: Check = async (page) => {
  await page.locator("#curve").focus();
  await page.keyboard.press("ArrowLeft");
  assert.match(await textOf(page, "#curve-readout"), /^Episode \d+ {2}· {2}return/);
};

const hidesATerm: Check = async (page) => {
  const term = page.locator("#term-legend button").first();
  await term.click();
  assert.equal(await term.getAttribute("aria-pressed"), "false");
  await term.click();
};

const showsNoChanges: Check = async (page) => {
  assert.ok(await page.locator("#history-section").isHidden());
  assert.equal(await page.locator(".change").count(), 0);
};

const showsChangesAndShadows: Check = async (page) => {
  const marks = page.locator("#curve .change");
  assert.equal(await marks.count(), 3); // four changes, two of them in one place
  const label = marks.nth(2).locator(".label");
  assert.ok(await label.isHidden());
  await marks.nth(2).hover();
  assert.ok(await label.isVisible());
  assert.match((await label.textContent()) ?? "", /swap task: .*careful.*\n.*task\.weight/);
  for (const chart of ["#terms", "#metrics article:first-child", "#logs article:first-child"]) {
    assert.equal(await page.locator(`${chart} .change`).count(), 3, chart);
  }
  assert.equal(await page.locator("#history tbody tr").count(), 4 + 2);
  const differences = page.locator("#history .difference"); // of the shadow, and of the swap
  assert.equal(await differences.count(), 2);
  assert.match((await differences.nth(1).textContent()) ?? "", /time > 30 s/);
  assert.match(await textOf(page, "#curve-key"), /shadow careful/);
  await page.locator("#curve").focus();
  await page.keyboard.press("ArrowLeft");
  assert.match(await textOf(page, "#curve-readout"), /careful /);
};

const showsWhatTheRobotWasTold: Check = async (page) => {
  assert.equal(await page.locator("#goals canvas").count(), 2);
  assert.match(await textOf(page, "#goals article:first-child h3"), /^heading\.x$/);
  await page.locator("#scrub").fill("0");
  await page.locator("#told", { hasText: "heading 0.6, 0.8" }).waitFor();
  await page.locator("#scrub").fill("3");
  await page.locator("#told", { hasText: "heading 1, 0" }).waitFor();
};

const cutsNoTable: Check = async (page) => {
  const hidden = await page
    .locator("#history .scroll, #evaluations .scroll")
    .evaluateAll((tables) => tables.map((table) => table.scrollWidth - table.clientWidth));
  assert.deepEqual(hidden, [0, 0, 0]);
};

/** "−4 000 000" is longer than the room that charts leave of themselves. */
const cutsNoNumberOnAnAxis: Check = async (page) => {
  const plot = page.locator("#metrics article", { hasText: "work [J]" }).locator(".u-over");
  const room = await plot.evaluate((element) => (element as HTMLElement).offsetLeft);
  assert.ok(room > 60, `${room} px`);
};

const showsWhatRemains: Check = async (page) => {
  assert.match(
    await textOf(page, "#evaluations tbody"),
    /paper-tree80 %10\.007\.516 … 12\.4812\.504001 failure, 2 truncated/,
  );
};

const showsAStudy: Check = async (page) => {
  assert.equal(await page.locator("#overview tbody tr").count(), 2);
  assert.match(await textOf(page, "#overview"), /task\.fall_penalty = 8\.0/);
  assert.match(await textOf(page, "#experiment-1 header"), /--seed 1 --runs 8/);
  assert.equal(await page.locator(".experiment .chart canvas").count(), 2);
  assert.equal(await page.locator("#experiment-1 .group").count(), 2);
  assert.match(await textOf(page, "#experiment-1 .group:nth-child(2)"), /Crawls fast\./);
  assert.match(await textOf(page, "#experiment-1 .group:nth-child(1)"), /5 of 7 runs, 71 %/);
  assert.match(await textOf(page, "#experiment-1 .group:nth-child(1)"), /groups\.toml/);
  assert.match(await textOf(page, "#experiment-2"), /No finished run has a recording/);
  assert.equal(await page.locator("#experiment-1 .runs-table tbody tr").count(), 8);
};

const comparesTheExperiments: Check = async (page) => {
  const compared = "#comparison .first-row tbody";
  const means = (): Promise<string[]> =>
    page.locator(`${compared} td:nth-child(3)`).allTextContents();
  assert.equal(await page.locator(`${compared} tr`).count(), 2 + 1); // and the axis
  const final = await page.locator("#overview tbody tr td:nth-child(3)").allTextContents();
  const returns = await means();
  assert.equal(returns[0], final[0]);
  const readout = page.locator("#comparison .readout");
  const last = async (): Promise<string> => {
    await page.locator("#comparison .chart").focus();
    await page.keyboard.press("ArrowLeft");
    return (await readout.textContent()) ?? "";
  };
  assert.equal(await last(), `Episode 40  ·  crawling ${returns[0]}  ·  careful ${returns[1]}`);
  await page.locator("#compared").selectOption("distance [m]");
  assert.notDeepEqual(await means(), returns);
  assert.ok((await last()).endsWith(`careful ${(await means())[1]}`));
  const figure = page.locator("#experiment-1 .figure", { hasText: "distance [m]" });
  const shown = await page.locator(`${compared} tr:first-child td:nth-child(3)`).textContent();
  assert.equal(await figure.locator(".number").textContent(), shown);
  await page.locator("#comparison .switches button").first().click();
  assert.ok(!(await last()).includes("crawling"));
  await page.locator("#comparison .switches button").first().click();
};

const putsTermsSideBySide: Check = async (page) => {
  const rows = page.locator("#comparison .side-by-side tbody tr");
  assert.equal(await rows.count(), 3 * 2 + 1); // and the axis
  const paid = await page.locator("#experiment-2 .terms-table td:nth-child(4)").first().textContent();
  assert.equal(await rows.nth(1).locator("td:nth-child(4)").textContent(), paid);
};

const drawsTheGroups: Check = async (page) => {
  const group = page.locator("#experiment-1 .group").nth(1);
  await group.scrollIntoViewIfNeeded();
  const strip = "#experiment-1 .group:nth-child(2) .snapshots";
  assert.ok((await colorfulPixels(page, `${strip} img`)) > 8 * 300, "the robot is drawn");
  assert.equal(await page.locator(`${strip} li`).count(), 8);
  await group.locator(".group-head").click();
  assert.equal(await group.locator(".group-head").getAttribute("aria-pressed"), "true");
};

const ordersTheGroups: Check = async (page) => {
  const command = "#experiment-1 .preferences code";
  assert.match(await textOf(page, command), /^trainer prefer \S+ --order crawling\/seed\d \S+$/);
  const before = await textOf(page, command);
  const down = page.locator("#experiment-1 .order").getByLabel("Group A is worse");
  await down.focus();
  await page.keyboard.press("Enter");
  assert.notEqual(await textOf(page, command), before);
  assert.match(await textOf(page, "#experiment-1 .order li:first-child"), /Group B/);
  assert.ok(await down.isDisabled());
  await page.keyboard.press("Enter"); // the focus is on the way back
  assert.equal(await textOf(page, command), before);
  const tick = page.locator("#experiment-1 .order li:first-child input");
  await tick.uncheck();
  assert.equal(await textOf(page, command), "–"); // one alone is no order
  await tick.check();
  assert.equal(await textOf(page, command), before);
};

const replaysAGroup: Check = async (page) => {
  await page.locator("#experiment-1 .group button.text").first().click();
  await page.locator('#play[data-state="playing"]').waitFor();
  assert.match(await textOf(page, "#replay-heading"), /crawling, group A: seed \d, episode 40/);
  assert.ok((await colorfulPixels(page, "#stage canvas")) > 2000, "the robot is drawn");
  await replaysTwoGroups(page);
  await screenshot("study-replay")(page);
  await page.locator("#close").click();
  assert.ok(await page.locator("#stage").isHidden());
};

const showsWhatATaskPaysFor: Check = async (page) => {
  assert.equal(await textOf(page, "h1"), "What crawling pays for");
  const finds = page.locator(".find");
  assert.equal(await finds.count(), 3);
  assert.match(await textOf(page, ".find:nth-of-type(2)"), /found by 2 of 4 searches/);
  assert.equal(await page.locator(".astray").count(), 1);
  assert.match(await textOf(page, ".find:nth-of-type(3) .astray"), /a speed of 13\.\d m\/s/);
  assert.equal(await finds.first().locator(".terms-table tbody tr").count(), 2);
  const picture = ".find:nth-of-type(1) .snapshots img";
  assert.ok((await colorfulPixels(page, picture)) > 8 * 300, "the robot is drawn");
};

const replaysAFind: Check = async (page) => {
  await page.locator(".find button.text").first().click();
  await page.locator('#play[data-state="playing"]').waitFor();
  assert.match(await textOf(page, "#replay-heading"), /^A: seed 3, episode 40$/);
  await page.locator("#close").click();
  assert.ok(await page.locator("#stage").isHidden());
};

const staysAtRest: Check = async (page) => {
  await page.locator(".mark").first().click();
  const opening = await secondsOf(page);
  await page.waitForTimeout(200);
  assert.equal(await secondsOf(page), opening);
  assert.equal(await page.locator("#play").getAttribute("data-state"), "paused");
};

const opensOnATellingFrame: Check = async (page) => {
  assert.ok((await secondsOf(page)) > 1);
  await page.keyboard.press("Space"); // and yet plays from the start
  await page.locator('#play[data-state="playing"]').waitFor();
  await page.keyboard.press("Space");
  await page.locator('#play[data-state="paused"]').waitFor();
  assert.ok((await secondsOf(page)) < 1);
};

interface PaidUpTo {
  returned: number;
  terms: { name: string; paid: number; sum: number }[];
  metrics: { name: string; value: number }[];
}

/** What the data of the page says of the shown recording at sample number `sample`, or at its end. */
const paidUpTo = (page: Page, sample: number | null): Promise<PaidUpTo> =>
  page.evaluate((wanted) => {
    const data = JSON.parse(document.querySelector("#report-data")?.textContent ?? "");
    const chosen = (document.querySelector("#recording") as HTMLSelectElement).value;
    const { timeline } = data.recordings[Number(chosen)];
    const values = (text: string): number[] => {
      const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      return [...new Float32Array(bytes.buffer)];
    };
    const at = (text: string): number => wanted ?? values(text).length - 1;
    const sum = (text: string): number =>
      values(text)
        .slice(0, at(text) + 1)
        .reduce((a, b) => a + b, 0);
    return {
      returned: sum(timeline.returns),
      terms: timeline.terms.map((term: { name: string; values: string }) => ({
        name: term.name,
        paid: values(term.values)[at(term.values)],
        sum: sum(term.values),
      })),
      metrics: timeline.metrics.map((metric: { name: string; values: string }) => ({
        name: metric.name,
        value: values(metric.values)[at(metric.values)],
      })),
    };
  }, sample);

const numberIn = (text: string | null): number =>
  Number((text ?? "").replace("\u2212", "-").replace(/[\u202f+]/g, ""));

/** `shown` has the digits that the page shows of `value`. */
function equalsShown(shown: string | null, value: number, what: string): void {
  const difference = Math.abs(numberIn(shown) - value);
  assert.ok(difference <= Math.max(6e-4, 6e-4 * Math.abs(value)), `${what}: ${shown}, ${value}`);
}

async function showsWhatTheDataSays(page: Page, sample: number | null): Promise<void> {
  const expected = await paidUpTo(page, sample);
  const row = (kind: string, index: number) =>
    page.locator(`.timeline .label[data-kind="${kind}"]`).nth(index);
  equalsShown(await row("return", 0).locator(".sum").textContent(), expected.returned, "return");
  for (const [i, { name, paid, sum }] of expected.terms.entries()) {
    assert.equal(await row("term", i).locator(".name").textContent(), name);
    equalsShown(await row("term", i).locator(".now").textContent(), paid, name);
    equalsShown(await row("term", i).locator(".sum").textContent(), sum, name);
  }
  for (const [i, { name, value }] of expected.metrics.entries()) {
    equalsShown(await row("metric", i).locator(".now").textContent(), value, name);
  }
}

const showsWhatEachStepPaid: Check = async (page) => {
  await page.keyboard.press("End");
  await showsWhatTheDataSays(page, null);
  const end = await textOf(page, "#timeline-now");
  assert.match(end, /truncated: time is up|failure: falls too often/);
  const option = await page.locator("#recording option:checked").textContent();
  const returned = /return (\S+?),? /.exec(`${option} `)?.[1] ?? "";
  assert.match(end, new RegExp(`return ${returned.replace(".", "\\.")}`));
  await page.locator("#scrub").fill("4");
  await showsWhatTheDataSays(page, 200);
};

const lightsTheLinesThatPay: Check = async (page) => {
  await page.locator("#scrub").fill("4");
  const lit = page.locator("#timeline-source .lit");
  assert.match((await lit.first().textContent()) ?? "", /reward rate forward =/);
  const paid = await lit.first().getAttribute("data-paid");
  const row = page.locator('.timeline .label[data-kind="term"] .now').first();
  assert.equal(await row.textContent(), paid);
};

const jumpsToAClickOnATrace: Check = async (page) => {
  const plot = page.locator(".timeline .plot");
  await plot.scrollIntoViewIfNeeded();
  const box = await plot.boundingBox();
  assert.ok(box);
  await plot.click({ position: { x: box.width / 4, y: 20 } });
  const duration = Number(await page.locator("#scrub").getAttribute("max"));
  assert.ok(Math.abs((await secondsOf(page)) - duration / 4) < 0.1);
  const cursor = await page.locator(".timeline .cursor").boundingBox();
  assert.ok(Math.abs((cursor?.x ?? 0) - (box.x + box.width / 4)) < 3);
  await page.waitForFunction(() => /^#episode=\d+&t=/.test(location.hash)); // the link to it
};

/** The first tap on a mark reads, the second one replays. */
const readsATap: Check = async (page) => {
  const mark = page.locator(".mark").first();
  await mark.tap();
  assert.match(await textOf(page, "#curve-readout"), /^Episode \d+ .*replay$/);
  assert.equal(await mark.getAttribute("aria-pressed"), "false");
  await mark.tap();
  assert.equal(await mark.getAttribute("aria-pressed"), "true");
};

const saysThatNothingIsRecorded: Check = async (page) => {
  assert.match(await textOf(page, "#stage-message"), /No episode has been recorded/);
  assert.equal(await page.locator("#curve canvas").count(), 1);
  assert.ok(await page.locator("#strip").isHidden());
  assert.ok(await page.locator("#timeline").isHidden());
};

const saysThatWebGlIsMissing: Check = async (page) => {
  assert.match(await textOf(page, "#stage-message"), /no WebGL/);
  assert.equal(await page.locator("#curve canvas").count(), 1);
  assert.ok(await page.locator("#play").isHidden());
  assert.ok(await page.locator("#strip").isHidden());
  await page.locator(".timeline .plot").click({ position: { x: 100, y: 20 } }); // without a replay
  assert.match(await textOf(page, "#timeline-now"), /^\s*[1-9]/);
};

const takePicture = screenshotsIn(screenshots);
const screenshot =
  (name: string): Check =>
  (page) =>
    takePicture(page, name, true);

async function checkFullPage(browser: Browser): Promise<void> {
  await onPage(browser, fullPage, { colorScheme: "light" }, async (page) => {
    assert.ok((await colorfulPixels(page, "#stage canvas")) > 2000, "the robot is drawn");
    await screenshot("light")(page);
    await opensOnATellingFrame(page);
    const timeline = [showsWhatEachStepPaid, lightsTheLinesThatPay, jumpsToAClickOnATrace];
    for (const check of timeline) await check(page);
    const replays = [drawsTheStrip, playsByKeys, playsUnseen, scrubs, replaysAMark];
    const views = [drawsWhatIsSwitchedOn, showsTheJointsOfALink, picksALinkByAClick, replaysTwoInStep, savesAFilm];
    const charts = [savesItsCharts, showsValuesOfAnEpisode, hidesATerm, showsNoChanges];
    for (const check of [showsTheRun, ...views, ...replays, ...charts, fitsItsWidth]) await check(page);
    await hasNoSeriousFault(page);
  });
  await onPage(browser, fullPage, { colorScheme: "dark" }, async (page) => {
    await screenshot("dark")(page);
    await hasNoSeriousFault(page);
  });
  await onPage(browser, fullPage, { reducedMotion: "reduce" }, staysAtRest);
  const phone = { viewport: { width: 390, height: 844 }, hasTouch: true };
  await onPage(browser, fullPage, phone, async (page) => {
    await screenshot("narrow")(page);
    await fitsItsWidth(page);
    await hasNoSeriousFault(page);
    await readsATap(page);
  });
  await onPage(browser, `${fullPage}#episode=800&t=3`, { reducedMotion: "reduce" }, async (page) => {
    assert.equal(await secondsOf(page), 3);
    assert.match((await page.locator("#recording option:checked").textContent()) ?? "", /^800 /);
  });
}

async function checkStudyPage(browser: Browser): Promise<void> {
  await onPage(browser, studyPage, { colorScheme: "light" }, async (page) => {
    for (const check of [showsAStudy, comparesTheExperiments, putsTermsSideBySide, drawsTheGroups, ordersTheGroups, replaysAGroup, fitsItsWidth]) {
      await check(page);
    }
    await screenshot("study")(page);
    await hasNoSeriousFault(page);
  });
  await onPage(browser, studyPage, { colorScheme: "dark" }, async (page) => {
    await screenshot("study-dark")(page);
    await hasNoSeriousFault(page);
  });
  await onPage(browser, studyPage, { viewport: { width: 390, height: 844 } }, async (page) => {
    await screenshot("study-narrow")(page);
    await fitsItsWidth(page);
    await hasNoSeriousFault(page);
  });
}

async function checkProbePage(browser: Browser): Promise<void> {
  await onPage(browser, probePage, { colorScheme: "light" }, async (page) => {
    for (const check of [showsWhatATaskPaysFor, replaysAFind, fitsItsWidth]) await check(page);
    await screenshot("probe")(page);
  });
  await onPage(browser, probePage, { colorScheme: "dark" }, screenshot("probe-dark"));
  await onPage(browser, probePage, { viewport: { width: 390, height: 844 } }, async (page) => {
    await screenshot("probe-narrow")(page);
    await fitsItsWidth(page);
  });
}

await inBrowser(async (browser) => {
  await checkFullPage(browser);
  await onPage(browser, firstPage, {}, saysThatNothingIsRecorded);
  await onPage(browser, tunedPage, {}, async (page) => {
    const checks = [
      showsWhatTheRobotWasTold,
      showsChangesAndShadows,
      showsWhatRemains,
      cutsNoTable,
    ];
    for (const check of checks) await check(page);
    await cutsNoNumberOnAnAxis(page);
    await page.locator("#curve .change").nth(2).hover();
    await screenshot("tuned")(page);
    await fitsItsWidth(page);
  });
  await onPage(browser, tunedPage, { viewport: { width: 390, height: 844 } }, async (page) => {
    await screenshot("tuned-narrow")(page);
    await fitsItsWidth(page);
  });
  await checkStudyPage(browser);
  await checkProbePage(browser);
});
await inBrowser(async (browser) => {
  await onPage(browser, fullPage, {}, async (page) => {
    await saysThatWebGlIsMissing(page);
    await screenshot("without-webgl")(page);
  });
}, ["--disable-3d-apis"]);
