// Left and right limbs look different.

export type Side = "left" | "right" | "trunk";

/** Which side a link is on, by its name. */
export function sideOf(name: string): Side {
  if (/(^|_)left(_|$)/.test(name)) return "left";
  if (/(^|_)right(_|$)/.test(name)) return "right";
  return "trunk";
}
