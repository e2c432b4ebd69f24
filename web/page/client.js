// Jobs for the engine, each client with a worker of its own: the newest question wins, and a long one can be stopped.

import { compiled } from "./compiled.js";

/** A job that has run for so many milliseconds is ended when a newer one waits. */
const PATIENCE = 250;
/** A job is ended after so many seconds. */
const LONGEST = 60;

const failure = (message, help = null) => ({ error: { field: null, message, help, limit: true } });

export class Client {
  /**
   * @param busy called with true when a job takes long, with false when it has ended
   * @param part the part of the engine: `first` answers about a chain and replays it, `whole` does everything else
   */
  constructor(busy = () => {}, part = "whole") {
    this.busy = busy;
    this.part = part;
    this.serial = 0;
  }

  /** The answer to a question; null where a newer question has taken its place. */
  ask(call, request) {
    this.waiting?.resolve(null);
    return new Promise((resolve) => {
      this.waiting = { call, request, resolve };
      if (this.running) this.hurry();
      else this.next();
    });
  }

  /**
   * Ends the job that runs, once it has had its time, for one that waits. A worker that still starts is left to start: the
   * next one would have to start as well.
   */
  hurry() {
    clearTimeout(this.patience);
    if (!this.waiting || !this.running || !this.started) return;
    const left = this.running.since + PATIENCE - performance.now();
    if (left > 0) this.patience = setTimeout(() => this.hurry(), left);
    else this.end(null);
  }

  /** Ends the running job. */
  stop() {
    this.waiting?.resolve(null);
    this.waiting = undefined;
    if (this.running) this.end(failure("stopped before the answer was found"));
  }

  async next() {
    const job = this.waiting;
    this.waiting = undefined;
    if (!job) return;
    job.id = ++this.serial;
    job.since = performance.now();
    this.running = job;
    job.slow = setTimeout(() => this.busy(true), 300);
    job.limit = setTimeout(
      () => this.end(failure(`limit reached: ${LONGEST} seconds for one question on this page`)),
      LONGEST * 1000,
    );
    if (!this.worker) {
      const worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
      this.worker = worker;
      this.started = false;
      worker.onmessage = ({ data }) => worker === this.worker && this.receive(data);
      worker.onerror = (event) => {
        event.preventDefault();
        if (worker === this.worker) this.end(failure(`the engine could not be started: ${event.message ?? "no reason given"}`));
      };
      try {
        worker.postMessage({ part: this.part, module: await compiled(this.part) });
      } catch (error) {
        if (worker === this.worker) this.end(failure(`the engine could not be loaded: ${error.message}`));
        return;
      }
    }
    if (this.running === job) this.worker.postMessage({ id: job.id, call: job.call, request: job.request });
  }

  receive({ started, id, answer, crashed }) {
    if (started) {
      this.started = true;
      if (this.running) this.running.since = performance.now();
      this.hurry();
      return;
    }
    if (id !== this.running?.id) return;
    if (crashed) {
      const help = "simpler input, or the command line, which has more of both";
      this.end(failure("limit reached: the engine ran out of stack or memory in this browser", help));
    } else {
      this.finish(answer);
    }
  }

  /** Ends the worker with its job; the next job gets a new one. */
  end(answer) {
    this.worker?.terminate();
    this.worker = undefined;
    this.finish(answer);
  }

  finish(answer) {
    const job = this.running;
    this.running = undefined;
    clearTimeout(job?.slow);
    clearTimeout(job?.limit);
    this.busy(false);
    job?.resolve(answer);
    this.next();
  }
}

/** A client whose long jobs show a box with a button to stop them. */
export function clientWith(box, part = "whole") {
  const client = new Client((busy) => { box.hidden = !busy; }, part);
  box.querySelector("button").addEventListener("click", () => client.stop());
  return client;
}
