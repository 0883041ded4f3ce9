// The moving picture: figure, ground, forces and trail on the stage. Draws only when something has changed.

import { Vector3 } from 'three';
import { makeBody, rootAt } from './body.js';
import { makeForces } from './forces.js';
import { makeGround } from './ground.js';
import { makeStage } from './stage.js';
import { makeTrail } from './trail.js';

export function makePicture(holder, data, clock) {
  const stage = makeStage(holder, data.size);
  const parts = {
    ground: makeGround(data),
    body: makeBody(data),
    forces: makeForces(data, holder),
    trail: makeTrail(data),
  };
  for (const part of Object.values(parts)) stage.scene.add(part.group);

  let stale = true;
  let follow = true;
  const touch = () => (stale = true);
  const target = new Vector3();
  // The camera looks at the middle of the figure's height and follows the root along the ground.
  // Without a ground it follows the root upwards and downwards, too.
  const above = data.middle - data.root[1];
  const look = ({ index, next, fraction }) => {
    rootAt(data, index, next, fraction, target);
    target.y = data.ground.solid ? data.middle : target.y + above;
    return target;
  };

  clock.onChange(touch);
  stage.controls.addEventListener('change', touch);
  new ResizeObserver(() => {
    stage.resize();
    touch();
  }).observe(holder);
  stage.resize();
  stage.follow(look(clock.frame()), true);
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
    draw() {
      if (!stale) return;
      stale = false;
      const frame = clock.frame();
      parts.body.pose(frame);
      parts.forces.pose(frame);
      parts.trail.pose(frame);
      stage.follow(look(frame), follow);
      parts.ground.face(stage.camera, stage.controls.target);
      stage.draw();
      parts.forces.label(stage.camera, stage.width, stage.height);
      // Following the figure moves the camera, which reports a change that this drawing has already shown.
      stale = false;
    },
  };
}
