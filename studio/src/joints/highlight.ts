// The link that is chosen, in the picture.

import type * as Three from 'three';
import { heaviest, isSkinned } from '../pick.ts';
import type { Show } from '../show.ts';
import { three, view } from '../view.ts';

const COLOUR = '#009e73';

export interface Highlight {
  link: number | null;
  // Whether it is seen.
  show(visible: boolean): void;
}

// Follows whatever is shown.
export function makeHighlight(show: Show): Highlight {
  let link: number | null = null;
  let visible = false;
  let made: Three.Object3D[] = [];
  const clear = (): void => {
    for (const object of made) {
      object.removeFromParent();
      ((object as Three.Mesh).material as Three.Material).dispose();
    }
    made = [];
  };
  const material = (): Three.MeshBasicMaterial =>
    new three.MeshBasicMaterial({ color: COLOUR, transparent: true, opacity: view.readTheme().dark ? 0.75 : 0.6, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2, depthWrite: false });

  // A copy of what is drawn of the link, over it.
  function draw(): void {
    clear();
    const body = show.picture?.body().group;
    const bone = link === null || !visible ? undefined : body?.children[link];
    if (!body || !bone || link === null || link >= show.data.links.length) return;
    const add = (copy: Three.Mesh, parent: Three.Object3D): void => {
      copy.material = material();
      copy.castShadow = copy.receiveShadow = false;
      copy.userData.shows = true;
      parent.add(copy);
      made.push(copy);
    };
    for (const part of [...bone.children] as Three.Mesh[]) add(part.clone(), bone);
    for (const skin of body.children.filter(isSkinned)) {
      const corners = skin.geometry.getIndex()!;
      const own: number[] = [];
      for (let i = 0; i < corners.count; i += 3) {
        const face = [corners.getX(i), corners.getX(i + 1), corners.getX(i + 2)];
        if (heaviest(skin, face) === bone) own.push(...face);
      }
      if (own.length === 0) continue;
      // Without what throws its shadow.
      const copy = new three.Mesh();
      copy.frustumCulled = false;
      copy.geometry = new three.BufferGeometry();
      for (const [name, attribute] of Object.entries(skin.geometry.attributes)) copy.geometry.setAttribute(name, attribute);
      copy.geometry.setIndex(own);
      add(copy, body);
    }
    show.picture?.touch();
  }
  show.onShow(draw);
  return {
    get link() {
      return link;
    },
    set link(next) {
      link = next;
      draw();
      show.picture?.touch();
    },
    show(next) {
      visible = next;
      draw();
      show.picture?.touch();
    },
  };
}
