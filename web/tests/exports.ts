// Reads what `trainer export` has written of a made-up run with decoders that are not ours.
//
//   node exports.mjs RUN.csv EVENTS EPISODE.mcap
import assert from "node:assert/strict";
import { open, readFile } from "node:fs/promises";
import { McapIndexedReader } from "@mcap/core";
import { decompress } from "fzstd";
import protobuf from "protobufjs";
import { RecordReader } from "tfrecord";

const [csvFile = "", eventFile = "", mcapFile = ""] = process.argv.slice(2);

const lines = (await readFile(csvFile, "utf8")).trimEnd().split("\n");
const names = lines[0]!.split(",");
const rows = lines.slice(1).map((line) => line.split(","));

// Each event has the numbers of the episode's line.
const eventType = protobuf.parse(`
  syntax = "proto3";
  message Summary { message Value { string tag = 1; float simple_value = 2; } repeated Value value = 1; }
  message Event { double wall_time = 1; int64 step = 2; string file_version = 3; Summary summary = 5; }
`).root.lookupType("Event");
interface Event {
  wallTime: number;
  step?: number;
  fileVersion?: string;
  summary?: { value: { tag: string; simpleValue: number }[] };
}
const events: Event[] = [];
const records = await RecordReader.create(eventFile); // throws where a checksum is wrong
for (let record = await records.readRecord(); record; record = await records.readRecord()) {
  events.push(eventType.toObject(eventType.decode(record), { longs: Number, defaults: true }) as Event);
}
await records.close();
assert.equal(events[0]!.fileVersion, "brain.Event:2");
assert.equal(events.length, rows.length + 1);
for (const [index, row] of rows.entries()) {
  const event = events[index + 1]!;
  assert.equal(event.step, Number(row[0]));
  assert.ok(event.wallTime >= events[index]!.wallTime);
  const values = new Map(event.summary!.value.map((value) => [value.tag, value.simpleValue]));
  for (const [column, name] of names.entries()) {
    if (["episode", "end", "reason"].includes(name)) continue;
    const text = row[column]!;
    assert.equal(values.get(name), text === "" ? undefined : Math.fround(Number(text)), name);
  }
}

// The file of an episode: every chunk's checksum and index is looked at, too.
const handle = await open(mcapFile);
const { size } = await handle.stat();
const reader = await McapIndexedReader.Initialize({
  readable: {
    size: async () => BigInt(size),
    read: async (offset: bigint, length: bigint) => {
      const bytes = new Uint8Array(Number(length));
      await handle.read(bytes, 0, Number(length), Number(offset));
      return bytes;
    },
  },
  decompressHandlers: { zstd: (bytes: Uint8Array) => decompress(bytes) },
});
const topics = new Map([...reader.channelsById.values()].map((channel) => [channel.id, channel.topic]));
const messages = new Map<string, { time: bigint; content: any }[]>();
let last = 0n;
for await (const message of reader.readMessages()) {
  assert.ok(message.logTime >= last);
  last = message.logTime;
  const topic = topics.get(message.channelId)!;
  const content = JSON.parse(new TextDecoder().decode(message.data));
  messages.set(topic, [...(messages.get(topic) ?? []), { time: message.logTime, content }]);
}
for await (const metadata of reader.readMetadata({ name: "run" })) {
  assert.equal(metadata.metadata.get("task"), "crawling");
}
await handle.close();
const links = messages.get("/robot")![0]!.content.entities.map((entity: any) => entity.id);
assert.ok(links.includes("body") && links.includes("left_foot"));
const frames = messages.get("/tf")!;
assert.equal(reader.statistics!.messageCount, BigInt([...messages.values()].flat().length));
assert.equal(frames[1]!.time - frames[0]!.time, 20_000_000n);
for (const { content } of frames) {
  assert.deepEqual(content.transforms.map((transform: any) => transform.child_frame_id), links);
  for (const { rotation: q } of content.transforms) {
    assert.ok(Math.abs(Math.hypot(q.x, q.y, q.z, q.w) - 1) < 1e-6);
  }
}
const end = messages.get("/episode")![0]!.content;
const episode = rows.find((row) => Number(row[3]) === end.return);
assert.ok(episode, "the episode's return is in the table");
assert.equal(Number(episode[names.indexOf("term/forward")]), end.terms.forward);
console.log(`${rows.length} episodes and ${frames.length} frames read`);
