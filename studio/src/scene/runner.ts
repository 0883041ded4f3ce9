// What takes long runs in an engine of its own: the page goes on meanwhile, and it can be stopped at once.

import type { App } from '../app.ts';
import type { Engine, Tell } from '../engine/client.ts';
import type { Shelved } from '../engine/files.ts';

export interface Runner {
  busy(): boolean;
  // A call of an engine that has all files of the first one.
  run<T>(name: string, args: unknown[], tell: Tell): Promise<{ engine: Engine; value: T }>;
  stop(): void;
}

export function makeRunner(app: App): Runner {
  const engines: Engine[] = [];
  // How many files each was given.
  const given = new Map<Engine, number>();
  let job: { engine?: Engine; stopped?: boolean } | null = null;

  // The one that keeps the motion that is shown stays as it is: a stop would take the motion with it.
  async function idle(): Promise<Engine> {
    const found = engines.find((engine) => engine !== app.motion?.engine);
    if (found) return found;
    const made = await app.another();
    engines.push(made);
    return made;
  }

  async function give(engine: Engine): Promise<void> {
    // One that was begun anew has none.
    const names = await engine.call<string[]>('shelved');
    const since = names.length > 0 ? (given.get(engine) ?? 0) : 0;
    const { count, files } = await app.engine.call<Shelved>('shelvedSince', [since]);
    await Promise.all(files.map(({ name, bytes }) => engine.call('shelve', [name, bytes])));
    given.set(engine, count);
  }

  return {
    busy: () => job !== null,
    async run<T>(name: string, args: unknown[], tell: Tell) {
      const mine: NonNullable<typeof job> = {};
      job = mine;
      try {
        const engine = await idle();
        mine.engine = engine;
        await give(engine);
        if (mine.stopped) throw new Error('stopped');
        return { engine, value: await engine.call<T>(name, args, tell) };
      } finally {
        job = null;
      }
    },
    stop() {
      if (!job) return;
      job.stopped = true;
      job.engine?.stop();
    },
  };
}
