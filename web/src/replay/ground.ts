// The floor: a grid with distance marks, a plane for the shadow, and the base's path.

import {
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  Color,
  Group,
  Line,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  ShadowMaterial,
  SRGBColorSpace,
  Vector3,
} from "three";

import { themeColor } from "../page/dom.ts";
import type { Terrain } from "./terrain.ts";

const kFineLines = 5; // between two strong lines
const kMargin = 6; // of the grid around the path, in strong lines
const kLabelHeight = 0.11; // in distances between strong lines
const kSpacings = [0.1, 0.2, 0.5, 1, 2, 5, 10]; // that strong lines may have [m]
const kLeastSpacing = 1.5; // in radii of the robot

interface Extent {
  low: [number, number];
  high: [number, number];
}

/** Between two strong lines, and two marks, of a floor for a robot of this radius [m]. */
export const spacingFor = (radius: number): number =>
  kSpacings.find((spacing) => spacing >= kLeastSpacing * radius) ?? (kSpacings.at(-1) as number);

/** The part of the floor around `path` ([point][x, y]), in whole cells of strong lines. */
function extentOf(path: Float32Array, spacing: number): Extent {
  const extent: Extent = { low: [0, 0], high: [0, 0] };
  for (let i = 0; i < path.length; ++i) {
    const axis = (i % 2) as 0 | 1;
    extent.low[axis] = Math.min(extent.low[axis], path[i] as number);
    extent.high[axis] = Math.max(extent.high[axis], path[i] as number);
  }
  for (const axis of [0, 1] as const) {
    extent.low[axis] = (Math.floor(extent.low[axis] / spacing) - kMargin) * spacing;
    extent.high[axis] = (Math.ceil(extent.high[axis] / spacing) + kMargin) * spacing;
  }
  return extent;
}

const isMultiple = (value: number, of: number): boolean =>
  of > 0 && Math.abs(value / of - Math.round(value / of)) < 1e-6;

/**
 * Lines along x and y every `spacing`; those on a multiple of `except` are left to others. They are
 * made of pieces of this length, since some renderers drop lines that reach behind the camera.
 */
function gridLines(
  extent: Extent,
  spacing: number,
  except: number,
  length: number,
): BufferGeometry {
  const points: number[] = [];
  for (const axis of [0, 1] as const) {
    const other = (1 - axis) as 0 | 1;
    const lines = Math.round((extent.high[axis] - extent.low[axis]) / spacing);
    const pieces = Math.round((extent.high[other] - extent.low[other]) / length);
    for (let line = 0; line <= lines; ++line) {
      const place = extent.low[axis] + line * spacing;
      if (isMultiple(place, except)) continue;
      for (let piece = 0; piece < pieces; ++piece) {
        const from = extent.low[other] + piece * length;
        if (axis === 0) points.push(place, from, 0, place, from + length, 0);
        else points.push(from, place, 0, from + length, place, 0);
      }
    }
  }
  const positions = new BufferAttribute(new Float32Array(points), 3);
  return new BufferGeometry().setAttribute("position", positions);
}

/** A flat label on the floor, `height` m high, read with +x to the right. */
function label(text: string, color: string, height: number): Mesh {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d") as CanvasRenderingContext2D;
  const font = "500 64px system-ui, sans-serif";
  context.font = font;
  canvas.width = Math.ceil(context.measureText(text).width) + 8;
  canvas.height = 80;
  context.font = font;
  context.fillStyle = color;
  context.textBaseline = "middle";
  context.fillText(text, 4, 42);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 8;
  const plane = new PlaneGeometry((height * canvas.width) / canvas.height, height);
  return new Mesh(
    plane,
    new MeshBasicMaterial({ map: texture, transparent: true, depthWrite: false }),
  );
}

export class Ground {
  readonly object = new Group();
  private readonly pathLine: Line;
  private readonly spacing: number; // of strong lines [m]
  private readonly extent: Extent;

