// The arrow of a pull: a line from the point that is pulled to where it is pulled, and its newtons.

import { into } from './pick.ts';
import type { Show } from './show.ts';
import { byId, el, number } from './ui/dom.ts';
import { three, view } from './view.ts';

export interface Arrow {
  // From a place (m) by a force (N) that draws it to another; or nothing pulls.
  draw(pull: { to: ArrayLike<number>; from: ArrayLike<number>; force: ArrayLike<number> } | null): void;
}

export function makeArrow(show: Show): Arrow {
  const label = el('div', { class: 'force pull-label' });
  const line = new three.Line(new three.BufferGeometry().setFromPoints([new three.Vector3(), new three.Vector3()]), new three.LineBasicMaterial({ depthTest: false, transparent: true }));
  const tip = new three.Mesh(new three.SphereGeometry(0.018), new three.MeshBasicMaterial({ depthTest: false, transparent: true }));
  const arrow = new three.Group().add(line, tip);
  line.renderOrder = tip.renderOrder = 10;
  line.frustumCulled = false;
  return {
    draw(pull) {
      const { picture } = show;
      if (!picture) return;
      if (!pull) {
        if (!arrow.parent) return;
        label.remove();
        arrow.removeFromParent();
        picture.touch();
        return;
      }
      const to = into(show, pull.to);
      line.geometry.setFromPoints([into(show, pull.from), to]);
      tip.position.copy(to);
      const colour = view.readTheme().ink;
      line.material.color.set(colour);
      tip.material.color.set(colour);
      picture.stage.scene.add(arrow);
      byId('over').append(label);
      const seen = to.clone().project(picture.stage.camera);
      label.textContent = `${number(Math.hypot(...Array.from(pull.force)), 0)} N`;
      label.style.transform = `translate(${((1 + seen.x) / 2) * picture.stage.width + 10}px, ${((1 - seen.y) / 2) * picture.stage.height - 10}px)`;
      picture.touch();
    },
  };
}
