// A trainer that serves, for tests of its pages.

import assert from "node:assert/strict";
import { spawn, type ChildProcess } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { kPatience, sleep, type Address } from "./in_browser.ts";

interface Control {
  url: string;
  token: string;
}

export class Trainer {
  private constructor(
    private readonly process: ChildProcess,
    private readonly control: Control,
  ) {}

  /** `words`: after `trainer`; `folder`: that in which it says how to reach it. */
  static async serve(trainer: string, words: string[], folder: string): Promise<Trainer> {
    const process = spawn(trainer, ["serve", ...words, "--quiet"], { stdio: "inherit" });
    const file = join(folder, "control.json");
    for (const end = Date.now() + kPatience; Date.now() < end; await sleep(50)) {
      if (!existsSync(file)) continue;
      return new Trainer(process, JSON.parse(readFileSync(file, "utf8")) as Control);
    }
    process.kill("SIGKILL");
    throw new Error("the trainer does not serve");
  }

  get page(): Address {
    const { host } = new URL(this.control.url);
    return {
      url: `${this.control.url}?token=${this.control.token}`,
      isOwn: (url) => new URL(url).host === host,
    };
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

  kill(): void {
    this.process.kill("SIGKILL");
  }
}

/** A folder for as long as `use` takes. */
export async function inFolder(use: (folder: string) => Promise<void>): Promise<void> {
  const folder = mkdtempSync(join(tmpdir(), "live-"));
  try {
    await use(folder);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
