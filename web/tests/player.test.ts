import assert from "node:assert/strict";
import { test } from "node:test";

import { Player } from "../src/replay/player.ts";

function loaded(duration: number): Player {
  const player = new Player();
  player.load(duration);
  return player;
}

test("time passes only while it plays, as fast as it is told", () => {
  const player = loaded(10);
  player.advance(1);
  assert.equal(player.time, 0);
  player.play();
  player.advance(1);
  player.setSpeed(0.5);
  player.advance(1);
  assert.equal(player.time, 1.5);
});

test("it stops at the end and starts over from there", () => {
  const player = loaded(2);
  player.play();
  player.advance(5);
  assert.deepEqual([player.time, player.playing], [2, false]);
  player.toggle();
  assert.deepEqual([player.time, player.playing], [0, true]);
});

test("seeking stays within the episode and does not pause", () => {
  const player = loaded(2);
  player.play();
  player.seek(7);
  assert.deepEqual([player.time, player.playing], [2, true]);
  player.seek(-1);
  assert.equal(player.time, 0);
});

test("another episode starts paused at 0", () => {
  const player = loaded(2);
  player.play();
  player.advance(1);
  player.load(3);
  assert.deepEqual([player.time, player.playing, player.duration], [0, false, 3]);
});

test("nothing to play is not played", () => {
  const player = loaded(0);
  player.play();
  assert.equal(player.playing, false);
});

test("every change is told", () => {
  const player = loaded(2);
  let changes = 0;
  player.onChange(() => ++changes);
  player.play();
  player.advance(0.5);
  player.pause();
  assert.equal(changes, 3);
});

test("it opens where it is told, and yet plays from the start", () => {
  const player = new Player();
  player.load(10, 4);
  assert.equal(player.time, 4);
  assert.ok(player.untouched);
  player.play();
  assert.equal(player.time, 0);
  player.load(10, 4);
  player.seek(6);
  assert.ok(!player.untouched);
  player.play();
  assert.equal(player.time, 6);
});
