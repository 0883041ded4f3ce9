// What of the figure is under the pointer.

import type * as Three from 'three';
import type { Show } from './show.ts';
import { three } from './view.ts';

export interface Picked {
  link: number;
  // In the engine's picture (m): what `posePoint`, `poseDrag` and `alivePull` take.
  place: [number, number, number];
}

interface At {
  clientX: number;
  clientY: number;
}

// The line of sight through a point of the page.
export function sightLine(show: Show, { clientX, clientY }: At): Three.Raycaster | null {
  if (!show.picture) return null;
  const { camera, renderer } = show.picture.stage;
  const box = renderer.domElement.getBoundingClientRect();
  const at = new three.Vector2((2 * (clientX - box.left)) / box.width - 1, 1 - (2 * (clientY - box.top)) / box.height);
  const ray = new three.Raycaster();
  camera.updateMatrixWorld();
  ray.setFromCamera(at, camera);
  return ray;
}

// A place of the picture as the engine has it, and back.
export const outOf = ({ data }: Show, place: Three.Vector3): [number, number, number] => [place.x + data.origin[0], place.y + data.origin[1], place.z + data.origin[2]];
export const into = ({ data }: Show, place: ArrayLike<number>): Three.Vector3 =>
  new three.Vector3(place[0] - data.origin[0], place[1] - data.origin[1], place[2] - data.origin[2]);

// A skin that several links move: the viewer moves its points, three.js knows of no more than a mesh.
export type Skinned = Three.Mesh & { skeleton: Three.Skeleton };
export const isSkinned = (object: Three.Object3D): object is Skinned => (object as Skinned).skeleton !== undefined;

// The link with the greatest weight at three corners of a skin.
export function heaviest(mesh: Skinned, corners: number[]): Three.Bone | null {
  const [bones, weights] = [mesh.geometry.getAttribute('skinIndex'), mesh.geometry.getAttribute('skinWeight')];
  const sums = new Map<number, number>();
  for (const corner of corners) {
    for (let part = 0; part < 4; part += 1) {
      const bone = bones.getComponent(corner, part);
      sums.set(bone, (sums.get(bone) ?? 0) + weights.getComponent(corner, part));
    }
  }
  const [best] = [...sums].sort((a, b) => b[1] - a[1]);
  return best ? (mesh.skeleton.bones[best[0]] ?? null) : null;
}

export function pick(show: Show, event: At): Picked | null {
  const ray = sightLine(show, event);
  const body = show.picture?.body().group;
  if (!ray || !body) return null;
  const links = body.children.slice(0, show.data.links.length);
  body.updateMatrixWorld();
  for (const { object, face, point } of ray.intersectObject(body, true)) {
    if (object.userData.shows) continue;
    let link = -1;
    if (isSkinned(object) && face) link = links.indexOf(heaviest(object, [face.a, face.b, face.c]) as Three.Object3D);
    else if (object.parent) link = links.indexOf(object.parent);
    if (link < 0) {
      const away = links.map((one) => one.position.distanceTo(point));
      link = away.indexOf(Math.min(...away));
    }
    if (link >= 0) return { link, place: outOf(show, point) };
  }
  return null;
}
