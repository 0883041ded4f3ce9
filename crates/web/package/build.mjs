// Builds the package into dist/: compiles, binds, makes small; its entries `lean` and `full` into folders of these names. An entry
// that grows beyond its bounds is refused. Needs the target wasm32-unknown-unknown, and the program wasm-bindgen of
// the same version as the library (WASM_BINDGEN names another one). Rust's own library is compiled with it, of its source (the
// component rust-src), for here a panic is a trap whatever it says: without its words, all is smaller by a tenth.
import { execFileSync } from "node:child_process";
import { readFileSync, rmSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { brotliCompressSync, gzipSync } from "node:zlib";

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, "../../..");
const dist = join(here, "dist");
const run = (program, options, env = process.env) => execFileSync(program, options, { cwd: root, env, stdio: ["ignore", "inherit", "inherit"] });

const target = process.env.CARGO_TARGET_DIR ?? join(root, "target");
const made = join(target, "wasm32-unknown-unknown/web/solaris_web.wasm");
const optimizer = join(here, "node_modules/.bin/wasm-opt");
// What rustc's target has; the optimizer assumes less.
const has = ["bulk-memory", "nontrapping-float-to-int", "sign-ext", "mutable-globals", "reference-types", "multivalue"];

// What makes panics trap at once, where the source can be had; cargo counts it among what may change, so that it must be let.
function silentPanics() {
  try {
    run("rustup", ["component", "add", "rust-src"]);
  } catch {
    console.warn("skipped: panics keep their words, and all is larger by a tenth: there is no source of Rust's library (rustup component add rust-src)");
    return null;
  }
  return ["-Zpanic-immediate-abort", "-Zbuild-std=std,panic_abort", "-Zbuild-std-features=optimize_for_size", "--config", 'profile.web.panic="immediate-abort"'];
}
const silent = silentPanics();

function build(folder, options, most) {
  const env = silent ? { ...process.env, RUSTC_BOOTSTRAP: "1" } : process.env;
  // With names, by which the optimizer sorts functions: those that are alike stand together then, and zip better.
  const names = ["--config", "profile.web.strip=false"];
  run("cargo", ["build", "--profile", "web", "--target", "wasm32-unknown-unknown", "-p", "solaris-web", ...options, ...names, ...(silent ?? [])], env);
  run(process.env.WASM_BINDGEN ?? "wasm-bindgen", ["--target", "web", "--out-dir", folder, made]);
  const wasm = join(folder, "solaris_web_bg.wasm");
  // Until nothing more is made smaller: a quarter of a percent.
  const passes = ["-Oz", "--converge", "--reorder-functions-by-name", "--strip-debug", "--strip-producers"];
  run(optimizer, [...passes, ...has.map((feature) => `--enable-${feature}`), wasm, "-o", wasm]);
  const bytes = readFileSync(wasm);
  const size = { bytes: bytes.length, zipped: gzipSync(bytes, { level: 9 }).length, brotli: brotliCompressSync(bytes).length };
  console.log(`${folder}: ${size.bytes} bytes, ${size.zipped} by gzip, ${size.brotli} by Brotli`);
  const room = silent ? 1 : 1.12;
  if (size.bytes > room * most.bytes || size.zipped > room * most.zipped) {
    throw new Error(`${folder}: at most ${most.bytes} bytes, ${most.zipped} by gzip; see README.md for what it consists of`);
  }
}

rmSync(dist, { recursive: true, force: true });
build(dist, [], { bytes: 1_980_000, zipped: 860_000 });
// Small before quick.
build(join(dist, "lean"), ["--no-default-features", "--config", 'profile.web.opt-level="z"'], { bytes: 1_050_000, zipped: 453_000 });
build(join(dist, "full"), ["--features", "full"], { bytes: 3_750_000, zipped: 1_600_000 });
