// The moving picture: figure, ground, forces and trail on the stage. Draws only when something has changed. Another motion can take the place
// of the one that is shown.

import { Vector3 } from 'three';
import { makeBody, mixAt } from './body.js';
import { makeForces } from './forces.js';
import { makeGround } from './ground.js';
import { makeHeights } from './heights.js';
import { makeRelief } from './relief.js';
import { makeStage } from './stage.js';
import { makeTrail } from './trail.js';

// How many times of the motion, and how many places between figure and camera, are tried for whether the ground is in between.
const TIMES = 24;
const PLACES = 24;

// Whether the place under the figure is in sight at any time from so far from what the camera looks at.
function sight({ aim }, height) {
  const frames = aim.length / 3;
  const [at, way] = [new Vector3(), new Vector3()];
  return (offset) =>
    Array.from({ length: TIMES }, (_, i) => Math.round((i * (frames - 1)) / (TIMES - 1))).every((frame) => {
      at.fromArray(aim, 3 * frame);
      way.copy(offset).add(at);
      at.y = height(at.x, at.z);
      way.sub(at);
      return Array.from({ length: PLACES }, (_, i) => (i + 1) / PLACES).every((share) => {
        const [x, y, z] = at.toArray().map((from, axis) => from + share * way.getComponent(axis));
        return y >= (height(x, z) ?? -Infinity);
      });
    });
}

// Everything on the stage that belongs to one motion; `body`, `ground`: what is there already of the same person and floor.
function makeParts(holder, data, { body, ground }) {
  return {
    ground: ground ?? (data.ground.relief ? makeRelief(data) : makeGround(data)),
    heights: makeHeights(data),
    body: body ?? makeBody(data),
    forces: makeForces(data, holder),
    trail: makeTrail(data),
  };
}

// Gives back what a part holds in the memory of the graphics.
function dispose({ group }) {
  group.traverse((object) => {
    object.geometry?.dispose();
    object.skeleton?.dispose();
    for (const material of [object.material].flat().filter(Boolean)) {
      material.map?.dispose();
      material.dispose();
    }
  });
}

export function makePicture(holder, data, clock) {
  const stage = makeStage(holder);
  let [parts, motion, time, theme, forget] = [{}, null, null, null, () => {}];
  let stale = true;
  let follow = true;
  const hidden = new Set();
  // Parts that are shown no more.
  const gone = [];
  const touch = () => (stale = true);
  const target = new Vector3();
  // The camera looks at the middle of the box that has the figure in it at any time.
  const look = (frame) => mixAt(motion.camera.aim, frame, target);

  stage.controls.addEventListener('change', touch);
  new ResizeObserver(() => {
    stage.resize();
    touch();
  }).observe(holder);

  const picture = {
    stage,
    // The body that is drawn, and the data it is drawn from.
    body: () => parts.body,
    data: () => motion,
    // Shows another motion by another clock; `still`: the camera stays where it is.
    load(next, nextClock, { still = false } = {}) {
      forget();
      const kept = {};
      for (const [name, part] of Object.entries(parts)) {
        if (part.load?.(next)) {
          kept[name] = part;
          continue;
        }
        part.clear?.();
        part.group.removeFromParent();
        gone.push(part);
      }
      [motion, time] = [next, nextClock];
      parts = makeParts(holder, motion, kept);
      for (const [name, part] of Object.entries(parts)) {
        part.group.visible = !hidden.has(name);
        stage.scene.add(part.group);
        if (theme && part !== kept[name]) part.paint(theme);
      }
      const sees = motion.ground.relief ? sight(motion.camera, parts.ground.height) : () => true;
      stage.frame({ size: motion.size, half: motion.camera.half, climbs: parts.ground.climbs, sees });
      forget = time.onChange(touch);
      stage.follow(look(time.frame()), true);
      stage.resize();
      if (!still) stage.view(stage.named() ?? 'angle');
      touch();
    },
    touch,
    paint(next) {
      theme = next;
      stage.paint(theme);
      Object.values(parts).forEach((part) => part.paint(theme));
      touch();
    },
    view(name) {
      stage.controls.target.copy(look(time.frame()));
      stage.view(name);
      touch();
    },
    show(part, visible) {
      if (visible) hidden.delete(part);
      else hidden.add(part);
      parts[part].group.visible = visible;
      touch();
    },
    // Calls `listener` when the reader takes the camera into the own hand.
    onTurn: (listener) => stage.controls.addEventListener('start', listener),
    setFollow(value) {
      follow = value;
      touch();
    },
    // Where the figure is in the picture now: the least and greatest x and y, from 0 to 1, of all that is drawn of it.
    outline() {
      parts.body.pose(time.frame());
      stage.follow(look(time.frame()), follow);
      stage.camera.updateMatrixWorld();
      return parts.body.outline(stage.camera);
    },
    // Height of the drawn ground at a place, in the data's coordinates.
    ground: (x, z) => parts.ground.height(x, z),
    // Draws where something has changed, and says whether it did.
    draw() {
      if (stale) stage.pace.move(performance.now());
      else if (!stage.pace.rest()) return false;
      stale = false;
      const frame = time.frame();
      parts.body.pose(frame);
      parts.forces.pose(frame);
      parts.trail.pose(frame);
      stage.follow(look(frame), follow);
      parts.ground.face(stage.camera, stage.controls.target, target);
      parts.heights.face(stage.camera, stage.controls.target);
      stage.draw();
      // What the next one is drawn with, compiled, is that of the one before: it goes when that is drawn.
      gone.splice(0).forEach(dispose);
      parts.forces.label(stage.camera, stage.width, stage.height);
      // Following the figure moves the camera, which reports a change that this drawing has already shown.
      stale = false;
      return true;
    },
  };
  picture.load(data, clock);
  return picture;
}
