// Buttons, keys, and fingers on the field.

const TRAILS = [0, 3, 20, 120]; // s, between which the button for trails goes round
const MOVED = 5; // px: a press that moves farther is no click
const CLOSE = 3; // times as large as the whole field when a robot is followed

const TOGGLES = [
  // what, its name, its key, whether it makes sense here
  ["believed", "believed poses", "b", (told) => told.robots.length > 0],
  ["trails", "trails", "t", () => true],
  ["commands", "commands", "c", (told, channels) => told.robots.length > 0 && Boolean(channels.command_x)],
  ["seen", "believed ball", "k", (told) => Boolean(told.match) && told.ball !== null],
  ["sightings", "sightings", "s", (told, channels) => Boolean(channels.sighted_x)],
  ["words", "labels and notes", "l", (told) => Boolean(told.match)],
  ["plan", "path and target", "r", (told) => told.robots.some((robot) => robot.targets.length)],
];

const KEYS = [
  ["Space", "play, pause"],
  ["← →", "a second back, on; with Shift ten"],
  [", .", "a frame back, on"],
  ["P N", "previous, next event"],
  ["Home End", "beginning, end"],
  ["− +", "slower, faster; 0 for 1×"],
  ["1 … 9", "pick a robot of home by its number; with Shift one of away"],
  ["F", "follow the robot, or else the ball"],
  ["Esc", "whole field; nothing picked"],
  ["B T C K S L R", "what is shown: the buttons below the time line, in order"],
  ["M", "light or dark"],
  ["?", "this help"],
];

class Controls {
  constructor(app) {
    this.app = app;
    this.pointers = new Map();
    this.makeButtons();
    this.makeToggles();
    this.listenToKeys();
    this.listenToTimeline();
    this.listenToField();
  }

  makeButtons() {
    const { app } = this;
    const on = (id, act) => byId(id).addEventListener("click", act);
    on("play", () => app.player.toggle());
    on("previous-frame", () => app.step(-1));
    on("next-frame", () => app.step(1));
    on("previous-event", () => app.jump(-1));
    on("next-event", () => app.jump(1));
    on("follow", () => app.follow(!app.following));
    on("whole", () => app.whole());
    on("theme", () => app.theme.toggle());
    on("help", () => this.help());
    const select = byId("speed");
    for (const speed of SPEEDS) select.append(make("option", `${speed}×`, { value: speed }));
    select.addEventListener("change", () => app.player.setSpeed(Number(select.value)));
  }

  makeToggles() {
    const { app } = this;
    const { told, channels } = app.recording;
    this.toggles = TOGGLES.filter((toggle) => toggle[3](told, channels));
    this.chips = this.toggles.map(([what, name, key]) => {
      const chip = make("button", name, { type: "button", title: `${name} (${key.toUpperCase()})` });
      chip.addEventListener("click", () => this.toggle(what));
      return chip;
    });
    byId("toggles").replaceChildren(...this.chips);
    this.showToggles();
  }

  toggle(what) {
    const { app } = this;
    if (what === "trails") {
      app.trail = TRAILS[(TRAILS.indexOf(app.trail) + 1) % TRAILS.length];
      app.show.trails = app.trail > 0;
    } else app.show[what] = !app.show[what];
    this.showToggles();
    app.changed();
  }

  showToggles() {
    const { app } = this;
    this.toggles.forEach(([what, name], i) => {
      this.chips[i].setAttribute("aria-pressed", Boolean(app.show[what]));
      if (what === "trails") setText(this.chips[i], app.trail ? `${name} ${app.trail} s` : name);
    });
  }

  help() {
    const guide = byId("guide");
    if (guide.open) guide.close();
    else guide.showModal();
  }

  listenToKeys() {
    document.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      if (event.target.closest("select, dialog") && event.key !== "?") return;
      const onButton = event.target.closest("button") && [" ", "Enter"].includes(event.key);
      if (!onButton && this.press(event)) event.preventDefault();
    });
  }

  // Whether the key does something here.
  press(event) {
    const { app } = this;
    const { player } = app;
    const digit = /^Digit([1-9])$/.exec(event.code);
    const far = event.shiftKey ? 10 : 1;
    const keys = {
      " ": () => player.toggle(),
      ArrowLeft: () => player.seek(player.time - far),
      ArrowRight: () => player.seek(player.time + far),
      ",": () => app.step(-1),
      ".": () => app.step(1),
      p: () => app.jump(-1),
      n: () => app.jump(1),
      Home: () => player.seek(0),
      End: () => player.seek(player.duration),
      "-": () => player.shift(-1),
      "+": () => player.shift(1),
      "=": () => player.shift(1),
      0: () => player.setSpeed(1),
      f: () => app.follow(!app.following),
      Escape: () => app.whole(),
      m: () => app.theme.toggle(),
      "?": () => this.help(),
    };
    for (const [what, , key] of this.toggles) keys[key] = () => this.toggle(what);
    const act = digit ? () => app.pickNumber(Number(digit[1]), event.shiftKey) : keys[event.key.length > 1 ? event.key : event.key.toLowerCase()];
    if (act) act();
    return Boolean(act);
  }

  listenToTimeline() {
    const { app } = this;
    const { timeline, player } = app;
    const { element } = timeline;
    const place = (event) => event.clientX - timeline.canvas.getBoundingClientRect().left;
    let held = false;
    element.addEventListener("pointerdown", (event) => {
      held = true;
      element.setPointerCapture(event.pointerId);
      player.seek(timeline.time(place(event)));
    });
    element.addEventListener("pointermove", (event) => {
      timeline.tell(place(event));
      if (held) player.seek(timeline.time(place(event)));
    });
    const end = () => {
      held = false;
      timeline.tell(null);
    };
    for (const kind of ["pointerup", "pointercancel", "pointerleave"]) element.addEventListener(kind, end);
  }

  listenToField() {
    const { canvas, view } = this.app.picture;
    const place = (event) => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener("pointerdown", (event) => {
      this.pointers.set(event.pointerId, place(event));
      this.moved = this.pointers.size > 1 ? Infinity : 0;
    });
    canvas.addEventListener("pointermove", (event) => {
      if (this.pointers.has(event.pointerId)) this.drag(event.pointerId, place(event));
    });
    canvas.addEventListener("pointerup", (event) => {
      if (this.pointers.delete(event.pointerId) && this.moved <= MOVED) this.app.pickAt(...place(event));
    });
    canvas.addEventListener("pointercancel", (event) => this.pointers.delete(event.pointerId));
    canvas.addEventListener("pointerleave", (event) => this.pointers.delete(event.pointerId));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      view.zoomAt(...place(event), Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.002)));
      this.app.changed();
    }, { passive: false });
  }

  // One finger moves the field, two fingers zoom it too.
  drag(id, now) {
    const { view } = this.app.picture;
    const before = this.pointers.get(id);
    const other = [...this.pointers.entries()].find(([each]) => each !== id);
    this.pointers.set(id, now);
    this.moved += Math.hypot(now[0] - before[0], now[1] - before[1]);
    if (other) {
      const away = (point) => Math.max(1, Math.hypot(point[0] - other[1][0], point[1] - other[1][1]));
      view.zoomAt((now[0] + other[1][0]) / 2, (now[1] + other[1][1]) / 2, away(now) / away(before));
    } else if (view.zoom > 1 && this.moved > MOVED) {
      this.app.following = false;
      view.pan(now[0] - before[0], now[1] - before[1]);
    } else return;
    this.app.changed();
  }
}
