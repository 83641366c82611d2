// The time line: who had the ball, what happened, where we are. Drag on it to scrub.

const EDGE = 8; // px at either end
const NEAR = 7; // px from a mark at which it tells
const INKS = ["home", "away", "edge", "faint", "ink", "home-ink", "away-ink"]; // of page.css
const TOLD = 4; // events at most that a tip tells

class Timeline {
  // events as the recording tells them; ribbon: of n equal pieces of time the team, or -1.
  constructor(element, tip, { duration, events, ribbon, notch }) {
    this.element = element;
    this.tip = tip;
    this.canvas = element.querySelector("canvas");
    this.still = document.createElement("canvas");
    Object.assign(this, { duration, events, ribbon, notch });
    element.setAttribute("aria-valuemax", duration.toFixed(2));
  }

  x(time) {
    return EDGE + (this.width * time) / (this.duration || 1);
  }

  time(x) {
    return Math.min(Math.max((x - EDGE) / this.width, 0), 1) * this.duration;
  }

  // Paints all that stands still.
  resize() {
    this.ratio = window.devicePixelRatio || 1;
    const { clientWidth, clientHeight } = this.canvas;
    this.width = Math.max(1, clientWidth - 2 * EDGE);
    for (const canvas of [this.canvas, this.still]) {
      canvas.width = Math.max(1, Math.round(clientWidth * this.ratio));
      canvas.height = Math.max(1, Math.round(clientHeight * this.ratio));
    }
    const style = getComputedStyle(document.documentElement);
    this.colours = Object.fromEntries(INKS.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
    const pen = this.still.getContext("2d");
    pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.middle = clientHeight / 2;
    this.paintRibbon(pen);
    this.paintMarks(pen);
  }

  paintRibbon(pen) {
    const pieces = this.ribbon(Math.round(this.width));
    const colours = ["home", "away", "edge"].map((name) => this.colours[name]);
    pieces.forEach((team, i) => {
      pen.fillStyle = colours[team < 0 ? 2 : team];
      pen.fillRect(EDGE + i, this.middle - 3, 1.5, 6);
    });
    if (this.notch) {
      pen.fillStyle = this.colours.faint;
      pen.fillRect(this.x(this.notch) - 0.5, this.middle - 12, 1, 24);
    }
  }

  paintMarks(pen) {
    for (const event of this.events) if (event.level > 0) this.paintMark(pen, event);
    for (const event of this.events) if (event.kind === "goal") this.paintGoal(pen, event);
  }

  lane(event) {
    return this.middle + (event.side === 1 ? 12 : -12);
  }

  paintMark(pen, event) {
    const x = this.x(event.time);
    const ink = this.colours[["home-ink", "away-ink"][event.side] || "faint"];
    if (event.kind === "shot" || event.kind === "reached") disc(pen, x, this.lane(event), 3, ink);
    else if (event.level > 1) {
      pen.fillStyle = this.colours.faint;
      pen.fillRect(x - 0.5, this.middle - 6, 1, 12);
    }
  }

  paintGoal(pen, event) {
    const x = this.x(event.time);
    disc(pen, x, this.lane(event), 7, this.colours.ink);
    disc(pen, x, this.lane(event), 5.5, this.colours[event.side === 1 ? "away" : "home"]);
  }

  draw(time) {
    const pen = this.canvas.getContext("2d");
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    const x = this.x(time);
    pen.globalAlpha = 0.42; // what is still to come
    pen.drawImage(this.still, 0, 0);
    pen.globalAlpha = 1;
    const played = Math.round(x * this.ratio);
    if (played > 0) pen.drawImage(this.still, 0, 0, played, this.still.height, 0, 0, played, this.still.height);
    pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    pen.fillStyle = this.colours.ink;
    pen.fillRect(x - 1, 3, 2, 2 * this.middle - 6);
    disc(pen, x, this.middle, 5, this.colours.ink);
    this.element.setAttribute("aria-valuenow", time.toFixed(2));
    this.element.setAttribute("aria-valuetext", clock(time, 2));
  }

  eventsNear(x) {
    return this.events
      .filter((event) => event.level > 0 && Math.abs(this.x(event.time) - x) <= NEAR)
      .sort((a, b) => Math.abs(this.x(a.time) - x) - Math.abs(this.x(b.time) - x))
      .slice(0, TOLD)
      .sort((a, b) => a.time - b.time);
  }

  // The tip over a place of the line; null takes it away.
  tell(x) {
    this.tip.hidden = x === null;
    if (x === null) return;
    const near = this.eventsNear(x);
    const lines = near.map((event) => make("p", `${clock(event.time, 1)}  ${event.text}`));
    this.tip.replaceChildren(make("b", clock(this.time(x), 1)), ...lines);
    const left = this.canvas.offsetLeft + this.element.offsetLeft + x - this.tip.offsetWidth / 2;
    const most = this.tip.parentElement.clientWidth - this.tip.offsetWidth - 4;
    this.tip.style.left = `${Math.max(4, Math.min(left, most))}px`;
  }
}
