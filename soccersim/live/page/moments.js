// The last seconds of what the base station has told, as moments that picture.js draws.

const KEPT = 30; // s
const JUMP = 10; // m/s; faster, it was carried there
const SIGHTINGS = 0.5; // s for which a sighting is shown

class Moments {
  constructor(hello) {
    this.told = hello;
    const { layout } = hello;
    this.head = index(layout.head);
    this.ballAt = index(layout.ball);
    this.robotAt = index(layout.robot);
    this.wheelAt = index(layout.wheel);
    this.first = layout.head.length + layout.ball.length;
    this.size = layout.robot.length + layout.wheels * layout.wheel.length;
    this.linksFrom = this.first + layout.robots * this.size;
    this.frames = [];
    this.say(hello);
  }

  // What teams call what their robots do, and what they drew.
  say({ labels, notes }) {
    this.labels = labels;
    this.notes = notes.length ? notes : [[], []];
  }

  // A picture has come.
  add(frame) {
    const { frames } = this;
    if (frame.length !== this.linksFrom + this.told.layout.links * this.told.layout.link.length) return;
    const last = frames[frames.length - 1];
    const tick = frame[this.head.tick];
    if (last && tick < last[this.head.tick]) this.frames = [];
    if (last && tick === last[this.head.tick]) frames[frames.length - 1] = frame;
    else this.frames.push(frame);
    const oldest = tick - KEPT * this.told.hz;
    while (this.frames[0][this.head.tick] < oldest) this.frames.shift();
  }

  get now() {
    return this.frames[this.frames.length - 1];
  }

  time(frame) {
    return frame[this.head.tick] / this.told.hz;
  }

  of(frame, robot, name) {
    return frame[this.first + robot * this.size + this.robotAt[name]];
  }

  wheel(frame, robot, wheel, name) {
    const { layout } = this.told;
    return frame[this.first + robot * this.size + layout.robot.length + wheel * layout.wheel.length + this.wheelAt[name]];
  }

  ball(frame, name) {
    return frame[this.told.layout.head.length + this.ballAt[name]];
  }

  pose(frame, robot, [x, y, heading]) {
    const pose = { x: this.of(frame, robot, x), y: this.of(frame, robot, y), heading: this.of(frame, robot, heading) };
    return Number.isFinite(pose.x) ? pose : null;
  }

  robot(frame, i) {
    const of = (name) => this.of(frame, i, name);
    return {
      ...this.pose(frame, i, ["x", "y", "heading"]),
      believed: this.pose(frame, i, ["bx", "by", "bheading"]),
      inPlay: of("playing") !== 0,
      contact: of("contact") === 1,
      label: this.labels[i],
      command: { x: of("cx"), y: of("cy"), turn: of("cturn") },
      reference: this.told.match ? null : this.pose(frame, i, ["rx", "ry", "rheading"]),
      target: this.pose(frame, i, ["tx", "ty", "theading"]),
    };
  }

  // Places of the last seconds, broken where something was carried away.
  trail(seconds, place) {
    const { frames } = this;
    const every = 4;
    const points = [];
    const oldest = this.now[this.head.tick] - seconds * this.told.hz;
    let before = null;
    for (let k = frames.length - 1; k >= 0 && frames[k][this.head.tick] >= oldest; k -= every) {
      const point = place(frames[k]);
      const time = this.time(frames[k]);
      if (before && Math.hypot(point[0] - before.point[0], point[1] - before.point[1]) > JUMP * (before.time - time) + 0.05) {
        points.push([NaN, NaN]);
      }
      points.push(point);
      before = { point, time };
    }
    return points.reverse();
  }

  // What is drawn now; trail: seconds of it.
  moment(seconds) {
    const { told, now } = this;
    const at = (name) => now[this.head[name]];
    const has = told.ball !== null;
    const robots = told.robots.map((_, i) => this.robot(now, i));
    const place = (i, x, y) => (frame) => [this.of(frame, i, x), this.of(frame, i, y)];
    return {
      time: this.time(now),
      robots,
      ball: has ? { x: this.ball(now, "x"), y: this.ball(now, "y"), heading: this.ball(now, "heading") } : null,
      links: told.arms.map((_, arm) => [0, 1, 2].map((k) => this.link(now, 3 * arm + k))),
      trails: robots.map((_, i) => (seconds ? this.trail(seconds, place(i, "x", "y")) : [])),
      believedTrails: robots.map((_, i) => (seconds && !told.match ? this.trail(seconds, place(i, "bx", "by")) : [])),
      ballTrail: has && seconds ? this.trail(Math.min(seconds, 3), (frame) => [this.ball(frame, "x"), this.ball(frame, "y")]) : [],
      routes: told.match ? [] : told.robots.map((player, i) => route(player, robots[i].target)),
      kicks: [],
      seen: told.match ? ["home", "away"].map((side) => this.seen(now, side)) : [null, null],
      sightings: told.match ? this.sightings() : [],
      notes: this.notes,
      direction: at("direction"),
      score: [at("home"), at("away")],
      phase: told.phases[at("phase")] || "",
      whose: at("whose"),
      started: at("started") === 1,
      half: at("half"),
      left: at("left"),
      factor: at("factor"),
      speed: at("speed"),
      paused: at("paused") === 1,
      over: at("over") === 1,
      viewers: at("viewers"),
    };
  }

  // Where the camera of each robot has put the ball lately, the newest last.
  sightings() {
    const { frames } = this;
    const found = [];
    const now = this.time(this.now);
    for (let k = frames.length - 1; k > 0 && now - this.time(frames[k]) < SIGHTINGS; k--) {
      const share = 1 - (now - this.time(frames[k])) / SIGHTINGS;
      this.told.robots.forEach((_, robot) => {
        const [x, y] = ["sx", "sy"].map((name) => this.of(frames[k], robot, name));
        // decisions are rarer than pictures: the same number is the same sighting
        if (Number.isFinite(x) && x !== this.of(frames[k - 1], robot, "sx")) found.push({ x, y, robot, share });
      });
    }
    return found.reverse();
  }

  link(frame, k) {
    const [x, y, heading] = [0, 1, 2].map((part) => frame[this.linksFrom + 3 * k + part]);
    return { x, y, heading };
  }

  seen(frame, side) {
    const [x, y, age] = ["x", "y", "age"].map((part) => frame[this.head[`${side}_${part}`]]);
    return Number.isFinite(x) ? { x, y, age } : null;
  }
}

function index(names) {
  return Object.fromEntries(names.map((name, i) => [name, i]));
}

// The way that a robot is told to go: its start and its targets, unless it was sent elsewhere.
function route(player, target) {
  if (!target || !player.targets.some(([x, y]) => Math.hypot(x - target.x, y - target.y) < 1e-6)) return [];
  const places = player.targets.length ? [player.start, ...player.targets] : [];
  if (player.repeat && places.length) places.push(player.targets[0]);
  return places.map(([x, y]) => [x, y]);
}
