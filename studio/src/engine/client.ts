// The engine in a worker, called from the page. One that breaks is begun anew; one that is busy can be stopped.

import type { Fault, Reply } from './protocol.ts';

export class EngineFault extends Error {
  readonly broken: boolean;
  constructor({ message, broken }: Fault) {
    super(message);
    this.broken = broken ?? false;
  }
}

export type Tell = (share: number | null, words: string | null, soFar?: string) => void;

interface Waiting {
  resolve: (value: never) => void;
  reject: (fault: EngineFault) => void;
  tell?: Tell;
}

export class Engine {
  #worker!: Worker;
  #waiting = new Map<number, Waiting>();
  #next = 1;
  readonly #code: string;
  // The worker has what it begins with.
  #ready!: Promise<void>;
  // Called when it was begun anew: what it knew is gone.
  onAnew: () => void = () => {};
  readonly module: Promise<WebAssembly.Module>;

  // `code`: the worker's script; `module`: the engine, compiled.
  constructor(code: string, module: Promise<WebAssembly.Module>) {
    this.#code = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
    this.module = module;
    this.#start();
  }

  #start(): void {
    const worker = new Worker(this.#code);
    this.#worker = worker;
    worker.onmessage = ({ data }: MessageEvent<Reply>) => this.#hear(data);
    worker.onerror = (event) => {
      event.preventDefault();
      this.#break(event.message || 'the engine could not be started');
    };
    this.#ready = this.module.then((module) => worker.postMessage({ module }));
  }

  #hear(reply: Reply): void {
    const waiting = this.#waiting.get(reply.id);
    if (!waiting) return;
    if ('share' in reply) {
      waiting.tell?.(reply.share, reply.words, reply.soFar);
      return;
    }
    this.#waiting.delete(reply.id);
    if ('value' in reply) {
      waiting.resolve(reply.value as never);
      return;
    }
    waiting.reject(new EngineFault(reply.fault));
    if (reply.fault.broken) this.#break('the engine was begun anew after a fault of its own');
  }

  #break(message: string): void {
    this.#worker.terminate();
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    this.#start();
    waiting.forEach(({ reject }) => reject(new EngineFault({ message, broken: true })));
    this.onAnew();
  }

  // Ends whatever it is doing.
  stop(): void {
    if (this.#waiting.size > 0) this.#break('stopped');
  }

  get busy(): boolean {
    return this.#waiting.size > 0;
  }

  call<T>(name: string, args: unknown[] = [], tell?: Tell, transfer: Transferable[] = []): Promise<T> {
    const id = this.#next++;
    return new Promise<T>((resolve, reject) => {
      this.#waiting.set(id, { resolve: resolve as (value: never) => void, reject, tell });
      const worker = this.#worker;
      this.#ready.then(() => worker.postMessage({ id, name, args }, transfer)).catch(reject);
    });
  }
}
