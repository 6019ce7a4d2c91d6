/** Values that others watch. */

type Watcher<T> = (value: T) => void;

/** A value; whoever watches it learns of every change. */
export class Cell<T> {
  private readonly watchers = new Set<Watcher<T>>();

  constructor(private current: T) {}

  get value(): T {
    return this.current;
  }

  set value(next: T) {
    if (Object.is(next, this.current)) return;
    this.current = next;
    for (const watcher of [...this.watchers]) watcher(next);
  }

  /** Call `watcher` now and after every change; the answer ends that. */
  watch(watcher: Watcher<T>): () => void {
    watcher(this.current);
    return this.after(watcher);
  }

  /** Call `watcher` after every change; the answer ends that. */
  after(watcher: Watcher<T>): () => void {
    this.watchers.add(watcher);
    return () => this.watchers.delete(watcher);
  }
}

/**
 * Work of which only the last request counts: while one runs, later ones replace each other.
 *
 * What is overtaken ends with undefined.
 */
export function latest<A, R>(work: (argument: A) => Promise<R>): (argument: A) => Promise<R | undefined> {
  let running = false;
  let waiting: { argument: A; resolve: (result: R | undefined) => void; reject: (why: unknown) => void } | null =
    null;
  const run = async (): Promise<void> => {
    running = true;
    while (waiting !== null) {
      const { argument, resolve, reject } = waiting;
      waiting = null;
      try {
        const result = await work(argument);
        resolve(waiting === null ? result : undefined);
      } catch (why) {
        reject(why);
      }
    }
    running = false;
  };
  return (argument) =>
    new Promise((resolve, reject) => {
      waiting?.resolve(undefined);
      waiting = { argument, resolve, reject };
      if (!running) void run();
    });
}
