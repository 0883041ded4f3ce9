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

// Where the camera stands, seen from the figure, in heights of the figure.
const VIEWS = {
  angle: [-1.85, 0.4, 1.3],
  side: [-2.2, 0.12, 0],
  front: [0, 0.4, 2.3],
  back: [0, 0.4, -2.3],
  top: [-0.01, 2.6, 0],
};

// Throws where there is no WebGL.
export function makeStage(holder, size) {
  const renderer = new WebGLRenderer({ antialias: true });
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.setPixelRatio(Math.min(2, devicePixelRatio));
  renderer.domElement.setAttribute('aria-label', 'The moving figure; drag to turn, scroll to zoom');
  holder.prepend(renderer.domElement);

  const scene = new Scene();
  scene.background = new Color();
  scene.fog = new Fog(0, 4 * size, 11 * size);
  const camera = new PerspectiveCamera(35, 1, 0.02 * size, 60 * size);
  const controls = new OrbitControls(camera, renderer.domElement);
  controls.maxPolarAngle = 0.53 * Math.PI;
  controls.minDistance = 0.4 * size;
  controls.maxDistance = 20 * size;

  const sky = new HemisphereLight(0xffffff, 0xb8b0a4, 1.9);
  const sun = new DirectionalLight(0xffffff, 2.1);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.radius = 5;
  sun.shadow.bias = -0.0004;
  sun.shadow.normalBias = 0.02;
  const reach = 1.3 * size;
  Object.assign(sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 0.1, far: 8 * size });
  scene.add(sky, sun, sun.target);

  const shift = new Vector3();
  const stage = {
    scene,
    camera,
    controls,
    width: 0,
    height: 0,
    paint(theme) {
      scene.background.set(theme.sky);
      scene.fog.color.set(theme.sky);
      sky.intensity = theme.dark ? 1.2 : 1.9;
    },
    view(name) {
      // On a screen that is higher than wide the figure fits by its height anyway, but needs room at the sides.
      const wide = Math.max(1, 0.9 / Math.max(0.3, camera.aspect));
      camera.position.fromArray(VIEWS[name]).multiplyScalar(size * wide).add(controls.target);
      controls.update();
    },
    // Light and, if wanted, the camera move along with `point`.
    follow(point, withCamera) {
      sun.target.position.copy(point);
      sun.position.set(-0.9, 2.6, 1.1).multiplyScalar(size).add(point);
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
    },
    draw: () => renderer.render(scene, camera),
  };
  return stage;
}
