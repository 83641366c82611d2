// The numbers of one robot, and the list of events.

// A battery of numbers: what is so, what it believes, what it is told, and all its wheels.
function showBattery(moments, index) {
  const panel = byId("numbers");
  const frame = moments.now;
  const of = (name) => moments.of(frame, index, name);
  const player = moments.told.robots[index];
  const [x, y, bx, by] = ["x", "y", "bx", "by"].map(of);
  const title = make("h3", player.name);
  const state = of("playing") === 0 ? "out of play" : of("taken") === 1 ? "by hand" : moments.labels[index];
  const dribbles = of("dribble") !== 0;
  byId("dribble").setAttribute("aria-pressed", dribbles);
  title.append(make("span", [state, dribbles ? "told to dribble" : "", of("contact") === 1 ? "has the ball" : ""].filter(Boolean).join(", ")));
  const pose = table(["", "true", "believes", "off by"], [
    ["x, m", number(x, 3), number(bx, 3), number(bx - x, 3)],
    ["y, m", number(y, 3), number(by, 3), number(by - y, 3)],
    ["heading, °", number(turn(of("heading")), 1), number(turn(of("bheading")), 1), number(turn(of("bheading") - of("heading")), 1)],
  ]);
  const [c, s] = [Math.cos(of("heading")), Math.sin(of("heading"))];
  const [dx, dy] = [of("tx") - x, of("ty") - y];
  const target = Number.isFinite(dx)
    ? [["to its target, cm, °", number(100 * (c * dx + s * dy), 1), number(100 * (c * dy - s * dx), 1), number(turn(of("theading") - of("heading")), 1)]]
    : [];
  const moves = table(["", "ahead", "left", "turn, °/s"], [
    ["true, m/s", number(c * of("vx") + s * of("vy"), 2), number(c * of("vy") - s * of("vx"), 2), number(DEGREES * of("omega"), 0)],
    ["believes", number(of("bvx"), 2), number(of("bvy"), 2), number(DEGREES * of("bomega"), 0)],
    ["told", number(of("cx"), 2), number(of("cy"), 2), number(DEGREES * of("cturn"), 0)],
    ["gyro", "", "", number(DEGREES * of("gyro"), 1)],
    ...target,
  ]);
  const lines = Array.from({ length: player.wheels }, (_, k) => {
    const at = (name) => moments.wheel(frame, index, k, name);
    const driven = k < player.driven;
    return [
      driven ? `wheel ${k + 1}` : `dead ${k + 1 - player.driven}`,
      ...[number(encoded(player, k) ? at("counts") : NaN, 0), number(at("true") * RPM, 0), driven ? number(at("wanted") * RPM, 0) : "", driven ? number(at("pwm"), 0) : ""],
    ];
  });
  panel.replaceChildren(title, pose, moves, table(["", "counts", "rpm", "told", "PWM"], lines));
}

// Whether a wheel has an encoder.
function encoded(player, wheel) {
  return player.encoders[wheel < player.driven ? 0 : 1];
}

const LISTED = 100; // events

// Events, the newest on top.
class Events {
  constructor(element) {
    this.element = element;
  }

  set(events) {
    this.element.replaceChildren();
    this.add(events);
  }

  add(events) {
    for (const event of events) {
      const line = make("div", "", { "data-kind": event.kind, class: "line" });
      if (event.side !== null && event.side !== undefined) line.dataset.team = event.side;
      line.append(make("time", clock(event.time, 0)), make("i"), make("span", event.text));
      const item = make("li");
      item.append(line);
      this.element.prepend(item);
    }
    while (this.element.children.length > LISTED) this.element.lastChild.remove();
  }
}
