// In the picture: points that are picked on the figure, the line between two of them, and paths of links.

import type * as Three from 'three';
import type { App } from './app.ts';
import { frameAt, placeOf, type Spot } from './curves.ts';
import { into, pick } from './pick.ts';
import { el } from './ui/dom.ts';
import { three, view } from './view.ts';

// A pointer that moved by no more has clicked (pixels).
const STILL = 5;

export interface Measure {
  // Picks two points, one after the other.
  pick(): void;
  stop(): void;
  clear(): void;
  spots(): Spot[];
  trails(links: string[]): void;
}

export function makeMeasure(app: App, changed: (picking: boolean) => void): Measure {
  const { show } = app;
  const group = new three.Group();
  group.name = 'measure';
  const words = el('span', { class: 'distance', hidden: true });
  let [spots, picking, links]: [Spot[], boolean, string[]] = [[], false, []];
  const paths: Three.Line[] = [];
  const dots = [0, 1].map(() => {
    const dot = new three.Mesh(new three.SphereGeometry(1, 16, 10), new three.MeshBasicMaterial({ depthTest: false, transparent: true }));
    dot.renderOrder = 6;
    group.add(dot);
    return dot;
  });
  const points = new three.BufferAttribute(new Float32Array(6), 3);
  const line = new three.Line(new three.BufferGeometry().setAttribute('position', points), new three.LineBasicMaterial({ depthTest: false, transparent: true }));
  line.renderOrder = 6;
  line.frustumCulled = false;
  group.add(line);

  const [a, b] = [new three.Vector3(), new three.Vector3()];
  function pose(): void {
    if (spots.length === 0) return;
    const frame = show.clock.frame();
    const places = spots.map((spot, i) => placeOf(show.data, spot, frame, [a, b][i]));
    dots.forEach((dot, i) => {
      dot.visible = Boolean(places[i]);
      if (places[i]) dot.position.copy(places[i]!);
      dot.scale.setScalar(0.008 * show.data.size);
    });
    const whole = places.length === 2 && places.every(Boolean);
    line.visible = whole;
    words.hidden = !whole;
    if (whole) {
      a.toArray(points.array, 0);
      b.toArray(points.array, 3);
      points.needsUpdate = true;
      words.textContent = `${a.distanceTo(b).toFixed(3)} m`;
    }
    show.picture?.touch();
  }
  // The words stand beside the middle of the line, wherever the camera is.
  function place(): void {
    if (!words.hidden && show.picture) {
      const { camera, width, height } = show.picture.stage;
      const middle = a.clone().add(b).multiplyScalar(0.5).project(camera);
      words.style.transform = `translate(${((1 + middle.x) / 2) * width}px, ${((1 - middle.y) / 2) * height}px)`;
    }
    if (!words.hidden) requestAnimationFrame(place);
  }

  function trails(): void {
    for (const path of paths.splice(0)) {
      path.removeFromParent();
      path.geometry.dispose();
      (path.material as Three.Material).dispose();
    }
    const { data } = show;
    const theme = view.readTheme();
    for (const name of show.isLive() ? [] : links) {
      const link = data.links.find((one) => one.name === name);
      if (!link) continue;
      const spot = { link: name, at: new three.Vector3() };
      const places = Array.from(data.time, (_, i) => placeOf(data, spot, frameAt(i), new three.Vector3())!);
      const path = new three.Line(new three.BufferGeometry().setFromPoints(places), new three.LineBasicMaterial({ color: theme.line[link.side] ?? theme.ink }));
      path.name = 'trail';
      path.frustumCulled = false;
      paths.push(path);
      group.add(path);
    }
    show.picture?.touch();
  }
  function paint(): void {
    const { ink } = view.readTheme();
    [...dots, line].forEach(({ material }) => (material as Three.MeshBasicMaterial).color.set(ink));
    trails();
  }

  // Which point of which link is under the pointer.
  function under(event: PointerEvent): Spot | null {
    const found = pick(show, event);
    const bone = found && show.picture?.body().group.children[found.link];
    return bone ? { link: show.data.links[found.link].name, at: bone.worldToLocal(into(show, found.place)) } : null;
  }

  const holder = document.getElementById('picture')!;
  let down: PointerEvent | null = null;
  holder.addEventListener('pointerdown', (event) => (down = event), true);
  holder.addEventListener('pointerup', (event) => {
    if (!picking || !down || Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) > STILL) return;
    const spot = under(event);
    if (!spot) return;
    spots = spots.length < 2 ? [...spots, spot] : [spot];
    if (spots.length === 2) stop();
    pose();
    requestAnimationFrame(place);
    changed(picking);
  }, true);
  // While points are picked a click is for nothing else.
  holder.addEventListener('click', (event) => picking && event.stopImmediatePropagation(), true);
  document.addEventListener('keydown', ({ key }) => {
    if (key !== 'Escape' || !picking) return;
    stop();
    changed(picking);
  });
  function stop(): void {
    picking = false;
    holder.classList.remove('picking');
  }

  if (show.picture) {
    show.picture.stage.scene.add(group);
    document.getElementById('over')!.append(words);
  }
  dots.forEach((dot) => (dot.visible = false));
  line.visible = false;
  paint();
  view.onThemeChange(paint);
  show.clock.onChange(pose);
  show.onShow(() => {
    trails();
    pose();
    changed(picking);
  });
  return {
    pick() {
      clear();
      picking = true;
      holder.classList.add('picking');
    },
    stop,
    clear,
    spots: () => spots,
    trails(names) {
      links = names;
      trails();
    },
  };
  function clear(): void {
    spots = [];
    [...dots, line].forEach((object) => (object.visible = false));
    words.hidden = true;
    show.picture?.touch();
  }
}
