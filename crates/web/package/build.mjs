// Builds the package into dist/: compiles, binds, makes small. Needs the target wasm32-unknown-unknown, and the program wasm-bindgen of
// the same version as the library (WASM_BINDGEN names another one).
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync, rmSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, "../../..");
const dist = join(here, "dist");
const run = (program, options) => execFileSync(program, options, { cwd: root, stdio: ["ignore", "inherit", "inherit"] });

run("cargo", ["build", "--profile", "web", "--target", "wasm32-unknown-unknown", "-p", "solaris-web"]);
const target = process.env.CARGO_TARGET_DIR ?? join(root, "target");
const made = join(target, "wasm32-unknown-unknown/web/solaris_web.wasm");
rmSync(dist, { recursive: true, force: true });
run(process.env.WASM_BINDGEN ?? "wasm-bindgen", ["--target", "web", "--out-dir", dist, made]);

const wasm = join(dist, "solaris_web_bg.wasm");
const optimizer = join(here, "node_modules/.bin/wasm-opt");
run(optimizer, ["-Oz", "--enable-bulk-memory", "--enable-nontrapping-float-to-int", "--enable-sign-ext", "--enable-mutable-globals", "--enable-reference-types", "--enable-multivalue", wasm, "-o", wasm]);

const size = readFileSync(wasm).length;
const zipped = gzipSync(readFileSync(wasm), { level: 9 }).length;
console.log(`${size} bytes, ${zipped} zipped: ${readdirSync(dist).join(", ")}`);
