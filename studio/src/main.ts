// The studio: puts engine, picture and panels together.

import './style.css';
import { makeApp } from './app.ts';
import { makeDocument } from './document.ts';
import { makeJointsPanel } from './panels/joints.ts';
import { makeWalkPanel } from './panels/walk.ts';

const app = makeApp();
const text = makeDocument(app);
const walk = makeWalkPanel(app);
makeJointsPanel(app, text);

app.results.open('joints-curves');
app.tools.open('walk');
walk.start().then(() => (document.body.dataset.ready = 'true'), app.fault);

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
Object.assign(globalThis, { studio: { ...app, document: text } });
