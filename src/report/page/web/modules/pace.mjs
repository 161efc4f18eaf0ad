// How much is drawn at once: as much as takes about a frame, learnt from what was drawn.

const kGoalMs = 30;  // of drawing; the rest of a frame goes to the browser

export class Pace {
  /// `count` lines to begin with, never fewer than `least`.
  constructor(count, least) {
    this.count = count;
    this.least = least;
    this.taken = 0;
  }
  /// `drawn` lines took so many milliseconds; the first time tells nothing, since programs are compiled then.
  take(drawn, ms) {
    this.taken += 1;
    if (this.taken === 1) return;
    if (ms > kGoalMs) {
      this.count = Math.max(this.least, Math.round(Math.min(this.count, drawn) * Math.max(0.25, kGoalMs / ms)));
    } else if (ms * Math.max(1, this.count / drawn) < kGoalMs / 2) {
      this.count *= 2;
    }
  }
}
