// What can be asked of the base station, and what it says when it cannot be done.

const POWER = 120; // N of a push for each metre that is drawn
const ROLL = 2.5; // m/s of a ball for each metre that is drawn
const TOAST = 3500; // ms

class Actions {
  constructor(link) {
    this.link = link;
    this.latest = NaN; // ms from asking to the answer
  }

  ask(message, then = () => {}) {
    if (message.robot < 0) return; // a scenario of arms alone
    this.link.say(message, (answer, took) => {
      this.latest = took;
      if (answer.type === "wrong") this.complain(answer.what);
      else then(answer);
    });
  }

  complain(text) {
    const toast = byId("toast");
    setText(toast, text);
    toast.hidden = false;
    clearTimeout(this.hiding);
    this.hiding = setTimeout(() => {
      toast.hidden = true;
    }, TOAST);
  }

  go(robot, x, y, heading) {
    this.ask({ do: "go", robot, x, y, ...(heading === null ? {} : { heading }) });
  }

  drive(robot, vx, vy, omega) {
    this.ask({ do: "drive", robot, vx, vy, omega });
  }

  halt(robot) {
    this.ask({ do: "halt", robot });
  }

  release(robot) {
    this.ask({ do: "release", robot });
  }

  kick(robot, speed) {
    this.ask({ do: "kick", robot, speed });
  }

  dribble(robot, on) {
    this.ask({ do: "dribble", robot, on });
  }

  ball(x, y, dx, dy) {
    const [vx, vy] = [dx, dy].map((part) => Math.max(-12, Math.min(12, ROLL * part)));
    this.ask({ do: "ball", x, y, vx, vy });
  }

  push(robot, dx, dy) {
    const [fx, fy] = [dx, dy].map((part) => Math.max(-500, Math.min(500, POWER * part)));
    this.ask({ do: "push", robot, fx, fy });
  }

  gains(robot, loop, gains) {
    this.ask({ do: "gains", robot, loop, ...gains });
  }

  pause(paused) {
    this.ask({ do: paused ? "pause" : "resume" });
  }

  speed(factor) {
    this.ask({ do: "speed", factor });
  }

  step(ticks) {
    this.ask({ do: "step", ticks });
  }

  open(scenario, teams = {}) {
    this.ask({ do: "open", scenario, ...teams });
  }

  referee(call, more = {}) {
    this.ask({ do: "referee", call, ...more });
  }
}
