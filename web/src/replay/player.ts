// The replay's clock: where it is, whether it runs, how fast. Knows nothing of pictures.

type Listener = () => void;

export class Player {
  private readonly listeners: Listener[] = [];
  private now = 0;
  private length = 0;
  private running = false;
  private rate = 1;
  private isUntouched = true; // still where it was opened

  /** Called after every change. */
  onChange(listener: Listener): void {
    this.listeners.push(listener);
  }

  get time(): number {
    return this.now;
  }
  get duration(): number {
    return this.length;
  }
  get playing(): boolean {
    return this.running;
  }
  /** Whether it still stands where it was opened. */
  get untouched(): boolean {
    return this.isUntouched;
  }
  get speed(): number {
    return this.rate;
  }

  /** Another episode of `duration` seconds, opened at a time which is not where it plays from. */
  load(duration: number, opening = 0): void {
    this.length = duration;
    this.now = Math.min(Math.max(opening, 0), duration);
    this.isUntouched = true;
    this.running = false;
    this.changed();
  }

  /** Of the same replay, with another beside it. */
  setDuration(duration: number): void {
    this.length = duration;
    this.now = Math.min(this.now, duration);
    this.changed();
  }

  /** From the start where the end has been reached, or nobody has chosen a time. */
  play(): void {
    if (this.isUntouched || this.now >= this.length) this.now = 0;
    this.isUntouched = false;
    this.running = this.length > 0;
    this.changed();
  }

  pause(): void {
    this.running = false;
    this.changed();
  }

  toggle(): void {
    if (this.running) this.pause();
    else this.play();
  }

  seek(time: number): void {
    this.isUntouched = false;
    this.now = Math.min(Math.max(time, 0), this.length);
    this.changed();
  }

  setSpeed(speed: number): void {
    this.rate = speed;
    this.changed();
  }

  /** `seconds` of the viewer's time have passed. Stops at the end. */
  advance(seconds: number): void {
    if (!this.running) return;
    this.now = Math.min(this.now + seconds * this.rate, this.length);
    if (this.now >= this.length) this.running = false;
    this.changed();
  }

  private changed(): void {
    for (const listener of this.listeners) listener();
  }
}
