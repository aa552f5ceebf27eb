// What axe-core finds wrong with a page for those who cannot see it well, or use no mouse.

import assert from "node:assert/strict";
import { createRequire } from "node:module";

import type { AxeResults } from "axe-core";
import type { Page } from "playwright-core";

const kAxe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
const kGrave = ["serious", "critical"];

/** Fails for each serious fault, with the places where it is. */
export async function hasNoSeriousFault(page: Page): Promise<void> {
  await page.addScriptTag({ path: kAxe });
  const { violations } = await page.evaluate(
    () => (globalThis as unknown as { axe: { run: () => Promise<AxeResults> } }).axe.run(),
  );
  const faults = violations
    .filter(({ impact }) => kGrave.includes(impact ?? ""))
    .flatMap(({ id, nodes }) =>
      nodes.map(({ html, any }) => `${id}: ${html.slice(0, 160)}: ${any[0]?.message ?? ""}`),
    );
  assert.deepEqual(faults, []);
}
