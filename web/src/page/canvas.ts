// Canvases as sharp as the screen, and small pictures of numbers on them.

import { themeColor } from "./dom.ts";

/** Ready to draw in CSS pixels on what is empty now; undefined while the canvas has no size. */
export function clearedContext(
  canvas: HTMLCanvasElement,
  width = canvas.clientWidth,
  height = canvas.clientHeight,
): CanvasRenderingContext2D | undefined {
  if (width === 0 || height === 0) return undefined;
  const scale = window.devicePixelRatio;
  const [wide, high] = [Math.round(width * scale), Math.round(height * scale)];
  if (canvas.width !== wide || canvas.height !== high) [canvas.width, canvas.height] = [wide, high];
  const context = canvas.getContext("2d") as CanvasRenderingContext2D;
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}

/** The values as a line over the whole canvas; those that are not finite are left out. */
export function drawSparkline(canvas: HTMLCanvasElement, values: (number | null)[]): void {
  const context = clearedContext(canvas);
  if (!context) return;
  const { clientWidth: width, clientHeight: height } = canvas;
  const finite = values.filter((value): value is number => value !== null && Number.isFinite(value));
  const [low, high] = [Math.min(...finite), Math.max(...finite)];
  context.strokeStyle = themeColor("--accent");
  context.lineWidth = 1.4;
  context.lineJoin = "round";
  context.beginPath();
  finite.forEach((value, i) => {
    const x = (width * i) / Math.max(1, finite.length - 1);
    const y = high > low ? 2 + ((high - value) / (high - low)) * (height - 4) : height / 2;
    if (i === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  context.stroke();
}
