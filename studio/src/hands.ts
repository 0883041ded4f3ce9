// Hands on the picture: a click chooses, a drag with Shift pulls in the plane that faces the camera.

import { into, outOf, pick, sightLine, type Picked } from './pick.ts';
import type { Show } from './show.ts';
import { byId } from './ui/dom.ts';
import { three } from './view.ts';

// By how much a click may wander (pixels).
const STILL = 5;

export interface Hands {
  // Whether this panel has the picture.
  active(): boolean;
  picked(what: Picked): void;
  // A pull begins: at what, where.
  begin(what: Picked): void;
  move(place: [number, number, number]): void;
  end(given: boolean): void;
}

export function makeHands(show: Show, hands: Hands): void {
  const holder = byId('picture');
  let down: { x: number; y: number } | null = null;
  let plane: InstanceType<typeof three.Plane> | null = null;
  const at = new three.Vector3();
  const stop = (given: boolean): void => {
    if (!plane) return;
    plane = null;
    hands.end(given);
  };
  // Before the camera has it.
  holder.addEventListener('pointerdown', (event) => {
    const canvas = show.picture?.stage.renderer.domElement;
    if (!hands.active() || event.button !== 0 || event.target !== canvas || !canvas) return;
    if (!event.shiftKey) {
      down = { x: event.clientX, y: event.clientY };
      return;
    }
    event.stopPropagation();
    event.preventDefault();
    const what = pick(show, event);
    if (!what) return;
    const facing = show.picture!.stage.camera.getWorldDirection(new three.Vector3());
    plane = new three.Plane().setFromNormalAndCoplanarPoint(facing, into(show, what.place));
    canvas.setPointerCapture(event.pointerId);
    hands.begin(what);
  }, true);
  holder.addEventListener('pointermove', (event) => {
    if (!plane) return;
    event.stopPropagation();
    const ray = sightLine(show, event);
    if (ray?.ray.intersectPlane(plane, at)) hands.move(outOf(show, at));
  }, true);
  holder.addEventListener('pointerup', (event) => {
    if (plane) {
      event.stopPropagation();
      stop(true);
    } else if (down && hands.active() && Math.hypot(event.clientX - down.x, event.clientY - down.y) < STILL) {
      const what = pick(show, event);
      if (what) hands.picked(what);
    }
    down = null;
  }, true);
  holder.addEventListener('pointercancel', () => stop(false), true);
  document.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') stop(false);
  });
}
