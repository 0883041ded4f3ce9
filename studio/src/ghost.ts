// A motion that was kept, faintly beside or within the one that is shown.

import type * as Three from 'three';
import type { App } from './app.ts';
import { follow } from './curves.ts';
import { view, type Data, type Frame, type Part } from './view.ts';

const FAINT = 0.32;

export interface Ghost {
  // Null: nobody.
  keep(data: Data | null): void;
  // How it goes along, and how far to its right it stands (m).
  set(by: 'time' | 'share', beside: number): void;
  frame(): Frame | null;
}

export function makeGhost(app: App): Ghost {
  const { show } = app;
  let [data, part, at, by, beside]: [Data | null, Part | null, ((by: 'time' | 'share') => Frame) | null, 'time' | 'share', number] = [null, null, null, 'time', 0];

  const take = (): void => {
    part?.group.removeFromParent();
    part?.group.traverse((object) => {
      const { geometry, material } = object as Partial<Three.Mesh>;
      geometry?.dispose();
      for (const one of [material].flat()) {
        (one as Three.MeshStandardMaterial | undefined)?.map?.dispose();
        one?.dispose();
      }
    });
    part = null;
  };
  function pose(): void {
    if (!data || !part || !at) return;
    // Within itself it would not be seen.
    part.group.visible = !show.isLive() && data !== show.data;
    part.pose(at(by));
    // Each motion counts from an origin of its own.
    part.group.position.set(...(data.origin.map((x, axis) => x - show.data.origin[axis]) as [number, number, number]));
    part.group.position.x -= beside;
    show.picture?.touch();
  }
  show.clock.onChange(() => {
    if (!show.isLive()) pose();
  });
  show.onShow(pose);
  view.onThemeChange(() => part?.paint(view.readTheme()));

  return {
    keep(next) {
      take();
      data = next;
      show.picture?.touch();
      if (!data || !show.picture) return;
      part = view.makeBody(data);
      part.group.name = 'ghost';
      const meshes: Three.Mesh[] = [];
      part.group.traverse((object) => {
        object.raycast = () => {};
        if ((object as Three.Mesh).isMesh) meshes.push(object as Three.Mesh);
      });
      for (const mesh of meshes) {
        mesh.castShadow = false;
        const material = mesh.material as Three.Material;
        Object.assign(material, { transparent: true, opacity: FAINT });
        // Its depth first, so that only its nearest side shows through.
        const depth = mesh.clone();
        depth.material = Object.assign(material.clone(), { colorWrite: false });
        depth.raycast = () => {};
        [depth.renderOrder, mesh.renderOrder] = [0.4, 0.5];
        mesh.parent!.add(depth);
      }
      part.paint(view.readTheme());
      show.picture.stage.scene.add(part.group);
      at = follow(data, show.clock);
      pose();
    },
    set(way, far) {
      [by, beside] = [way, far];
      pose();
    },
    frame: () => at?.(by) ?? null,
  };
}
