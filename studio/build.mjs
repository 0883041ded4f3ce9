// Builds dist/studio.html: one file with the engine, the page's own code and what it stands on. The engine is compiled before, by
// `cargo xtask studio`. With --quick nothing is made small: for trying things out.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { Encoder } from './node_modules/lzma1/lib/encoder.js';
import { pack, unpack } from './src/pack/lzma.mjs';
import { decode, encode } from './src/pack/text.mjs';
import { join as joined, split } from './src/pack/wasm.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '..');
const quick = process.argv.includes('--quick');
const [dist, bound] = [join(here, 'dist'), join(here, 'dist/engine')];
mkdirSync(bound, { recursive: true });

// --- the engine
const target = process.env.CARGO_TARGET_DIR ?? join(root, 'target');
const compiled = process.env.STUDIO_ENGINE ?? join(target, 'wasm32-unknown-unknown/web/solaris_web.wasm');
const run = (program, options) => execFileSync(program, options, { cwd: here, stdio: ['ignore', 'inherit', 'inherit'] });
run(process.env.WASM_BINDGEN ?? 'wasm-bindgen', ['--target', 'web', '--out-dir', bound, '--out-name', 'engine', compiled]);
// What rustc's target has; the optimizer assumes less.
const has = ['bulk-memory', 'nontrapping-float-to-int', 'sign-ext', 'mutable-globals', 'reference-types', 'multivalue'];
const plain = join(bound, 'engine_bg.wasm');
// Making it small takes minutes: what was made of the same bytes is kept.
const hash = createHash('sha256').update(readFileSync(plain)).digest('hex').slice(0, 16);
const small = join(dist, `${hash}.wasm`);
if (!quick && !existsSync(small)) {
  const optimizer = process.env.WASM_OPT ?? join(here, 'node_modules/.bin/wasm-opt');
  run(optimizer, ['-Oz', ...has.map((feature) => `--enable-${feature}`), plain, '-o', small]);
}
const engine = quick ? readFileSync(plain) : readFileSync(small);

// --- the code
// Libraries of which something is in it.
const used = new Set();
const bundle = async (entry, options = {}) => {
  const result = await build({
    absWorkingDir: here,
    entryPoints: [entry],
    outdir: 'out',
    bundle: true,
    write: false,
    minify: !quick,
    format: 'iife',
    target: 'es2022',
    charset: 'ascii',
    legalComments: 'none',
    metafile: true,
    loader: { '.ron': 'text' },
    ...options,
  });
  for (const input of Object.keys(result.metafile.inputs)) {
    const [, name] = /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(input) ?? [];
    if (name) used.add(name);
  }
  return result.outputFiles.map(({ text }) => text);
};
const [boot] = await bundle('src/boot.js');
// The style of the panels comes with their code; the page is seen with its own before.
const [studio, panels] = await bundle('src/main.ts');
const [style] = await bundle('src/style.css');
// The engine is handed to it: it asks for no file.
const [worker] = await bundle('src/engine/worker.ts', { define: { 'import.meta.url': '""' } });
const assets = join(root, 'crates/view/assets');
const viewer = readFileSync(join(assets, 'viewer.js'), 'utf8');
// Whoever hands on the page hands on these libraries: their licences travel in it. Those of the viewer stand in its own bundle.
const licences = [...used].sort().map((name) => {
  const folder = join(here, 'node_modules', name);
  const { version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const licence = readdirSync(folder).find((file) => /^licen[cs]e/i.test(file));
  if (!licence) throw new Error(`${name} comes without a text of its licence`);
  return `${name} ${version}\n\n${readFileSync(join(folder, licence), 'utf8').trim()}`;
});
const code = Buffer.from([viewer, `${studio}\n/*!\n${licences.join('\n\n')}\n*/`, worker, readFileSync(join(assets, 'viewer.css'), 'utf8'), panels].join('\0'));

// --- the page
const same = (a, b) => Buffer.compare(Buffer.from(a), Buffer.from(b)) === 0;
// `size`: how many bytes it is in the end.
const held = (id, packed, size) => {
  const text = encode(packed);
  if (!same(decode(text, packed.length), packed)) throw new Error(`${id} does not come out as it went in`);
  return `<script type="text/plain" id="${id}" data-packed="${packed.length}" data-size="${size}">${text}</script>`;
};
const packedCode = pack([code], Encoder);
const packedEngine = pack(split(engine), Encoder);
if (!same(unpack(packedCode)[0], code) || !same(joined(unpack(packedEngine), engine.length), engine)) throw new Error('what was packed does not come out as it went in');
// What every page has stands in the template of pages.
const page = readFileSync(join(assets, 'page.html'), 'utf8');
const cut = (from, to) => {
  const [begins, ends] = [page.indexOf(from), page.indexOf(to)];
  if (begins < 0 || ends < begins) throw new Error(`the template of pages has nothing from ${from} to ${to}`);
  return page.slice(begins, ends).trimEnd();
};
const values = {
  legend: cut('<div class="legend"', '<button id="studio"').replace('{{legend}}', ''),
  keys: cut('<dt><kbd>Space', '<dt>Drag'),
  gestures: cut('<dt>Drag', '<dt>Click a curve'),
  nothing: cut('<div id="no-picture"', '<div id="no-studio"'),
  bar: cut('<div class="bar"', '<aside'),
  style: `${readFileSync(join(assets, 'viewer.css'), 'utf8')}\n${style}`,
  boot,
  code: held('code', packedCode, code.length),
  engine: held('engine', packedEngine, engine.length),
};
const html = readFileSync(join(here, 'src/page.html'), 'utf8').replace(/\{\{(\w+)\}\}/g, (_, name) => values[name]);
writeFileSync(join(dist, 'studio.html'), html);
const kilobytes = (length) => `${(length / 1000).toFixed(0)} kB`;
console.log(
  `studio/dist/studio.html: ${kilobytes(Buffer.byteLength(html))} (engine ${kilobytes(engine.length)}, packed ${kilobytes(Buffer.byteLength(values.engine))}; ` +
    `code ${kilobytes(code.length)}, packed ${kilobytes(Buffer.byteLength(values.code))})`,
);
if (process.argv.includes('--clean')) rmSync(bound, { recursive: true });
