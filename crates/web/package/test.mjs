// The package as it is built, in node: numbers that laws know, refusals.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import init, { Dynamics, Figure, Walker, walk } from "./dist/solaris_web.js";
import * as full from "./dist/full/solaris_web.js";
import * as lean from "./dist/lean/solaris_web.js";

const wasm = (path) => readFileSync(new URL(`./dist/${path}solaris_web_bg.wasm`, import.meta.url));
await init({ module_or_path: wasm("") });
await full.default({ module_or_path: wasm("full/") });
await lean.default({ module_or_path: wasm("lean/") });
const ann = Figure.human(1.65, 58);

test("a walk is carried by the ground", () => {
  const motion = walk(ann, { stepFrequency: 105, steps: 6 });
  const { nq, nv } = ann;
  assert.equal(motion.q.length, motion.length * nq);
  assert.equal(motion.tau.length, motion.length * nv);
  let push = 0;
  for (const link of motion.contacts) {
    const forces = motion.contact(link);
    for (let sample = 0; sample < motion.length; sample++) push += forces[9 * sample + 1];
  }
  // From standing to standing the mean force is the weight.
  assert.ok(Math.abs(push / motion.length / (58 * 9.80665) - 1) < 1e-3);
  assert.equal(motion.report.measures.steps, 6);
  assert.match(motion.toCsv(), /^time,root\.tx\.q,/);
  assert.match(motion.toBvh(), /^HIERARCHY/);
});

test("forces of a walk are those of inverse dynamics in the air", () => {
  const motion = walk(ann, { steps: 4 });
  const dynamics = new Dynamics(ann);
  const { nq, nv } = ann;
  const sample = 100;
  const of = (numbers, width) => numbers.slice(sample * width, (sample + 1) * width);
  const [q, v, a] = [of(motion.q, nq), of(motion.v, nv), of(motion.a, nv)];
  const tau = dynamics.inverse(q, v, a);
  const back = dynamics.forward(q, v, tau);
  assert.ok(back.every((x, i) => Math.abs(x - a[i]) < 1e-7));
  // Without the ground the root bears the weight; with it nothing.
  assert.ok(Math.abs(of(motion.tau, nv)[1]) < 1e-6 && tau[1] > 300);
  const matrix = dynamics.massMatrix(q);
  assert.ok(Math.abs(matrix[0] - 58) < 1e-9);
});

test("a run flies, a loop ends where it began", () => {
  const flown = walk(ann, { gait: "run", speed: 3, steps: 6 });
  assert.ok(flown.report.run !== null && flown.report.style === "run");
  const loop = walk(ann, { loop: "in_place", rate: 30, style: { armSwing: 10 } });
  const { nq } = ann;
  const [first, last] = [loop.q.slice(0, nq), loop.q.slice(-nq)];
  assert.ok(first.every((x, i) => Math.abs(x - last[i]) < 1e-6));
  assert.ok(Math.abs((loop.length - 1) / 30 - loop.time.at(-1)) < 1e-9);
});

test("a walker comes to a point, and a copy goes on alike", () => {
  const walker = new Walker(ann);
  walker.goTo(1, 2, 1.2);
  let q;
  for (let frame = 0; frame < 900; frame++) q = walker.step(1 / 60);
  assert.ok(walker.isStanding && Math.hypot(walker.place[0] - 1, walker.place[1] - 2) < 0.05);
  const poses = new Dynamics(ann).poses(q);
  assert.equal(poses.length, 7 * ann.links.length);
  walker.go(0, 1);
  const twin = walker.copy();
  assert.deepEqual(walker.step(0.1), twin.step(0.1));
});

