// Builds the package into dist/: compiles, binds, makes small; its entries `walker` and `full` into folders of these names. An entry that grows
// beyond its bounds is refused. Needs the target wasm32-unknown-unknown, and the program wasm-bindgen of
// the same version as the library (WASM_BINDGEN names another one).
import { execFileSync } from "node:child_process";
import { readFileSync, rmSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, "../../..");
const dist = join(here, "dist");
const run = (program, options) => execFileSync(program, options, { cwd: root, stdio: ["ignore", "inherit", "inherit"] });

const target = process.env.CARGO_TARGET_DIR ?? join(root, "target");
const made = join(target, "wasm32-unknown-unknown/web/solaris_web.wasm");
const optimizer = join(here, "node_modules/.bin/wasm-opt");
// What rustc's target has; the optimizer assumes less.
const has = ["bulk-memory", "nontrapping-float-to-int", "sign-ext", "mutable-globals", "reference-types", "multivalue"];

function build(folder, features, most) {
  run("cargo", ["build", "--profile", "web", "--target", "wasm32-unknown-unknown", "-p", "solaris-web", ...features]);
  run(process.env.WASM_BINDGEN ?? "wasm-bindgen", ["--target", "web", "--out-dir", folder, made]);
  const wasm = join(folder, "solaris_web_bg.wasm");
  run(optimizer, ["-Oz", ...has.map((feature) => `--enable-${feature}`), wasm, "-o", wasm]);
  const bytes = readFileSync(wasm);
  const size = { bytes: bytes.length, zipped: gzipSync(bytes, { level: 9 }).length };
  console.log(`${folder}: ${size.bytes} bytes, ${size.zipped} zipped`);
  if (size.bytes > most.bytes || size.zipped > most.zipped) {
    throw new Error(`${folder}: at most ${most.bytes} bytes, ${most.zipped} zipped; see README.md for what it consists of`);
  }
}

rmSync(dist, { recursive: true, force: true });
build(dist, [], { bytes: 2_200_000, zipped: 980_000 });
build(join(dist, "walker"), ["--no-default-features"], { bytes: 1_200_000, zipped: 450_000 });
build(join(dist, "full"), ["--features", "full"], { bytes: 4_200_000, zipped: 1_800_000 });
