// Builds the package into dist/: compiles, binds, makes small; its entries `lean` and `full` into folders of these names. An entry
// that grows beyond its bounds is refused. Needs the target wasm32-unknown-unknown, and the program wasm-bindgen of
// the same version as the library (WASM_BINDGEN names another one).
import { execFileSync } from "node:child_process";
import { readFileSync, rmSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { brotliCompressSync, gzipSync } from "node:zlib";

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, "../../..");
const dist = join(here, "dist");
const run = (program, options) => execFileSync(program, options, { cwd: root, stdio: ["ignore", "inherit", "inherit"] });

const target = process.env.CARGO_TARGET_DIR ?? join(root, "target");
const made = join(target, "wasm32-unknown-unknown/web/solaris_web.wasm");
const optimizer = join(here, "node_modules/.bin/wasm-opt");
// What rustc's target has; the optimizer assumes less.
const has = ["bulk-memory", "nontrapping-float-to-int", "sign-ext", "mutable-globals", "reference-types", "multivalue"];

function build(folder, options, most) {
  run("cargo", ["build", "--profile", "web", "--target", "wasm32-unknown-unknown", "-p", "solaris-web", ...options]);
  run(process.env.WASM_BINDGEN ?? "wasm-bindgen", ["--target", "web", "--out-dir", folder, made]);
  const wasm = join(folder, "solaris_web_bg.wasm");
  run(optimizer, ["-Oz", ...has.map((feature) => `--enable-${feature}`), wasm, "-o", wasm]);
  const bytes = readFileSync(wasm);
  const size = { bytes: bytes.length, zipped: gzipSync(bytes, { level: 9 }).length, brotli: brotliCompressSync(bytes).length };
  console.log(`${folder}: ${size.bytes} bytes, ${size.zipped} by gzip, ${size.brotli} by Brotli`);
  if (size.bytes > most.bytes || size.zipped > most.zipped) {
    throw new Error(`${folder}: at most ${most.bytes} bytes, ${most.zipped} by gzip; see README.md for what it consists of`);
  }
}

rmSync(dist, { recursive: true, force: true });
build(dist, [], { bytes: 2_200_000, zipped: 980_000 });
// Small before quick.
build(join(dist, "lean"), ["--no-default-features", "--config", 'profile.web.opt-level="z"'], { bytes: 1_200_000, zipped: 510_000 });
build(join(dist, "full"), ["--features", "full"], { bytes: 4_200_000, zipped: 1_800_000 });
