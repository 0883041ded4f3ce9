// The studio: puts engine, picture and panels together.

import { makeApp } from './app.ts';
import { makeDocument } from './document.ts';
import { restore } from './link.ts';
import { makeComparePanel } from './panels/compare.ts';
import { makeFilesPanel } from './panels/files.ts';
import { makeJointsPanel } from './panels/joints.ts';
import { makeScenePanel } from './panels/scene.ts';
import { makeSteerPanel } from './panels/steer.ts';
import { makeWalkPanel } from './panels/walk.ts';
import { receive } from './receive.ts';
import { makeSave } from './save.ts';

const app = makeApp();
const text = makeDocument(app);
const walk = makeWalkPanel(app);
makeSteerPanel(app);
makeJointsPanel(app, text);
makeScenePanel(app, text);
const files = makeFilesPanel(app, text);
makeComparePanel(app);
makeSave(app, text, walk);

app.results.open('joints-curves');
app.tools.open('walk');
async function begin(): Promise<void> {
  const { panel, fault } = await restore(text, walk);
  await walk.start();
  if (panel) app.tools.open(panel);
  if (fault) app.fault(fault);
}
begin()
  .then(files.begin)
  .then(() => {
    receive(app, files.page);
    document.body.dataset.ready = 'true';
  })
  .catch(app.fault);
// Another link in the same window.
window.addEventListener('hashchange', () => begin().catch(app.fault));

// Another panel by its number.
document.addEventListener('keydown', (event) => {
  const tabs = [...document.querySelectorAll<HTMLButtonElement>('#tool-tabs button')];
  const tab = event.altKey && !event.ctrlKey ? tabs[Number(event.key) - 1] : undefined;
  if (!tab) return;
  event.preventDefault();
  tab.click();
  tab.focus();
});

// For scripts and tests.
const scripted = {
  ...app,
  document: text,
  get motion() {
    return app.motion;
  },
};
Object.assign(globalThis, { studio: scripted });
