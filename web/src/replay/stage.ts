// The 3-D picture: robot, floor, light and a camera that follows the base. Draws when asked to.

import {
  Color,
  DirectionalLight,
  Fog,
  HemisphereLight,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

import type { Scenery } from "../data/report_data.ts";
import { sampleAt, touches } from "../data/timeline.ts";
import { themeColor } from "../page/dom.ts";
import { framingOf, type Framing } from "./framing.ts";
import { Ground } from "./ground.ts";
import { durationOf, frameAt, kPoseSize, sampleMotion, smoothPath, type Motion } from "./motion.ts";
import { RobotModel } from "./robot_model.ts";
import { Terrain } from "./terrain.ts";

const kFollowSmoothing = 0.3; // half the time over which the followed path is averaged [s]
const kNothing: Motion = { frames: 0, interval: 1, poses: new Float32Array() };
const kNothingFramed: Framing = { anchor: 0, height: 0, radius: 0.2 };

// Seen from the point that the camera looks at, in radii of the robot around that point.
const kFirstView = new Vector3(1.9, -5.4, 1.9);
const kLightPlace = new Vector3(-3.3, -4.3, 7.6);
const kLit = 2.9; // half the width of what has shadows
const kNearest = 1.9;
const kFarthest = 38;
const kFog = { near: 7.6, far: 24 };

export class Stage {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(24);
  private readonly controls: OrbitControls;
  private readonly sky = new HemisphereLight(0xffffff, 0xffffff, 2.3);
  private readonly light = new DirectionalLight(0xffffff, 1.9);
  private terrain: Terrain;
  private robot: RobotModel;
  private poses: Float32Array;
  private readonly target = new Vector3();
  private motion: Motion = kNothing;
  private framing: Framing = kNothingFramed;
  private path: Float32Array = new Float32Array();
  private ground: Ground | undefined;
  private time = 0;
  private follows = true;
  private lightsContacts = true;
  private width = 1;
  private height = 1;

  /** `onView` is called when the user moves the camera. */
  constructor(
    private scenery: Scenery,
    onView: () => void,
  ) {
    this.renderer = new WebGLRenderer({ antialias: true });
    this.canvas = this.renderer.domElement;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.camera.up.set(0, 0, 1);
    this.terrain = new Terrain(scenery.ground);
    this.robot = new RobotModel(scenery.body);
    this.poses = new Float32Array(scenery.body.length * kPoseSize);
    this.addLight();
    this.scene.add(this.robot.object);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.maxPolarAngle = 0.495 * Math.PI;
    this.controls.addEventListener("change", onView);
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
    this.framing = motion.frames > 0 ? this.frame(motion) : kNothingFramed;
    this.path = smoothPath(motion, this.framing.anchor, kFollowSmoothing);
    this.fitToRobot();
    this.updateTheme();
    this.robot.setLit(() => false);
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

  /** Lights the links that have contact, one number for each. */
  setContacts(contacts: ArrayLike<number>): void {
    this.robot.setLit((link) => contacts[link] === 1);
  }

  setTime(time: number): void {
    this.time = Math.min(time, durationOf(this.motion));
    if (this.motion.frames === 0) return;
    sampleMotion(this.motion, this.time, this.poses);
    this.robot.setPoses(this.poses);
    this.lightContacts();
    this.ground?.setFrame(frameAt(this.motion, this.time));
    if (this.follows) this.follow();
  }

  /** Whether links that touch something shine, where the motion knows that. */
  setLightingContacts(lights: boolean): void {
    this.lightsContacts = lights;
    this.lightContacts();
  }

  /** Where the link is now that is followed, mostly the base: x, y, z [m]. */
  get place(): [number, number, number] {
    const [x = 0, y = 0, z = 0] = this.poses.subarray(kPoseSize * this.framing.anchor);
    return [x, y, z];
  }

  setFollowing(follows: boolean): void {
    this.follows = follows;
    this.setTime(this.time);
  }

  /** The wheel zooms only while this is set, since it would keep the page from scrolling. */
  setZoomable(zoomable: boolean): void {
    this.controls.enableZoom = zoomable;
  }

  resetView(): void {
    this.follow();
    this.camera.position.copy(this.target).addScaledVector(kFirstView, this.framing.radius);
    this.controls.target.copy(this.target);
    this.controls.update();
  }

  setSize(width: number, height: number): void {
    this.width = width;
    this.height = height;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.frameCamera(width / height);
  }

  updateTheme(): void {
    const background = new Color(themeColor("--stage"));
    this.scene.background = background;
    const { radius } = this.framing;
    this.scene.fog = new Fog(background, kFog.near * radius, kFog.far * radius);
    this.sky.groundColor = new Color(themeColor("--stage-bounce"));
    this.robot.updateColors();
    if (this.ground) {
      this.scene.remove(this.ground.object);
      this.ground.dispose();
    }
    this.ground = new Ground(this.path, radius, this.terrain);
    this.scene.add(this.ground.object);
    this.ground.setFrame(frameAt(this.motion, this.time));
  }

  draw(): void {
    this.renderer.render(this.scene, this.camera);
  }

  /** Draws the moments `times` [s] into `canvases`, seen from the side the camera is on now. */
  drawSnapshots(times: number[], canvases: HTMLCanvasElement[]): void {
    const { time, follows, width, height } = this;
    const target = this.target.clone();
    this.follows = true;
    times.forEach((moment, i) => {
      const canvas = canvases[i] as HTMLCanvasElement;
      this.renderer.setPixelRatio(1);
      this.renderer.setSize(canvas.width, canvas.height, false);
      this.frameCamera(canvas.width / canvas.height);
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

  /** Of a motion that says what touches what; who shows others calls setContacts(). */
  private lightContacts(): void {
    const { timeline } = this.motion;
    if (!timeline) return;
    const count = this.scenery.body.length;
    const sample = sampleAt(timeline, this.time);
    this.robot.setLit((link) => this.lightsContacts && touches(timeline, count, sample, link));
  }

  private addLight(): void {
    this.light.castShadow = true;
    this.light.shadow.mapSize.set(1024, 1024);
    this.light.shadow.radius = 3;
    this.scene.add(this.sky, this.light, this.light.target);
  }

  private fitToRobot(): void {
    const { radius } = this.framing;
    [this.controls.minDistance, this.controls.maxDistance] = [kNearest * radius, kFarthest * radius];
    [this.camera.near, this.camera.far] = [0.2 * radius, 4 * kFarthest * radius];
    this.camera.updateProjectionMatrix();
    this.light.shadow.normalBias = 0.01 * radius;
    const frame = this.light.shadow.camera;
    const lit = kLit * radius;
    [frame.left, frame.right, frame.bottom, frame.top] = [-lit, lit, -lit, lit];
    [frame.near, frame.far] = [2 * radius, 20 * radius];
    frame.updateProjectionMatrix();
  }

  /** Keeps the robot's whole width in narrow pictures by a wider angle. */
  private frameCamera(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.fov = aspect >= 1 ? 24 : Math.min(24 / aspect, 50);
    this.camera.updateProjectionMatrix();
  }

  /** What there is to see of the robot: not what is around it. */
  private frame(motion: Motion): Framing {
    const links = this.scenery.body.filter((part) => !part.thing);
    return framingOf(links, motion, (x, y) => this.terrain.heightAt(x, y));
  }

  private follow(): void {
    const frame = this.motion.frames > 0 ? frameAt(this.motion, this.time) : 0;
    const next = Math.min(frame + 1, this.motion.frames - 1);
    const weight = Math.min(Math.max(this.time / this.motion.interval - frame, 0), 1);
    const between = (i: number): number =>
      (1 - weight) * (this.path[2 * frame + i] ?? 0) + weight * (this.path[2 * next + i] ?? 0);
    const [x, y] = [between(0), between(1)];
    this.moveTo(new Vector3(x, y, this.framing.height + this.terrain.heightAt(x, y)));
  }

  /** Moves camera and light to look at `target`, from the side that the user has chosen. */
  private moveTo(target: Vector3): void {
    this.camera.position.add(target).sub(this.target);
    this.camera.lookAt(target);
    this.target.copy(target);
    this.controls.target.copy(target);
    this.light.target.position.copy(target);
    this.light.position.copy(target).addScaledVector(kLightPlace, this.framing.radius);
  }
}
