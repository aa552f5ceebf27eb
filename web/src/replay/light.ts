// Sky, haze and sun of the picture, as large as the robot needs them.

import { Color, DirectionalLight, Fog, HemisphereLight, PCFShadowMap, Vector3, type Scene, type WebGLRenderer } from "three";

import { themeColor } from "../page/dom.ts";

const kPlace = new Vector3(-3.3, -4.3, 7.6); // seen from the robot, in its radii
const kLit = 2.9; // half the width of what has shadows, likewise
const kFog = { near: 7.6, far: 24 }; // likewise

export class Light {
  private readonly sky = new HemisphereLight(0xffffff, 0xffffff, 2.3);
  private readonly sun = new DirectionalLight(0xffffff, 1.9);

  constructor(
    renderer: WebGLRenderer,
    private readonly scene: Scene,
  ) {
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = PCFShadowMap;
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.radius = 3;
    scene.add(this.sky, this.sun, this.sun.target);
  }

  /** For a robot of this radius [m]. */
  fit(radius: number): void {
    const lit = kLit * radius;
    this.sun.shadow.normalBias = 0.01 * radius;
    const frame = this.sun.shadow.camera;
    [frame.left, frame.right, frame.bottom, frame.top] = [-lit, lit, -lit, lit];
    [frame.near, frame.far] = [2 * radius, 20 * radius];
    frame.updateProjectionMatrix();
  }

  moveTo(target: Vector3, radius: number): void {
    this.sun.target.position.copy(target);
    this.sun.position.copy(target).addScaledVector(kPlace, radius);
  }

  updateTheme(radius: number): void {
    const background = new Color(themeColor("--stage"));
    this.scene.background = background;
    this.scene.fog = new Fog(background, kFog.near * radius, kFog.far * radius);
    this.sky.groundColor = new Color(themeColor("--stage-bounce"));
  }
}