test("the smallest entry walks alike", () => {
  const bea = lean.Figure.human(1.65, 58);
  const [one, other] = [new Walker(ann), new lean.Walker(bea)];
  for (const walker of [one, other]) walker.go(0.3, 1.1);
  for (let frame = 0; frame < 300; frame++) assert.deepEqual(one.step(1 / 60), other.step(1 / 60));
  for (const options of [{ steps: 5 }, { stepFrequency: 90, steps: 3, manner: "sad", then: [{ stand: 1 }, { steps: 2 }] }, { stairs: { count: 3 } }]) {
    const [usual, small] = [walk(ann, options), lean.walk(bea, options)];
    assert.deepEqual(small.q, usual.q);
    assert.deepEqual(small.tau, usual.tau);
    assert.deepEqual(small.contact("left_foot"), usual.contact("left_foot"));
  }
  assert.throws(() => lean.walk(bea, { manner: "proud", stepFrequency: 118 }), /of it holds/);
  assert.throws(() => lean.walk(bea, { gait: "run" }), /runs are in solaris-motion, not in/);
  assert.throws(() => lean.walk(bea, { loop: "moving" }), /loops are in/);
  assert.throws(() => lean.walk(bea, { determinants: 5 }), /determinants\) are in/);
  const text = ann.toText();
  assert.equal(lean.Figure.fromText(text).nv, ann.nv);
  assert.throws(() => lean.Figure.fromText("<robot/>", "urdf"), /with solaris-motion 'urdf'/);
});

test("a body with its motion is a GLB", () => {
  const { Figure, walk } = full;
  const loop = walk(Figure.human(1.65, 58), { loop: "moving", rate: 30 });
  const glb = loop.toGlb("stroll");
  const view = new DataView(glb.buffer, glb.byteOffset);
  assert.equal(view.getUint32(0, true), 0x46546c67);
  assert.equal(view.getUint32(8, true), glb.length);
  const document = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + view.getUint32(12, true))));
  assert.deepEqual(document.animations.map((clip) => clip.name), ["stroll"]);
  assert.equal(document.skins.length, 1);
});

test("figures from texts, and scenes", () => {
  const urdf = readFileSync(new URL("../../../fixtures/figures/arm.urdf", import.meta.url), "utf8");
  const arm = Figure.fromText(urdf, "urdf");
  assert.equal(Figure.fromText(arm.toText()).nv, arm.nv);
  assert.equal(arm.parents[0], -1);
  const osim = readFileSync(new URL("../../../fixtures/markers/leg.osim", import.meta.url), "utf8");
  assert.ok(full.Figure.fromText(osim, "osim").nv > 0);
  assert.deepEqual(full.walk(full.Figure.human(1.65, 58), { steps: 2 }).q, walk(ann, { steps: 2 }).q);
  const motion = full.run(
    'Scene(version: 1, duration: 1.0, figures: {"it": Figure(links: [Link(name: "rod", mass: 1.0, joint: Joint(name: "pivot", axes: [rx]), com: (0, 0, 1))])})',
  );
  assert.equal(motion.time.at(-1), 1);
  assert.match(motion.report.method, /adaptive/);
});

test("the page's program runs", async () => {
  const page = readFileSync(new URL("./README.md", import.meta.url), "utf8");
  const program = page.match(/```js\n(.*?)```/s)[1].replace('"solaris-motion"', JSON.stringify(import.meta.resolve("./dist/solaris_web.js")));
  // Modules are made ready once: that is done above, as in node.
  const source = `${program.replace(/^await init.*$/m, "")}\nexport { ann, motion, poses };`;
  const { ann, motion, poses } = await import(`data:text/javascript,${encodeURIComponent(source)}`);
  assert.equal(motion.tau.length, motion.length * ann.nv);
  assert.equal(poses.length, 7 * ann.links.length);
});

test("options are read from any object", () => {
  const usual = walk(ann, { stepFrequency: 100, steps: 3, style: { armSwing: 10 } }).q;
  const bare = Object.assign(Object.create(null), { stepFrequency: 100, steps: 3, style: { armSwing: 10, pelvicTilt: undefined } });
  assert.deepEqual(walk(ann, bare).q, usual);
  assert.deepEqual(walk(ann, { step_frequency: 100, steps: 3, style: { "arm-swing": 10 }, speed: null, label: undefined }).q, usual);
});

