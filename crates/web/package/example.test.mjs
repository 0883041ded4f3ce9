// The example as a page in a browser: who is shown walks to where one clicks.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const FOLDER = new URL("./", import.meta.url);
const TYPES = { html: "text/html", js: "text/javascript", wasm: "application/wasm" };
// Where it is asked for, where the system has it.
const BROWSERS = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/google-chrome", chromium.executablePath()];
// A machine may have no graphics card.
const ARGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

// This folder, as any server of files gives it.
async function serve(t) {
  const server = createServer(async (request, response) => {
    const place = new URL(`.${request.url}`, FOLDER);
    const body = await readFile(fileURLToPath(place)).catch(() => null);
    response.writeHead(body ? 200 : 404, { "content-type": TYPES[place.pathname.split(".").at(-1)] ?? "text/plain" });
    response.end(body ?? "");
  });
  await new Promise((listens) => server.listen(0, "127.0.0.1", listens));
  t.after(() => server.close());
  return `http://127.0.0.1:${server.address().port}/example.html`;
}

test("who is shown walks to where one clicks", async (t) => {
  const executablePath = BROWSERS.find((place) => place && existsSync(place));
  if (!executablePath) return t.skip("there is no Chromium; CHROMIUM says where one is");
  const url = await serve(t);
  const browser = await chromium.launch({ executablePath, args: ARGS });
  t.after(() => browser.close());
  const page = await browser.newPage({ viewport: { width: 480, height: 320 } });
  const wrong = [];
  page.on("pageerror", (error) => wrong.push(error.message));
  page.on("request", (request) => request.url().startsWith(url.replace("example.html", "")) || wrong.push(`asks for ${request.url()}`));
  await page.goto(url);
  await page.waitForFunction(() => window.solaris);
  const place = () => page.evaluate(() => [...window.solaris.walker.place]);
  assert.ok(Math.hypot(...(await place())) < 0.1);
  // On the ground in front of her, to the right of the picture: she is in its middle.
  await page.mouse.click(330, 230);
  await page.waitForFunction(() => Math.hypot(...window.solaris.walker.place) > 0.5, null, { timeout: 60_000 });
  await page.waitForFunction(() => window.solaris.walker.isStanding, null, { timeout: 60_000 });
  const [x, z] = await place();
  assert.ok(Math.abs(x) < 5 && Math.abs(z) < 10, `${x}, ${z}`);
  assert.deepEqual(wrong, []);
});
