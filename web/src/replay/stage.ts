// The 3-D picture: robot, floor, light and a camera that follows the base. Draws when asked to.

import { Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from "three";

import type { BodyLink, Scenery } from "../data/report_data.ts";
import { Aids, kFirstAids, type AidSettings } from "./aids.ts";
import { CameraRig } from "./camera_rig.ts";
import { framingOf, type Framing } from "./framing.ts";
import { Ground } from "./ground.ts";
import { instantOf, kNothingKnown, type Instant } from "./instant.ts";
import { Light } from "./light.ts";
import {
  durationOf,
  frameAt,
  kPoseSize,
  placeOnPath,
  sampleMotion,
  smoothPath,
  type Motion,
} from "./motion.ts";
import { RobotModel } from "./robot_model.ts";
import { Terrain } from "./terrain.ts";

const kFollowSmoothing = 0.3; // half the time over which the followed path is averaged [s]
const kNothing: Motion = { frames: 0, interval: 1, poses: new Float32Array() };
const kNothingFramed: Framing = { anchor: 0, height: 0, radius: 0.2 };

export class Stage {
  readonly canvas: HTMLCanvasElement;
  isInSight = true; // scrolled away, it need not be drawn: without a GPU that takes a core
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly rig: CameraRig;
  private readonly light: Light;
  private terrain: Terrain;
  private robot: RobotModel;
  private poses: Float32Array;
  private motion: Motion = kNothing;
  private framing: Framing = kNothingFramed;
  private path: Float32Array = new Float32Array();
  private ground: Ground | undefined;
  private aids: Aids | undefined;
  private settings = kFirstAids;
  private instant = kNothingKnown;
  private time = 0;
  private follows = true;
  private width = 1;
  private height = 1;

  /** `onView` is called when the user moves the camera. */
  constructor(
    private scenery: Scenery,
    onView: () => void,
  ) {
    this.renderer = new WebGLRenderer({ antialias: true });
    this.canvas = this.renderer.domElement;
    this.terrain = new Terrain(scenery.ground);
    this.robot = new RobotModel(scenery.body);
    this.poses = new Float32Array(scenery.body.length * kPoseSize);
    this.light = new Light(this.renderer, this.scene);
    this.scene.add(this.robot.object);
    this.rig = new CameraRig(this.canvas, onView);
    this.resetView();
  }

  /** Takes the place of the present robot; the next call is `show`. */
  setScenery(scenery: Scenery): void {
    this.scenery = scenery;
    this.scene.remove(this.robot.object);
    this.robot.dispose();
    this.terrain = new Terrain(scenery.ground);
    this.robot = new RobotModel(scenery.body);
    this.poses = new Float32Array(scenery.body.length * kPoseSize);
    this.scene.add(this.robot.object);
  }

  show(motion: Motion): void {
    this.continueWith(motion);
    this.resetView();
  }

  /** Another motion, seen from the side that the camera is on now. */
  continueWith(motion: Motion): void {
    const isFirst = this.framing === kNothingFramed;
    this.motion = motion;
    this.framing = kNothingFramed;
    if (motion.frames > 0) {
      this.framing = framingOf(this.links, motion, (x, y) => this.terrain.heightAt(x, y));
    }
    this.path = smoothPath(motion, this.framing.anchor, kFollowSmoothing);
    this.rig.fit(this.framing.radius);
    this.light.fit(this.framing.radius);
    this.instant = kNothingKnown;
    this.updateTheme();
    this.setTime(0);
    if (isFirst) this.resetView();
  }

  /** A single instant of a motion that nobody knows yet: no path, and the view stays as it is. */
  showInstant(poses: Float32Array): void {
    const motion = { frames: 1, interval: 1, poses };
    if (this.framing === kNothingFramed) return this.continueWith(motion);
    this.motion = motion;
    const [x = 0, y = 0] = poses.subarray(kPoseSize * this.framing.anchor);
    this.path = new Float32Array([x, y]);
    if (!this.ground?.covers(x, y)) this.updateTheme();
    this.setTime(0);
  }

  /** What a motion does not say itself: who shows one knows it, for the time that is shown. */
  setInstant(instant: Instant): void {
    this.instant = instant;
    this.lightContacts();
  }

  setTime(time: number): void {
    this.time = Math.min(time, durationOf(this.motion));
    if (this.motion.frames === 0) return;
    sampleMotion(this.motion, this.time, this.poses);
    this.robot.setPoses(this.poses);
    const { body } = this.scenery;
    this.instant = instantOf(this.motion, body.length, this.time, this.instant);
    this.lightContacts();
    this.ground?.setFrame(frameAt(this.motion, this.time));
    if (this.follows) this.follow();
  }

  /** What is drawn beside the robot. */
  setAids(settings: AidSettings): void {
    this.settings = settings;
    this.ground?.setTrail(settings.trail);
    this.lightContacts();
  }

  /** The link that is seen at a point of the canvas (its corners: ±1), if any. */
  linkAt(x: number, y: number): number | undefined {
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(x, y), this.rig.camera);
    return this.robot.hitBy(ray);
  }

  /** Marks a link that somebody has picked. */
  pick(link: number | undefined): void {
    this.robot.setPicked(link);
  }

  /** The poses that are shown: [link][x, y, z, qw, qx, qy, qz]. */
  get now(): Float32Array {
    return this.poses;
  }

  /** Where the link is now that is followed, mostly the base: x, y, z [m]. */
  get place(): [number, number, number] {
    const [x = 0, y = 0, z = 0] = this.poses.subarray(kPoseSize * this.framing.anchor);
    return [x, y, z];
  }

  /** From where the camera looks, in the robot's radii from the point that it looks at. */
  get view(): Vector3 {
    return this.rig.view;
  }
  set view(view: Vector3) {
    this.rig.view = view;
  }

  setFollowing(follows: boolean): void {
    this.follows = follows;
    this.setTime(this.time);
  }

  /** The wheel zooms only while this is set, since it would keep the page from scrolling. */
  setZoomable(zoomable: boolean): void {
    this.rig.setZoomable(zoomable);
  }

  resetView(): void {
    this.follow();
    this.rig.reset();
  }

  setSize(width: number, height: number): void {
    this.width = width;
    this.height = height;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.rig.setAspect(width / height);
  }

  updateTheme(): void {
    const { radius } = this.framing;
    this.light.updateTheme(radius);
    this.robot.updateColors();
    for (const part of [this.ground, this.aids]) {
      if (part) this.scene.remove(part.object);
      part?.dispose();
    }
    this.ground = new Ground(this.path, radius, this.terrain);
    this.ground.setTrail(this.settings.trail);
    this.aids = new Aids(this.links, this.terrain, radius);
    this.scene.add(this.ground.object, this.aids.object);
    this.ground.setFrame(frameAt(this.motion, this.time));
  }

  draw(): void {
    this.aids?.show(this.poses, this.instant, this.settings);
    this.renderer.render(this.scene, this.rig.camera);
  }

  /** Draws the moments `times` [s] into `canvases`, seen from the side the camera is on now. */
  drawSnapshots(times: number[], canvases: HTMLCanvasElement[]): void {
    const { time, follows, width, height } = this;
    const target = this.rig.place;
    this.follows = true;
    times.forEach((moment, i) => {
      const canvas = canvases[i] as HTMLCanvasElement;
      this.renderer.setPixelRatio(1);
      this.renderer.setSize(canvas.width, canvas.height, false);
      this.rig.setAspect(canvas.width / canvas.height);
      this.setTime(moment);
      this.draw();
      canvas.getContext("2d")?.drawImage(this.canvas, 0, 0);
    });
    this.follows = follows;
    this.setTime(time);
    this.moveTo(target);
    this.setSize(width, height);
    this.draw();
  }

  private lightContacts(): void {
    this.robot.setLit((link) => this.settings.lit && this.instant.touches(link));
  }

  /** Those of the robot: not the things around it, which come after them. */
  private get links(): BodyLink[] {
    return this.scenery.body.filter((part) => !part.thing);
  }

  private follow(): void {
    const [x, y] = placeOnPath(this.path, this.motion, this.time);
    this.moveTo(new Vector3(x, y, this.framing.height + this.terrain.heightAt(x, y)));
  }

  /** Moves camera and light to look at `target`, from the side that the user has chosen. */
  private moveTo(target: Vector3): void {
    this.rig.moveTo(target);
    this.light.moveTo(target, this.framing.radius);
  }
}
