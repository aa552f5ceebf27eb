// The robot's links and the things around it as three.js objects, moved by poses in the world frame (z up).

import {
  CapsuleGeometry,
  Color,
  CylinderGeometry,
  Group,
  Mesh,
  MeshStandardMaterial,
  Quaternion,
  SphereGeometry,
  Vector3,
  type BufferGeometry,
  type Raycaster,
} from "three";
import { ConvexGeometry } from "three/examples/jsm/geometries/ConvexGeometry.js";
import { RoundedBoxGeometry } from "three/examples/jsm/geometries/RoundedBoxGeometry.js";

import type { BodyLink } from "../data/report_data.ts";
import { themeColor } from "../page/dom.ts";
import { kPoseSize } from "./motion.ts";
import { sideOf, type Side } from "./side.ts";

const kSideColors: Record<Side, string> = {
  left: "--left",
  right: "--right",
  trunk: "--trunk",
};

function geometryOf(link: BodyLink): BufferGeometry {
  if (link.shape === "sphere") return new SphereGeometry(link.radius, 32, 20);
  if (link.shape === "convex") {
    return new ConvexGeometry((link.points ?? []).map((point) => new Vector3(...point)));
  }
  if (link.shape === "box") {
    const [x, y, z] = link.size;
    return new RoundedBoxGeometry(x, y, z, 4, 0.14 * Math.min(x, y, z));
  }
  const straight = Math.max(0, link.length - 2 * link.radius);
  const rod =
    link.shape === "cylinder"
      ? new CylinderGeometry(link.radius, link.radius, link.length, 32)
      : new CapsuleGeometry(link.radius, straight, 12, 28); // both along y
  if (link.axis === 0) rod.rotateZ(-Math.PI / 2);
  if (link.axis === 2) rod.rotateX(Math.PI / 2);
  return rod;
}

/** The geometry in the link's frame. */
function placedGeometryOf(link: BodyLink): BufferGeometry {
  const geometry = geometryOf(link);
  const [w, x, y, z] = link.orientation ?? [1, 0, 0, 0];
  geometry.applyQuaternion(new Quaternion(x, y, z, w));
  return geometry.translate(...(link.position ?? [0, 0, 0]));
}

/** A dark plate on the front (+x) of base and head: without it, front and back look alike. */
function frontPlate(link: BodyLink, material: MeshStandardMaterial): Mesh {
  const [x, y, z] = link.size;
  const depth = 0.06 * Math.min(y, z);
  const width = 0.62 * y;
  const height = 0.34 * z;
  const plate = new Mesh(
    new RoundedBoxGeometry(depth, width, height, 3, 0.45 * Math.min(depth, height)),
    material,
  );
  plate.position.set(x / 2, 0, 0.16 * z);
  return plate;
}

type Paint = Side | "joint_left" | "joint_right" | "plate" | "thing";
type Materials = Record<Paint, MeshStandardMaterial>;

const kShine = 0.55; // of what is lit
const kPickedShine = 0.75;

function makeMaterials(): Materials {
  const matte = (): MeshStandardMaterial =>
    new MeshStandardMaterial({ roughness: 0.62, metalness: 0.05 });
  return {
    left: matte(),
    right: matte(),
    trunk: matte(),
    joint_left: matte(),
    joint_right: matte(),
    plate: matte(),
    thing: matte(),
  };
}

function paintOf(link: BodyLink): Paint {
  if (link.thing) return "thing";
  const side = sideOf(link.name);
  const isJoint = link.shape === "sphere" && side !== "trunk";
  return isJoint ? `joint_${side}` : side;
}

export class RobotModel {
  readonly object = new Group();
  private readonly links: Mesh[];
  private readonly materials = makeMaterials();
  private readonly shining = makeMaterials();
  private readonly paints: Paint[];
  private readonly picking = makeMaterials();
  private picked: number | undefined;
  private isLit: (link: number) => boolean = () => false;

  constructor(body: BodyLink[]) {
    this.paints = body.map(paintOf);
    this.links = body.map((link, index) => this.makeLink(link, index));
    this.object.add(...this.links);
    this.updateColors();
  }

  /** Takes the colors of the present theme. */
  updateColors(): void {
    for (const materials of [this.materials, this.shining, this.picking]) {
      for (const side of ["left", "right", "trunk"] as const) {
        materials[side].color = new Color(themeColor(kSideColors[side]));
      }
      materials.joint_left.color = new Color(themeColor("--left")).multiplyScalar(0.55);
      materials.joint_right.color = new Color(themeColor("--right")).multiplyScalar(0.55);
      materials.plate.color = new Color(themeColor("--plate"));
      materials.thing.color = new Color(themeColor("--thing"));
    }
    const shine = (materials: Materials, color: string, intensity: number): void => {
      for (const material of Object.values(materials)) {
        material.emissive = new Color(themeColor(color));
        material.emissiveIntensity = intensity;
      }
    };
    shine(this.shining, "--touch", kShine);
    shine(this.picking, "--picked", kPickedShine);
  }

  /** Lets the links shine for which `isLit` holds. */
  setLit(isLit: (link: number) => boolean): void {
    this.isLit = isLit;
    this.paint();
  }

  /** Marks one link among all. */
  setPicked(link: number | undefined): void {
    this.picked = link;
    this.paint();
  }

  /** The first link that the ray meets. */
  hitBy(ray: Raycaster): number | undefined {
    const [hit] = ray.intersectObjects(this.links, true);
    if (!hit) return undefined;
    const link = this.links.findIndex((mesh) => mesh === hit.object || mesh === hit.object.parent);
    return link < 0 ? undefined : link;
  }

  /** `poses`: [link][x, y, z, qw, qx, qy, qz]. */
  setPoses(poses: Float32Array): void {
    this.links.forEach((link, i) => {
      const [x = 0, y = 0, z = 0, qw = 1, qx = 0, qy = 0, qz = 0] = poses.subarray(
        i * kPoseSize,
        (i + 1) * kPoseSize,
      );
      link.position.set(x, y, z);
      link.quaternion.set(qx, qy, qz, qw);
    });
  }

  dispose(): void {
    this.object.traverse((part) => {
      if (part instanceof Mesh) part.geometry.dispose();
    });
    for (const materials of [this.materials, this.shining, this.picking]) {
      for (const material of Object.values(materials)) material.dispose();
    }
  }

  private paint(): void {
    this.links.forEach((mesh, i) => {
      const lit = this.isLit(i) ? this.shining : this.materials;
      mesh.material = (i === this.picked ? this.picking : lit)[this.paints[i] as Paint];
    });
  }

  private makeLink(link: BodyLink, index: number): Mesh {
    const mesh = new Mesh(placedGeometryOf(link), this.materials[paintOf(link)]);
    const hasFront =
      link.shape === "box" && link.position === undefined && (index === 0 || link.name === "head");
    if (hasFront) mesh.add(frontPlate(link, this.materials.plate));
    mesh.traverse((part) => {
      part.castShadow = true;
      part.receiveShadow = true;
    });
    return mesh;
  }
}
