// What is shown, as files: of the motion, of the picture, of the scene; and a link.

import './save.css';
import { parts, type App } from './app.ts';
import type { SceneDocument } from './document.ts';
import { link } from './link.ts';
import type { WalkPanel } from './panels/walk.ts';
import { button, byId, el } from './ui/dom.ts';

// Of a motion: the engine's name of the format, what it is, its type.
const FORMATS: [string, string, string][] = [
  ['csv', 'Table (.csv)', 'text/csv'],
  ['mot', 'OpenSim motion (.mot)', 'text/plain'],
  ['bvh', 'Motion capture (.bvh)', 'text/plain'],
  ['glb', '3D animation (.glb)', 'model/gltf-binary'],
  ['usda', 'USD scene (.usda)', 'text/plain'],
];
// Frames a second of a film, and its bits a second.
const [RATE, BITS] = [60, 8_000_000];
const FILMS = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];
// How long a file that was handed over stays in memory (ms).
const KEPT = 60_000;

// A name for a file that every system takes.
export function fileName(title: string, extension: string): string {
  const plain = title.normalize('NFC').replace(/[^\p{L}\p{N}._ -]+/gu, ' ').replace(/\s+/g, ' ').replace(/^[. ]+|[. ]+$/g, '').slice(0, 60).trim();
  const reserved = /^(con|prn|aux|nul|com\d|lpt\d)(\.|$)/i.test(plain);
  return `${reserved ? '_' : ''}${plain || 'solaris'}.${extension}`;
}

export function makeSave(app: App, document_: SceneDocument, walk: WalkPanel): void {
  const menu = byId<HTMLDetailsElement>('save');
  const title = (): string => app.motion?.title || byId('title').textContent || 'solaris';
  const film = el('div', { class: 'filming', role: 'status', hidden: true });
  byId('over').append(film);

  function give(bytes: BlobPart, name: string, type: string): void {
    const url = URL.createObjectURL(new Blob([bytes], { type }));
    el('a', { href: url, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(url), KEPT);
    app.say(`Saved ${name}`);
  }

  const needed = (): NonNullable<App['motion']> => {
    if (!app.motion) throw new Error('there is no motion to save: what is shown was not made here, stands still or goes on by itself');
    return app.motion;
  };

  async function motion(format: string, type: string): Promise<void> {
    const { engine, key } = needed();
    const bytes = await engine.call<Uint8Array<ArrayBuffer>>('save', [key, format]);
    give(bytes, fileName(title(), format), type);
  }

  async function page(): Promise<void> {
    const { engine, key, rows } = needed();
    const html = await engine.call<string>('page', [key, parts.viewer, parts.style, rows]);
    give(html, fileName(title(), 'html'), 'text/html');
  }

  const canvas = (): HTMLCanvasElement => {
    if (!app.show.picture) throw new Error('there is no picture: the browser offers no WebGL');
    return app.show.picture.stage.renderer.domElement;
  };

  async function picture(): Promise<void> {
    const drawn = canvas();
    app.show.picture!.touch();
    app.show.picture!.draw();
    // What was drawn can be read until the browser shows it.
    const blob = await new Promise<Blob | null>((resolve) => drawn.toBlob(resolve));
    if (!blob) throw new Error('the browser gives no picture of it');
    give(blob, fileName(title(), 'png'), 'image/png');
  }

  // One pass of the motion, as it is seen.
  async function video(): Promise<void> {
    const drawn = canvas();
    const type = globalThis.MediaRecorder && FILMS.find((known) => MediaRecorder.isTypeSupported(known));
    if (!type || !drawn.captureStream) throw new Error('this browser records no WebM films');
    const { clock } = app.show;
    if (app.show.isLive() || clock.last <= clock.first) throw new Error('a film needs a motion; what is shown stands still or goes on by itself');
    const stream = drawn.captureStream(RATE);
    const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: BITS });
    const pieces: Blob[] = [];
    recorder.ondataavailable = ({ data }) => pieces.push(data);
    const ended = new Promise<void>((resolve, reject) => {
      recorder.onstop = () => resolve();
      recorder.onerror = () => reject(new Error('the browser could not record the film'));
    });
    const { loop } = clock;
    const shown = app.show.data;
    const bar = el('progress', { max: 1, value: 0, 'aria-label': 'Film' });
    film.replaceChildren(el('span', {}, 'Filming'), bar, button('Stop', () => clock.pause()));
    film.hidden = false;
    clock.loop = false;
    clock.seek(clock.first);
    clock.play();
    const forget = clock.onChange(() => {
      bar.value = (clock.time() - clock.first) / (clock.last - clock.first);
      if ((!clock.playing || app.show.data !== shown) && recorder.state === 'recording') recorder.stop();
    });
    try {
      recorder.start();
      await ended;
      give(new Blob(pieces, { type: 'video/webm' }), fileName(title(), 'webm'), 'video/webm');
    } finally {
      forget();
      clock.loop = loop;
      stream.getTracks().forEach((track) => track.stop());
      film.hidden = true;
    }
  }

  // A link is shown where it can be copied by hand too.
  async function address(): Promise<void> {
    const made = await link(app, document_, walk);
    const field = el('input', { type: 'text', class: 'link', readonly: true, value: made, 'aria-label': 'Link' });
    app.say('The link holds what is set up here, and nothing of files:');
    byId('over').querySelector('.notice p')!.append(field);
    field.select();
    await navigator.clipboard?.writeText(made).catch(() => {});
  }

  const choice = (label: string, act: () => Promise<void> | void): HTMLElement =>
    button(label, () => {
      menu.open = false;
      Promise.resolve().then(act).catch(app.fault);
    });
  menu.querySelector('.choices')!.append(
    choice('Page for a colleague (.html)', page),
    ...FORMATS.map(([format, label, type]) => choice(label, () => motion(format, type))),
    choice('Picture (.png)', picture),
    choice('Film (.webm)', video),
    choice('Scene (.ron)', () => give(document_.text, fileName(document_.outline?.name || 'scene', 'ron'), 'text/plain')),
    choice('Link', address),
  );
}
