// node validate.mjs FILE.glb …: what the Khronos validator says of each; it exits with 1 where that is an error or a warning.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const { validateBytes } = createRequire(import.meta.url)('gltf-validator');
let bad = process.argv.length < 3 ? 1 : 0;
for (const file of process.argv.slice(2)) {
  const { issues, info } = await validateBytes(new Uint8Array(readFileSync(file)));
  const { numErrors, numWarnings, messages } = issues;
  console.log(`${file}: ${info.totalVertexCount} vertices, ${info.animationCount} animations: ${numErrors} errors, ${numWarnings} warnings`);
  // 0 is an error, 1 a warning.
  for (const { severity, code, message, pointer } of messages.filter(({ severity }) => severity < 2)) {
    bad = 1;
    console.error(`  ${severity === 0 ? 'error' : 'warning'} ${code}: ${message} (${pointer})`);
  }
}
process.exit(bad);
