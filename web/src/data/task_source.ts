// The few things that the page knows about the text of a task; the rest is the compiler's.

/** Where the comment of `line` starts; its length where there is none. Strings are no comments. */
export function commentStart(line: string): number {
  let isInString = false;
  for (let i = 0; i < line.length; ++i) {
    if (line[i] === "\\" && isInString) ++i;
    else if (line[i] === '"') isInString = !isInString;
    else if (!isInString && line.startsWith("//", i)) return i;
  }
  return line.length;
}

/** A statement that pays a reward term. */
export interface RewardLine {
  source: number; // index
  line: number; // index
  term: string;
}

const kReward = /\b(override\s+)?reward\s+(?:(?:rate|potential)\s+)?([A-Za-z_]\w*)\s*=(?!=)/g;

/**
 * Where the texts that a task is made of, its own first, pay their terms. Those of a term that an
 * earlier text overrides are not among them.
 */
export function rewardLines(sources: string[]): RewardLine[] {
  const found: RewardLine[] = [];
  const overridden = new Set<string>();
  sources.forEach((text, source) => {
    const overrides: string[] = [];
    text.split("\n").forEach((content, line) => {
      for (const [, override, term = ""] of content
        .slice(0, commentStart(content))
        .matchAll(kReward)) {
        if (override) overrides.push(term);
        if (!overridden.has(term)) found.push({ source, line, term });
      }
    });
    for (const term of overrides) overridden.add(term);
  });
  return found;
}

/** The first paragraph of the documentation (`///`) in front of the task's name; "" without one. */
export function docOfTask(source: string): string {
  const lines = source.split("\n");
  const task = lines.findIndex((line) => /^task\s/.test(line));
  let first = Math.max(task, 0);
  while (first > 0 && (lines[first - 1] as string).startsWith("///")) --first;
  const words = lines.slice(first, Math.max(task, 0)).map((line) => line.slice(3).trim());
  const end = words.indexOf("");
  return words.slice(0, end < 0 ? words.length : end).join(" ");
}
