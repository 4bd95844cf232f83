// SPDX-License-Identifier: Apache-2.0
// Asks the server for the state of the run, often while it is live.
import { getJson, pageData } from './data/api.js';

const LIVE = 1000,
  QUIET = 5000; // ms

export class RunWatch {
  /// onRun(run, frames): frames is null if they are the same as before. onProblem(text): '' once all is well.
  constructor(onRun, onProblem) {
    this.onRun = onRun;
    this.onProblem = onProblem;
    this.revision = undefined;
  }

  async look() {
    clearTimeout(this.timer);
    let wait = QUIET;
    try {
      const run = await getJson('run', { frames: this.revision });
      if (run.frames) this.revision = run.frames.revision;
      if (run.live) wait = LIVE;
      await this.onRun(run, run.frames ?? null);
      this.onProblem('');
    } catch (problem) {
      this.onProblem(
        problem instanceof TypeError ? 'thaw view has ended, or the connection is lost' : problem.message,
      );
    }
    if (pageData) return; // a page without a server does not change
    this.timer = setTimeout(() => this.look(), wait);
  }
}
