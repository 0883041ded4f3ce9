// The moving picture: figure, ground, forces and trail on the stage. Draws only when something has changed.

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

export function makePicture(holder, data, clock) {
  const ground = data.ground.relief ? makeRelief(data) : makeGround(data);
  const sees = data.ground.relief ? sight(data.camera, ground.height) : () => true;
  const stage = makeStage(holder, { size: data.size, half: data.camera.half, climbs: ground.climbs, sees });
  const parts = {
    ground,
    heights: makeHeights(data),
    body: makeBody(data),
    forces: makeForces(data, holder),
    trail: makeTrail(data),
  };
  for (const part of Object.values(parts)) stage.scene.add(part.group);

  let stale = true;
  let follow = true;
  const touch = () => (stale = true);
  const target = new Vector3();
  // The camera looks at the middle of the box that has the figure in it at any time.
  const look = (frame) => mixAt(data.camera.aim, frame, target);

  clock.onChange(touch);
  stage.controls.addEventListener('change', touch);
  new ResizeObserver(() => {
    stage.resize();
    touch();
  }).observe(holder);
  stage.follow(look(clock.frame()), true);
  stage.resize();
  stage.view('angle');

  return {
    paint(theme) {
      stage.paint(theme);
      Object.values(parts).forEach((part) => part.paint(theme));
      touch();
    },
    view(name) {
      stage.controls.target.copy(look(clock.frame()));
      stage.view(name);
      touch();
    },
    show(part, visible) {
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
      parts.body.pose(clock.frame());
      stage.follow(look(clock.frame()), follow);
      stage.camera.updateMatrixWorld();
      return parts.body.outline(stage.camera);
    },
    // Height of the drawn ground at a place, in the data's coordinates.
    ground: ground.height,
    draw() {
      if (!stale) return;
      stale = false;
      const frame = clock.frame();
      parts.body.pose(frame);
      parts.forces.pose(frame);
      parts.trail.pose(frame);
      stage.follow(look(frame), follow);
      parts.ground.face(stage.camera, stage.controls.target);
      parts.heights.face(stage.camera, stage.controls.target);
      stage.draw();
      parts.forces.label(stage.camera, stage.width, stage.height);
      // Following the figure moves the camera, which reports a change that this drawing has already shown.
      stale = false;
    },
  };
}
