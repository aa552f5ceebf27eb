// What is drawn into the picture beside the robot: its center of mass, where it touches the ground
// and how hard, and where it was told to go.

import {
  BufferGeometry,
  Group,
  Line,
  Mesh,
  Quaternion,
  RingGeometry,
  SphereGeometry,
  Vector3,
  type Material,
} from "three";

import type { BodyLink, ToldGoal } from "../data/report_data.ts";
import { centerOfMass, lowestPoint, massOf } from "./body_points.ts";
import type { Instant } from "./instant.ts";
import { Arrows, flatPaint, linePaint, overAll, Pins } from "./markers.ts";
import { kPoseSize } from "./motion.ts";
import type { Terrain } from "./terrain.ts";
import { placesIn, velocitiesIn } from "./told.ts";

/** Which of them are shown. */
export interface AidSettings {
  lit: boolean; // links that touch something shine
  points: boolean; // where they do
  mass: boolean;
  goals: boolean;
  trail: boolean;
}

export const kFirstAids: AidSettings = {
  lit: true,
  points: false,
  mass: false,
  goals: true,
  trail: true,
};

const kGravity = 9.8; // [m/s^2]
const kUp = new Vector3(0, 0, 1);

/** Which way the robot faces, on the level. */
function headingOf(poses: Float32Array): Quaternion {
  const [, , , w = 1, x = 0, y = 0, z = 0] = poses;
  const ahead = new Vector3(1, 0, 0).applyQuaternion(new Quaternion(x, y, z, w));
  return new Quaternion().setFromAxisAngle(kUp, Math.atan2(ahead.y, ahead.x));
}

export class Aids {
  readonly object = new Group();
  private readonly center: Mesh;
  private readonly plumb: Line;
  private readonly below: Mesh;
  private readonly points: Mesh[];
  private readonly forces: Arrows;
  private readonly velocities: Arrows;
  private readonly places: Pins;
  private readonly weight: number; // [N]

  /** In the colors of the present theme, and as large as a robot of this radius [m] needs them. */
  constructor(
    private readonly body: BodyLink[],
    private readonly terrain: Terrain,
    private readonly radius: number,
  ) {
    this.weight = kGravity * massOf(body);
    this.center = new Mesh(new SphereGeometry(0.05 * radius, 24, 16), flatPaint("--mass"));
    this.plumb = new Line(new BufferGeometry(), linePaint("--mass"));
    this.below = new Mesh(new RingGeometry(0.05 * radius, 0.075 * radius, 40), flatPaint("--mass"));
    const point = new SphereGeometry(0.035 * radius, 16, 12);
    const paint = flatPaint("--touch");
    this.points = body.map(() => new Mesh(point, paint));
    const fixed = new Group().add(this.center, this.plumb, this.below, ...this.points);
    this.forces = new Arrows(radius, "--force");
    this.velocities = new Arrows(radius, "--goal");
    this.places = new Pins(radius, "--goal");
    const marks = [this.forces, this.velocities, this.places].map(({ object }) => object);
    this.object.add(overAll(fixed), ...marks);
  }

  /** `poses`: [link][x, y, z, qw, qx, qy, qz]. */
  show(poses: Float32Array, instant: Instant, settings: AidSettings): void {
    this.showMass(settings.mass ? centerOfMass(this.body, poses) : undefined);
    this.showContacts(poses, instant, settings.points);
    this.showGoals(settings.goals ? instant.goals : [], poses);
  }

  dispose(): void {
    this.object.traverse((part) => {
      if (!(part instanceof Mesh || part instanceof Line)) return;
      part.geometry.dispose();
      (part.material as Material).dispose();
    });
  }

  private showMass(center: Vector3 | undefined): void {
    for (const part of [this.center, this.plumb, this.below]) part.visible = center !== undefined;
    if (!center) return;
    const below = new Vector3(center.x, center.y, this.terrain.heightAt(center.x, center.y));
    this.center.position.copy(center);
    this.plumb.geometry.setFromPoints([center, below]);
    this.below.position.copy(below).addScaledVector(kUp, 0.004 * this.radius);
    this.below.quaternion.setFromUnitVectors(kUp, this.normal);
  }

  /** An arrow as long as the robot's radius stands for its weight. */
  private showContacts(
    poses: Float32Array,
    { touches, forces }: Instant,
    areShown: boolean,
  ): void {
    this.forces.hideAll();
    this.points.forEach((point, link) => {
      const part = this.body[link];
      point.visible = areShown && part !== undefined && touches(link);
      if (!point.visible || !part) return;
      const pose = poses.subarray(link * kPoseSize, (link + 1) * kPoseSize);
      point.position.copy(lowestPoint(part, pose, this.normal));
      if (!forces || this.weight === 0) return;
      const [x = 0, y = 0, z = 0] = forces.subarray(3 * link, 3 * link + 3);
      const force = new Vector3(x, y, z).multiplyScalar(this.radius / this.weight);
      this.forces.show(String(link), point.position, force);
    });
  }

  private showGoals(goals: ToldGoal[], poses: Float32Array): void {
    this.places.hideAll();
    for (const { name, value } of placesIn(goals)) {
      const [x = 0, y = 0, z = this.terrain.heightAt(x, y)] = value;
      this.places.show(name, new Vector3(x, y, z));
    }
    this.velocities.hideAll();
    const [x = 0, y = 0, z = 0] = poses;
    for (const { name, value } of velocitiesIn(goals)) {
      const [forward = 0, left = 0, up = 0] = value;
      const velocity = new Vector3(forward, left, up).applyQuaternion(headingOf(poses));
      this.velocities.show(name, new Vector3(x, y, z), velocity);
    }
  }

  private get normal(): Vector3 {
    return new Vector3(...this.terrain.normal);
  }
}
