// Arrows and pins in the picture, which show through the robot.

import {
  ArrowHelper,
  BufferGeometry,
  Color,
  ConeGeometry,
  Group,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshBasicMaterial,
  RingGeometry,
  Vector3,
  type Object3D,
} from "three";

import { themeColor } from "../page/dom.ts";

const kOverAll = 10; // is drawn after everything else

/** Lets `object` be seen through everything. */
export function overAll<Part extends Object3D>(object: Part): Part {
  object.traverse((part) => {
    if (!(part instanceof Mesh || part instanceof Line)) return;
    part.renderOrder = kOverAll;
    part.frustumCulled = false;
    Object.assign(part.material, { depthTest: false, transparent: true });
  });
  return object;
}

export const flatPaint = (color: string): MeshBasicMaterial =>
  new MeshBasicMaterial({ color: new Color(themeColor(color)) });

export const linePaint = (color: string): LineBasicMaterial =>
  new LineBasicMaterial({ color: new Color(themeColor(color)) });

/** Objects that are made when they are first shown, each under a key. */
class Marks<Mark extends Object3D> {
  readonly object = new Group();
  private readonly marks = new Map<string, Mark>();

  hideAll(): void {
    for (const mark of this.marks.values()) mark.visible = false;
  }

  protected take(key: string, make: () => Mark): Mark {
    let mark = this.marks.get(key);
    if (!mark) {
      mark = overAll(make());
      this.marks.set(key, mark);
      this.object.add(mark);
    }
    mark.visible = true;
    return mark;
  }
}

/** In a scene for a robot of `radius` [m]. */
export class Arrows extends Marks<ArrowHelper> {
  constructor(
    private readonly radius: number,
    private readonly color: string,
  ) {
    super();
  }

  /** One that is too short to see is left out. */
  show(key: string, from: Vector3, along: Vector3): void {
    const length = along.length();
    if (!(length > 0.02 * this.radius)) return;
    const up = new Vector3(0, 0, 1);
    const color = new Color(themeColor(this.color));
    const arrow = this.take(key, () => new ArrowHelper(up, from, 1, color));
    arrow.position.copy(from);
    arrow.setDirection(along.clone().normalize());
    const head = Math.min(0.16 * this.radius, 0.5 * length);
    arrow.setLength(length, head, 0.6 * head);
  }
}

/** Pins that point at places. */
export class Pins extends Marks<Group> {
  constructor(
    private readonly radius: number,
    private readonly color: string,
  ) {
    super();
  }

  show(key: string, place: Vector3): void {
    this.take(key, () => this.pin()).position.copy(place);
  }

  private pin(): Group {
    const { radius } = this;
    const height = 0.7 * radius;
    const head = new Mesh(new ConeGeometry(0.1 * radius, 0.24 * radius, 24), flatPaint(this.color));
    head.rotation.x = -Math.PI / 2; // its tip downward
    head.position.z = height;
    const foot = new BufferGeometry().setFromPoints([new Vector3(), new Vector3(0, 0, height)]);
    const ring = new RingGeometry(0.13 * radius, 0.17 * radius, 40);
    return new Group().add(
      head,
      new Line(foot, linePaint(this.color)),
      new Mesh(ring, flatPaint(this.color)),
    );
  }
}
