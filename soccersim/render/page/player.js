// The clock of a replay: a time that plays, at a speed, between 0 and an end.

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8, 16];

class Player {
  // changed(time) is called whenever the time or what is shown may have changed.
  constructor(duration, changed) {
    this.duration = duration;
    this.changed = changed;
    this.time = 0;
    this.speed = 1;
    this.playing = false;
    this.last = 0;
  }

  play() {
    if (this.playing) return;
    if (this.time >= this.duration) this.time = 0;
    this.playing = true;
    this.last = performance.now();
    const beat = (now) => {
      if (!this.playing) return;
      const passed = Math.min(Math.max(now - this.last, 0), 250) / 1000; // a sleeping tab stands still
      this.last = now;
      this.time = Math.min(this.duration, this.time + passed * this.speed);
      if (this.time >= this.duration) this.playing = false;
      this.changed();
      requestAnimationFrame(beat);
    };
    requestAnimationFrame(beat);
    this.changed();
  }

  pause() {
    this.playing = false;
    this.changed();
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  seek(time) {
    this.time = Math.min(Math.max(time, 0), this.duration);
    this.changed();
  }

  setSpeed(speed) {
    this.speed = speed;
    this.changed();
  }

  // Up or down the list of speeds.
  shift(steps) {
    const at = SPEEDS.findIndex((speed) => speed >= this.speed);
    this.setSpeed(SPEEDS[Math.min(Math.max(at + steps, 0), SPEEDS.length - 1)]);
  }
}
