// SPDX-License-Identifier: Apache-2.0
// Times of pictures on the graphics processor. Does not block: fences are polled between tasks.

const POLL = 4, // ms
  MOST_WAITING = 2; // pictures in flight; more delay the reply to the mouse

export class PictureClock {
  /// gl: of WebGL 2.
  constructor(gl) {
    this.gl = gl;
    this.waiting = [];
    this.last = 0; // end of the last finished picture, ms
  }

  get full() {
    return this.waiting.length >= MOST_WAITING;
  }

  /// Calls done(cost) once the picture that was just drawn is finished. begin, cost: ms.
  add(begin, done) {
    const { gl } = this,
      fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return; // the context is lost
    gl.flush();
    this.waiting.push({ fence, begin, done });
    if (this.waiting.length === 1) setTimeout(() => this.look(), POLL);
  }

  look() {
    const { gl, waiting } = this;
    while (waiting.length > 0 && (gl.isContextLost() || this.signaled(waiting[0].fence))) {
      const { fence, begin, done } = waiting.shift(),
        now = performance.now();
      gl.deleteSync(fence);
      // A picture begins when the one before it is finished.
      const cost = now - Math.max(begin, this.last);
      this.last = now;
      done(cost);
    }
    if (waiting.length > 0) setTimeout(() => this.look(), POLL);
  }

  signaled(fence) {
    return this.gl.getSyncParameter(fence, this.gl.SYNC_STATUS) === this.gl.SIGNALED;
  }
}
