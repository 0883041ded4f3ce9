// Compiled and never run: what the package's types let a program say, and what they refuse.
import init, { Dynamics, Figure, type Motion, Walker, walk, type WalkOptions } from "solaris-motion";
import * as full from "solaris-motion/full";
import * as lean from "solaris-motion/lean";

await init();
const ann: Figure = Figure.human(1.65, 58);
const options: WalkOptions = { stepFrequency: 105, steps: 6, then: [{ stand: 1 }], stairs: { count: 3 }, style: { armSwing: 10 } };
const motion: Motion = walk(ann, options);
const tau: Float64Array = new Dynamics(ann).inverse(motion.q, motion.v, motion.a);
const table: string = motion.toCsv();
const body: Uint8Array = full.run(table).toGlb();
const walker = new Walker(ann);
walker.goTo(1, 2, 1.2);
const pose: Float64Array = new lean.Walker(lean.Figure.human(1.8, 80, undefined)).step(1 / 60);
const q: Float64Array = lean.walk(lean.Figure.human(1.8, 80), { speed: 1.2 }).q;

const laden: Figure = Figure.human(1.65, 58, undefined, { load: { right: 5 }, shorterLeg: { left: 0.01 } });

// @ts-expect-error: there is no such option.
walk(ann, { pase: 100 });
// @ts-expect-error: it is a number.
walk(ann, { steps: "6" });
// @ts-expect-error: it is one of two.
walk(ann, { loop: "round" });
// @ts-expect-error: tables are in the larger entries.
lean.walk(lean.Figure.human(1.8, 80)).toCsv();
// @ts-expect-error: so are bodies.
motion.toGlb();

export { body, laden, pose, q, tau };
