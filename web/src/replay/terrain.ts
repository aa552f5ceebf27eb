// The ground that is not flat: how high it is, and stairs and hills to look at.

import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Color,
  Group,
  Mesh,
  MeshStandardMaterial,
} from "three";

import type { GroundShape } from "../data/report_data.ts";
import { themeColor } from "../page/dom.ts";

const kFlat: GroundShape = { normal: [0, 0, 1], blocks: [] };
const kWidth = 6; // of stairs, of which only a part is drawn [m]
const kLastTread = 6; // likewise [m]

export class Terrain {
  private readonly shape: GroundShape;

  /** Runs of before there were worlds have no ground of their own. */
  constructor(shape: GroundShape | undefined) {
    this.shape = shape ?? kFlat;
  }

  /** Of the plane through the origin. */
  get normal(): [number, number, number] {
    return this.shape.normal;
  }

  heightAt(x: number, y: number): number {
    const [nx, ny, nz] = this.shape.normal;
    let height = 0 - (nx * x + ny * y) / nz;
    for (const block of this.shape.blocks) {
      if (block.low_x <= x && x < block.high_x) height = Math.max(height, block.height);
    }
    return Math.max(height, this.hillAt(x, y) ?? height);
  }

  /** Stairs and hills, in the colors of the present theme. */
  objects(): Group {
    const group = new Group();
    const material = new MeshStandardMaterial({
      color: new Color(themeColor("--floor-fine")),
      roughness: 0.9,
      flatShading: true,
    });
    for (const { low_x, high_x, height } of this.shape.blocks) {
      const depth = Math.min(high_x - low_x, kLastTread);
      const block = new Mesh(new BoxGeometry(depth, kWidth, height), material);
      block.position.set(low_x + depth / 2, 0, height / 2);
      group.add(block);
    }
    if (this.shape.hills) group.add(new Mesh(this.hillGeometry(), material));
    group.traverse((part) => {
      part.castShadow = true;
      part.receiveShadow = true;
    });
    return group;
  }

  /** Between the four heights around a place; nothing outside of the map. */
  private hillAt(x: number, y: number): number | undefined {
    const hills = this.shape.hills;
    if (!hills) return undefined;
    const { columns, rows, size, center, heights } = hills;
    const column = ((x - center[0]) / size[0] + 0.5) * (columns - 1);
    const row = ((y - center[1]) / size[1] + 0.5) * (rows - 1);
    if (!(column >= 0 && row >= 0 && column <= columns - 1 && row <= rows - 1)) return undefined;
    const i = Math.min(Math.floor(column), columns - 2);
    const j = Math.min(Math.floor(row), rows - 2);
    const [u, v] = [column - i, row - j];
    const at = (di: number, dj: number): number => heights[(j + dj) * columns + i + di] ?? 0;
    return (1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) + v * ((1 - u) * at(0, 1) + u * at(1, 1));
  }

  private hillGeometry(): BufferGeometry {
    const { columns, rows, size, center, heights } = this.shape.hills as NonNullable<
      GroundShape["hills"]
    >;
    const points = new Float32Array(3 * columns * rows);
    const triangles: number[] = [];
    for (let j = 0; j < rows; ++j) {
      for (let i = 0; i < columns; ++i) {
        const index = j * columns + i;
        const x = center[0] + size[0] * (i / (columns - 1) - 0.5);
        const y = center[1] + size[1] * (j / (rows - 1) - 0.5);
        points.set([x, y, heights[index] ?? 0], 3 * index);
        if (i + 1 === columns || j + 1 === rows) continue;
        const above = index + columns;
        triangles.push(index, index + 1, above + 1, index, above + 1, above);
      }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(points, 3));
    geometry.setIndex(triangles);
    geometry.computeVertexNormals();
    return geometry;
  }
}
