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