  /** What lies in the plane: drawn level, and turned with it as a whole. */
  private readonly plane = new Group();

  /** `path`: the robot's way over the ground, [frame][x, y]; `radius`: how large it is [m]. */
  constructor(path: Float32Array, radius: number, terrain: Terrain) {
    this.spacing = spacingFor(radius);
    const extent = extentOf(path, this.spacing);
    this.extent = extent;
    this.addGrid(extent);
    this.addLabels(extent);
    this.addShadowPlane(extent);
    this.plane.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...terrain.normal));
    this.object.add(this.plane, terrain.objects());
    this.pathLine = this.addPath(path, terrain);
  }

  /** Shows the path up to this frame. */
  setFrame(frame: number): void {
    this.pathLine.geometry.setDrawRange(0, frame + 1);
  }

  /** Whether the path is shown at all. */
  setTrail(isShown: boolean): void {
    this.pathLine.visible = isShown;
  }

  /** Whether there is ground for a camera that looks at this point. */
  covers(x: number, y: number): boolean {
    const { low, high } = this.extent;
    const room = (kMargin / 2) * this.spacing;
    return x > low[0] + room && x < high[0] - room && y > low[1] + room && y < high[1] - room;
  }

  dispose(): void {
    this.object.traverse((part) => {
      if (!(part instanceof Mesh || part instanceof Line)) return;
      part.geometry.dispose();
      const material = part.material as MeshBasicMaterial | LineBasicMaterial;
      if ("map" in material) material.map?.dispose();
      material.dispose();
    });
  }

  private addGrid(extent: Extent): void {
    const { spacing } = this;
    const fine = new LineBasicMaterial({ color: new Color(themeColor("--floor-fine")) });
    const coarse = new LineBasicMaterial({ color: new Color(themeColor("--floor-coarse")) });
    this.plane.add(
      new LineSegments(gridLines(extent, spacing / kFineLines, spacing, spacing), fine),
      new LineSegments(gridLines(extent, spacing, 0, spacing), coarse),
    );
  }

  /** Distances from the start along both axes, beside their lines. */
  private addLabels(extent: Extent): void {
    const { spacing } = this;
    const color = themeColor("--floor-ink");
    const height = kLabelHeight * spacing;
    const place = (value: number, x: number, y: number): void => {
      const mark = label(`${Number(value.toFixed(1))} m`.replace("-", "\u2212"), color, height);
      mark.position.set(x + 1.1 * height, y + 0.5 * height, 0.0012 * spacing);
      this.plane.add(mark);
    };
    for (let x = extent.low[0]; x <= extent.high[0]; x += spacing) place(x, x, 0);
    for (let y = extent.low[1]; y <= extent.high[1]; y += spacing) {
      if (Math.abs(y) > 1e-6) place(y, 0, y);
    }
  }

  private addShadowPlane(extent: Extent): void {
    const [x0, y0] = extent.low;
    const [x1, y1] = extent.high;
    const opacity = Number(themeColor("--shadow-opacity"));
    const plane = new Mesh(new PlaneGeometry(x1 - x0, y1 - y0), new ShadowMaterial({ opacity }));
    plane.position.set((x0 + x1) / 2, (y0 + y1) / 2, 0.0006 * this.spacing);
    plane.receiveShadow = true;
    this.plane.add(plane);
  }

  private addPath(path: Float32Array, terrain: Terrain): Line {
    const points = new Float32Array((path.length / 2) * 3);
    for (let i = 0; i < path.length / 2; ++i) {
      const [x, y] = [path[2 * i] as number, path[2 * i + 1] as number];
      points.set([x, y, terrain.heightAt(x, y) + 0.002 * this.spacing], 3 * i);
    }
    const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(points, 3));
    const line = new Line(
      geometry,
      new LineBasicMaterial({ color: new Color(themeColor("--accent")) }),
    );
    line.frustumCulled = false;
    this.object.add(line);
    return line;
  }
}