test("hands carry loads, and legs may differ", () => {
  const laden = Figure.human(1.65, 58, undefined, { load: { right: 5 }, shorterLeg: { left: 0.01 } });
  assert.ok(Math.abs(laden.mass - 63) < 1e-9);
  assert.ok(walk(laden, { steps: 4 }).length > 0);
  assert.ok(Math.abs(lean.Figure.human(1.65, 58, undefined, { load: { left: 2 } }).mass - 60) < 1e-9);
  const leaning = Figure.human(1.65, 58, undefined, { cane: "left" });
  const cane = walk(leaning, { stepFrequency: 85, steps: 4, caneLoad: 0.1 }).contact("cane");
  assert.ok(cane.some((up, i) => i % 9 === 1 && up > 40));
  assert.throws(() => walk(ann, { caneLoad: 0.1 }), /holds no cane/);
  assert.throws(() => Figure.human(1.65, 58, undefined, { load: { up: 1 } }), /left or right/);
  assert.throws(() => Figure.human(1.65, 58, undefined, { loads: {} }), /there is no 'loads'; did you mean 'load'/);
  assert.throws(() => Figure.human(1.65, 58, undefined, { shorterLeg: { left: "1 cm" } }), /shorterLeg\.left must be a number/);
});

test("what is wrong is said", () => {
  const says = (what, message) => assert.throws(what, (error) => error instanceof Error && message.test(error.message));
  says(() => Figure.human(9, 70), /height 9 m/);
  says(() => walk(ann, { stepFrequency: 300 }), /60 to 130/);
  says(() => walk(ann, { pase: 100 }), /the options: there is no 'pase'; .*stepFrequency/);
  says(() => walk(ann, { style: { armSwng: 5 } }), /did you mean arm-swing/);
  says(() => walk(ann, { stepfrequency: 90 }), /did you mean 'stepFrequency'/);
  says(() => walk(ann, { then: [{ steps: 2 }, { sped: 1 }] }), /then\[1\]: there is no 'sped'; did you mean 'speed'/);
  says(() => walk(ann, { speed: "fast" }), /speed must be a number; it is 'fast'/);
  says(() => walk(ann, { speed: NaN }), /speed .*NaN/);
  says(() => walk(ann, { steps: 2.5 }), /steps must be a whole number from 0 to 4294967295; it is 2\.5/);
  says(() => walk(ann, { seed: 2 ** 53 }), /seed must be a whole number from 0 to 9007199254740991; it is 9007199254740992/);
  says(() => walk(ann, { backward: [1] }), /backward must be true or false; it is an array/);
  says(() => walk(ann, { then: [{ steps: 2 }, { speed: true }] }), /then\[1\]\.speed must be a number; it is true/);
  says(() => walk(ann, { stairs: { rise: "1" } }), /stairs\.rise must be a number; it is '1'/);
  says(() => walk(ann, { stairs: { count: 1e9 } }), /stairs 1000000000: it must be/);
  says(() => walk(ann, { get steps() { throw new Error("no"); } }), /steps cannot be read/);
  says(() => walk(ann, { path: [[0, 1], [0]] }), /path\[1\] has 1 numbers; it must have 2: x, z/);
  says(() => walk(ann, { ground: [[0, "a"]] }), /ground\[0\]\[1\] must be a number; it is 'a'/);
  says(() => walk(ann, { gait: "hop" }), /gait must be 'walk' or 'run'; it is 'hop'/);
  says(() => walk(ann, "fast"), /the options must be a plain object; it is 'fast'/);
  says(() => walk(ann, { steps: 4, distance: 2 }), /steps and distance are both given/);
  says(() => Figure.fromText("Figure(nam: 1)"), /did you mean 'name'/);
  says(() => Figure.fromText("<OpenSimDocument/>", "osim"), /solaris-motion\/full/);
  says(() => new Dynamics(ann).inverse(new Float64Array(3), new Float64Array(66), new Float64Array(66)), /66/);
  says(() => new Walker(ann).step(9), /0\.25 s/);
});
