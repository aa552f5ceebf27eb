// The camera, and the user's hand on it: it goes along with what it looks at, and stays on the side
// that the user has chosen.

import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

// In radii of the robot around the point that the camera looks at.
const kFirstView = new Vector3(1.9, -5.4, 1.9);
const kNearest = 1.9;
const kFarthest = 38;
const kAngle = 24; // of the picture's height [degrees]
const kWidestAngle = 50;

export class CameraRig {
  readonly camera = new PerspectiveCamera(kAngle);
  private readonly controls: OrbitControls;
  private readonly target = new Vector3();
  private radius = 1;

  /** `onView` is called when the user moves the camera. */
  constructor(canvas: HTMLCanvasElement, onView: () => void) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.maxPolarAngle = 0.495 * Math.PI;
    this.controls.addEventListener("change", onView);
  }

  /** For a robot of this radius [m]. */
  fit(radius: number): void {
    this.radius = radius;
    [this.controls.minDistance, this.controls.maxDistance] = [kNearest * radius, kFarthest * radius];
    [this.camera.near, this.camera.far] = [0.2 * radius, 4 * kFarthest * radius];
    this.camera.updateProjectionMatrix();
  }

  /** What the camera looks at. */
  get place(): Vector3 {
    return this.target.clone();
  }

  moveTo(target: Vector3): void {
    this.camera.position.add(target).sub(this.target);
    this.camera.lookAt(target);
    this.target.copy(target);
    this.controls.target.copy(target);
  }

  /** From where the camera looks, in radii from the point that it looks at. */
  get view(): Vector3 {
    return this.camera.position.clone().sub(this.target).divideScalar(this.radius);
  }
  set view(view: Vector3) {
    this.camera.position.copy(this.target).addScaledVector(view, this.radius);
    this.camera.lookAt(this.target);
  }

  reset(): void {
    this.view = kFirstView;
    this.controls.update();
  }

  setZoomable(zoomable: boolean): void {
    this.controls.enableZoom = zoomable;
  }

  /** Keeps the robot's whole width in narrow pictures by a wider angle. */
  setAspect(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.fov = aspect >= 1 ? kAngle : Math.min(kAngle / aspect, kWidestAngle);
    this.camera.updateProjectionMatrix();
  }
}
