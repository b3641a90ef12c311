/** A worker that answers when the test says so. */
export class FakeWorker extends EventTarget {
  readonly received: any[] = [];
  terminated = false;

  /** A new one, added to a list. */
  static in(workers: FakeWorker[]): Worker {
    workers.push(new FakeWorker());
    return workers.at(-1) as unknown as Worker;
  }

  postMessage(message: unknown): void {
    this.received.push(message);
  }

  terminate(): void {
    this.terminated = true;
  }

  say(data: unknown): void {
    this.dispatchEvent(Object.assign(new Event("message"), { data }));
  }
}
