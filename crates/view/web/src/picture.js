// The moving picture: figure, ground, forces and trail on the stage. Draws only when something has changed.

import { Vector3 } from 'three';
import { makeBody, mixAt } from './body.js';
import { makeForces } from './forces.js';
import { makeGround } from './ground.js';
import { makeHeights } from './heights.js';
import { makeStage } from './stage.js';
import { makeTrail } from './trail.js';

export function makePicture(holder, data, clock) {
  const stage = makeStage(holder, { size: data.size, half: data.camera.half });
  const parts = {
    ground: makeGround(data),
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
