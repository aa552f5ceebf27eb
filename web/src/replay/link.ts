// Links to a moment of a recorded episode: the fragment of the page's address.

export interface Moment {
  episode: number;
  time: number; // [s]
}

/** "#episode=120&t=3.4" */
export const fragmentOf = ({ episode, time }: Moment): string =>
  `#episode=${episode}&t=${Number(time.toFixed(3))}`;

/** What the fragment of an address says; nothing where it says something else. */
export function momentIn(fragment: string): Moment | undefined {
  const values = new URLSearchParams(fragment.replace(/^#/, ""));
  const episode = Number(values.get("episode") ?? NaN);
  const time = Number(values.get("t") ?? 0);
  return Number.isInteger(episode) && Number.isFinite(time) ? { episode, time } : undefined;
}
