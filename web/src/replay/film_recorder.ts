// Saves what the replay shows, from its start to its end, as a film: the browser encodes it while it
// is played.

import { byId } from "../page/dom.ts";
import type { Player } from "./player.ts";

const kPicturesPerSecond = 30;
const kBitsPerSecond = 8e6;
const kAfterTheEnd = 250; // for which the last picture stays [ms]
const kKinds = [
  { type: "video/mp4;codecs=avc1.640028", ending: "mp4" },
  { type: "video/webm;codecs=vp9", ending: "webm" },
  { type: "video/webm", ending: "webm" },
];

/** The kind of film that this browser can write, if any. */
function kindHere(): (typeof kKinds)[number] | undefined {
  if (typeof MediaRecorder === "undefined") return undefined;
  if (!("captureStream" in HTMLCanvasElement.prototype)) return undefined;
  return kKinds.find(({ type }) => MediaRecorder.isTypeSupported(type));
}

function download(parts: Blob[], type: string, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob(parts, { type }));
  link.download = name;
  link.click();
  window.setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

export class FilmRecorder {
  private readonly button = byId("film", HTMLButtonElement);
  private readonly kind = kindHere();
  private readonly picture = document.createElement("canvas");
  private recorder: MediaRecorder | undefined;
  private isEnding = false;

  /** `stages`: what is recorded, side by side; `nameOf`: of the file, without its ending. */
  constructor(
    private readonly player: Player,
    private readonly stages: () => HTMLCanvasElement[],
    private readonly nameOf: () => string,
  ) {
    this.button.hidden = this.kind === undefined;
    this.button.addEventListener("click", () => (this.recorder ? this.end() : this.start()));
    player.onChange(() => this.follow());
  }

  get isRecording(): boolean {
    return this.recorder !== undefined;
  }

  /** Call after each picture. */
  take(): void {
    if (!this.recorder) return;
    const context = this.picture.getContext("2d");
    let x = 0;
    for (const stage of this.stages()) {
      context?.drawImage(stage, x, 0);
      x += stage.width;
    }
  }

  private start(): void {
    if (!this.kind) return;
    const stages = this.stages();
    const even = (length: number): number => length - (length % 2);
    this.picture.width = even(stages.reduce((width, stage) => width + stage.width, 0));
    this.picture.height = even(Math.max(...stages.map(({ height }) => height)));
    const parts: Blob[] = [];
    const { type, ending } = this.kind;
    const stream = this.picture.captureStream(kPicturesPerSecond);
    const settings = { mimeType: type, videoBitsPerSecond: kBitsPerSecond };
    this.recorder = new MediaRecorder(stream, settings);
    this.recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
    const name = this.nameOf();
    this.recorder.addEventListener("stop", () => download(parts, type, `${name}.${ending}`));
    this.isEnding = false;
    this.button.textContent = "end the film";
    this.player.seek(0);
    this.take(); // so that the stream has a picture
    this.recorder.start();
    this.player.play();
  }

  /** The film ends with the episode, or when somebody stops it. */
  private follow(): void {
    if (!this.recorder || this.recorder.state !== "recording" || this.isEnding) return;
    if (this.player.playing || this.player.time === 0) return;
    this.isEnding = true;
    window.setTimeout(() => this.end(), kAfterTheEnd);
  }

  private end(): void {
    this.recorder?.stop();
    this.recorder = undefined;
    this.player.pause();
    this.button.textContent = "save a film";
  }
}
