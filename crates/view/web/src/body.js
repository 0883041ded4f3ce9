// The figure: one group a link, moved to the link's pose.

import { Group, Mesh, MeshStandardMaterial, Quaternion, Vector3 } from 'three';
import { geometry } from './shapes.js';
import { makePerson } from './person.js';
import { makeLink, makeSkin } from './skin.js';

export function makeBody(first) {
  let data = first;
  const group = new Group();
  const materials = {};
  for (const side of ['left', 'right', 'middle']) {
    materials[side] = new MeshStandardMaterial({ roughness: 0.62, metalness: 0 });
  }
  // One person's skin has all links, that of one of several theirs.
  const skins = data.body ? [data.body] : (data.bodies ?? []);
  const until = ({ first = 0, places }) => first + places.length / 3;
  const dressed = (link) => skins.some((skin) => link >= (skin.first ?? 0) && link < until(skin));
  const links = data.links.map((link, index) => {
    const body = makeLink();
    // A person's skin is in place of all shapes.
    for (const part of dressed(index) ? [] : link.parts) {
      const mesh = new Mesh(geometry(part), materials[link.side]);
      mesh.position.fromArray(part.at);
      mesh.quaternion.fromArray(part.turn);
      mesh.castShadow = true;
      mesh.receiveShadow = true;
      body.add(mesh);
    }
    group.add(body);
    return body;
  });

  const people = skins.map((skin) => makePerson(skin, links.slice(skin.first ?? 0, until(skin))));
  for (const { mesh } of people) group.add(mesh);
  for (const { parent, child, offset } of data.skins) {
    if (dressed(parent)) continue;
    const [upper, lower] = [data.links[parent], data.links[child]];
    group.add(makeSkin(upper, lower, [links[parent], links[child]], offset, materials[lower.side]));
  }

  const root = new Vector3();
  const from = new Vector3();
  const turn = new Quaternion();
  const next = new Quaternion();
  const count = links.length;

  // The least and greatest x and y of all corners of the shapes, from 0 to 1 in the picture.
  const point = new Vector3();
  function outline(camera) {
    group.updateMatrixWorld();
    const edges = [Infinity, Infinity, -Infinity, -Infinity];
    group.traverse((mesh) => {
      // Skins between shapes reach nowhere that the shapes do not, and what throws a person's shadow nowhere that the person does not.
      if (!mesh.isMesh || mesh.isSkinnedMesh || people.some((person) => mesh.parent === person.mesh)) return;
      const { count: corners } = mesh.geometry.attributes.position;
      for (let i = 0; i < corners; i += 1) {
        mesh.getVertexPosition(i, point).applyMatrix4(mesh.matrixWorld).project(camera);
        const [x, y] = [(1 + point.x) / 2, (1 - point.y) / 2];
        edges.splice(0, 4, Math.min(edges[0], x), Math.min(edges[1], y), Math.max(edges[2], x), Math.max(edges[3], y));
      }
    });
    return edges;
  }

  return {
    group,
    outline,
    // Moves as another motion of the same person says, where it is one: says whether it does.
    load(next) {
      const same = next.body !== undefined && next.body === data.body && next.links.length === links.length;
      if (same) data = next;
      return same;
    },
    paint(theme) {
      for (const [side, material] of Object.entries(materials)) material.color.set(theme.body[side]);
      for (const person of people) person.paint(theme);
    },
    // Between two frames positions and quaternions are interpolated linearly: the frames are 1/60 s apart or less than
    // that, and successive quaternions never change their sign.
    pose({ index, next: after, fraction }) {
      rootAt(data, index, after, fraction, root);
      links.forEach((body, link) => {
        const a = index * count + link;
        const b = after * count + link;
        from.fromArray(data.positions, 3 * a);
        body.position.fromArray(data.positions, 3 * b).sub(from).multiplyScalar(fraction).add(from).add(root);
        turn.fromArray(data.turns, 4 * a);
        next.fromArray(data.turns, 4 * b);
        body.quaternion
          .set(
            turn.x + (next.x - turn.x) * fraction,
            turn.y + (next.y - turn.y) * fraction,
            turn.z + (next.z - turn.z) * fraction,
            turn.w + (next.w - turn.w) * fraction,
          )
          .normalize();
      });
      for (const person of people) person.pose();
    },
  };
}

// A point of `points`, three numbers a frame, between two frames.
export function mixAt(points, { index, next, fraction }, out) {
  for (let i = 0; i < 3; i += 1) {
    const a = points[3 * index + i];
    out.setComponent(i, a + (points[3 * next + i] - a) * fraction);
  }
  return out;
}

// Position of the root link, to which the links' positions and the centre of mass are relative.
export const rootAt = (data, index, next, fraction, out) => mixAt(data.root, { index, next, fraction }, out);
