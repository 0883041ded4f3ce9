// Bundles src/ into ../assets/viewer.js and viewer.css, which the crate embeds, and their licences.
// With --check nothing is written: exit code 1 says that the committed files are not what the sources give.

import { readFile, writeFile } from 'node:fs/promises';
import { build } from 'esbuild';

const assets = new URL('../assets/', import.meta.url);

// Whoever hands on a page hands on these libraries: their licences travel in the bundle.
const libraries = await Promise.all(
  ['three', 'uplot'].map(async (name) => {
    const folder = new URL(`node_modules/${name}/`, import.meta.url);
    const { version } = JSON.parse(await readFile(new URL('package.json', folder), 'utf8'));
    return { name, version, licence: (await readFile(new URL('LICENSE', folder), 'utf8')).trim() };
  }),
);
const licences = libraries.map(({ name, version, licence }) => `${name} ${version}\n\n${licence}`).join('\n\n');
const result = await build({
  absWorkingDir: new URL('.', import.meta.url).pathname,
  entryPoints: { viewer: 'src/main.js' },
  outdir: 'out',
  bundle: true,
  write: false,
  minify: true,
  format: 'iife',
  target: 'es2022',
  charset: 'utf8',
  legalComments: 'eof',
  footer: { js: `/*!\n${licences}\n*/` },
});

const notice = `# Licences of what is bundled here

\`viewer.js\` and \`viewer.css\` are built from \`../web/src\` (this project's own) and the libraries below; their texts stand at
the end of \`viewer.js\` too, and so in every page. esbuild builds them and leaves nothing of itself in them.
${libraries.map(({ name, version, licence }) => `\n## ${name} ${version}\n\n\`\`\`text\n${licence}\n\`\`\`\n`).join('')}`;
const files = [
  ...result.outputFiles.map(({ path, text }) => ({ name: path.split('/').pop(), text })),
  { name: 'LICENSES.md', text: notice },
];

let stale = false;
for (const file of files) {
  const { name } = file;
  const target = new URL(name, assets);
  if (process.argv.includes('--check')) {
    const same = (await readFile(target, 'utf8').catch(() => '')) === file.text;
    stale ||= !same;
    console.log(`${same ? 'up to date' : 'STALE'}: assets/${name}`);
  } else {
    await writeFile(target, file.text);
    console.log(`assets/${name}: ${(Buffer.byteLength(file.text) / 1024).toFixed(0)} KiB`);
  }
}
if (stale) {
  console.error('run `npm run build` in crates/view/web and commit the result');
  process.exit(1);
}
