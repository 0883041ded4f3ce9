// Renderer, light and camera; the camera follows the figure and obeys mouse, wheel and fingers.

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
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { isSlow, makePace } from './pace.js';

// From where the light comes.
export const SUN = [-0.9, 2.6, 1.1];
// From where the camera looks at the figure.
const VIEWS = {
  angle: [-1.85, 0.4, 1.3],
  side: [-2.2, 0.12, 0],
  front: [0, 0.4, 2.3],
  back: [0, 0.4, -2.3],
  top: [-0.01, 2.6, 0],
};
// What moves across the path is seen from nearer to the front.
const ACROSS = [-1.1, 0.4, 1.95];
// Share of the picture's height and width that the figure may take.
const FILLED = 0.8;
// By how much a view is raised, and how often, until nothing hides the figure.
const RAISE = 0.15;
const RAISES = 20;
// Size of a figure to which the lengths below belong (m).
const PERSON = 1.75;

// Nothing is framed before `stage.frame`. Throws where there is no WebGL.
export function makeStage(holder) {
  const slow = isSlow();
  const renderer = new WebGLRenderer({ antialias: !slow });
  // To ask whether a program compiles waits for the graphics each time.
  renderer.debug.checkShaderErrors = false;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.domElement.setAttribute('role', 'img');
  renderer.domElement.setAttribute('aria-label', 'The moving figure; drag to turn, scroll to zoom');
  holder.prepend(renderer.domElement);

  const half = new Vector3();
  let [size, climbs, sees] = [PERSON, false, () => true];
  const scene = new Scene();
  scene.background = new Color();
  scene.fog = new Fog(0);
  const camera = new PerspectiveCamera(35, 1);
  const controls = new OrbitControls(camera, renderer.domElement);
  controls.maxPolarAngle = 0.53 * Math.PI;

  const sky = new HemisphereLight(0xffffff, 0xb8b0a4, 1.9);
  const sun = new DirectionalLight(0xffffff, 2.1);
  sun.castShadow = true;
  const pixels = slow ? 512 : 1024;
  sun.shadow.mapSize.set(pixels, pixels);
  sun.shadow.radius = 2.5;
  sun.shadow.bias = -0.0004;
  scene.add(sky, sun, sun.target);

  // How far from the middle of the box the camera must be, in this direction, to have its eight corners in view.
  const [forward, right, up, corner] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  function distance(direction) {
    forward.copy(direction).normalize();
    right.crossVectors(camera.up, forward).normalize();
    up.crossVectors(forward, right);
    const tall = FILLED * Math.tan((camera.fov * Math.PI) / 360);
    let far = 0;
    for (let i = 0; i < 8; i += 1) {
      corner.set(i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z);
      const needed = Math.max(Math.abs(corner.dot(right)) / (tall * camera.aspect), Math.abs(corner.dot(up)) / tall);
      far = Math.max(far, corner.dot(forward) + needed);
    }
    return far;
  }

  const shift = new Vector3();
  // The view that the camera has until the reader turns it.
  let named = 'angle';
  controls.addEventListener('start', () => (named = null));
  const stage = {
    scene,
    camera,
    controls,
    renderer,
    pace: makePace(renderer, slow),
    width: 0,
    height: 0,
    // `half`: half of the edges of the box that is to be in view; `size`: the greatest edge; `climbs`: whether the figure goes up, and
    // is seen from behind; `sees(offset)`: whether the ground hides nothing from a camera so far from what it looks at.
    frame(framed) {
      half.fromArray(framed.half);
      ({ size, climbs, sees } = framed);
      controls.minDistance = 0.4 * size;
      controls.maxDistance = 40 * size;
      sun.shadow.normalBias = (0.02 * size) / PERSON;
      const reach = 1.6 * half.length();
      Object.assign(sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 0.1 * size, far: 8 * size });
      sun.shadow.camera.updateProjectionMatrix();
    },
    // Whether the reader has not turned it, and a new figure is to be framed as a view says.
    named: () => named,
    paint(theme) {
      scene.background.set(theme.sky);
      scene.fog.color.set(theme.sky);
      sky.intensity = theme.dark ? 1.2 : 1.9;
    },
    view(name) {
      named = name;
      shift.fromArray(name === 'angle' && half.x > 1.5 * half.z ? ACROSS : VIEWS[name]);
      // Stairs show their risers.
      if (name === 'angle' && climbs) shift.z = -shift.z;
      const place = () => camera.position.copy(shift).setLength(distance(shift));
      for (let i = 0; i < RAISES && !sees(place()); i += 1) shift.y += RAISE;
      place().add(controls.target);
      controls.update();
    },
    // Light and, if wanted, the camera move along with `point`.
    follow(point, withCamera) {
      sun.target.position.copy(point);
      sun.position.fromArray(SUN).multiplyScalar(size).add(point);
      if (!withCamera) return;
      shift.subVectors(point, controls.target);
      controls.target.add(shift);
      camera.position.add(shift);
      controls.update();
    },
    resize() {
      const { clientWidth, clientHeight } = holder;
      if (clientWidth === 0 || clientHeight === 0) return;
      [stage.width, stage.height] = [clientWidth, clientHeight];
      renderer.setSize(clientWidth, clientHeight);
      camera.aspect = clientWidth / clientHeight;
      camera.updateProjectionMatrix();
      if (named) stage.view(named);
    },
    draw() {
      // However far the reader zooms out, the figure is nearer than the fog.
      const away = camera.position.distanceTo(controls.target);
      Object.assign(camera, { near: 0.02 * away, far: away + 40 * size });
      Object.assign(scene.fog, { near: away + 2 * size, far: away + 7 * size });
      camera.updateProjectionMatrix();
      renderer.render(scene, camera);
    },
  };
  return stage;
}
