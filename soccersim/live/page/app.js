// Puts line, picture and panels together. window.soccersim is there for tests and tinkering.

const PANELS = 120; // ms between two pictures of the panels
const TRAIL = [0, 3, 12, 30]; // s
const DRIVING = 100; // ms between two orders while a key is held
const SHOWN = [["believed", "believed poses"], ["trails", "trails"], ["commands", "commands"], ["plan", "targets"], ["seen", "believed ball"], ["sightings", "sightings"], ["words", "labels and notes"]];
const CLICKS = [
  ["send", "click: the picked robot goes there; drag: it faces that way when it is there"],
  ["ball", "click: the ball lies there; drag: it rolls that way"],
  ["push", "drag from a robot: a hand pushes it for a moment"],
  ["a robot", "click: pick it"],
  ["wheel, two fingers", "nearer, farther"],
];
const HELP = [
  ["Space", "stop, go on"],
  [".", "one step of control; with Shift one tick"],
  ["− +", "slower, faster; 0 for 1×"],
  ["R", "from the start"],
  ["1 … 9", "pick a robot of home; with Shift one of away"],
  ["S B P", "what a click does: send, ball, push"],
  ["↑ ↓ ← → Q E", "drive the picked robot by hand"],
  ["H K D", "halt, kick, dribble"],
  ["F M ?", "follow, light or dark, help"],
];
const SIGNS = [
  ["believed", "where a robot believes it is"],
  ["target", "where it is sent; a diamond: the set-point of this moment"],
  ["seen", "in a match, the ball as a team believes it to be"],
  ["sighting", "where a robot's camera saw the ball in the last half second"],
  ["halo", "has the ball in its mouth"],
];
const WAYS = { ArrowUp: [1, 0, 0], ArrowDown: [-1, 0, 0], ArrowLeft: [0, 1, 0], ArrowRight: [0, -1, 0], q: [0, 0, 1], e: [0, 0, -1] };

class App {
  constructor() {
    this.show = { believed: true, trails: true, commands: false, plan: true, seen: true, sightings: true, words: true };
    this.trail = 12;
    this.tool = "send";
    this.selected = 0;
    this.panelled = 0;
    this.drawn = 0;
    this.held = new Set();
    this.dribbling = false;
    this.plots = new Plots(byId("plots"));
    this.events = new Events(byId("list"));
    this.link = new Link({
      hello: (told) => this.begin(told),
      picture: (frame) => this.moments && this.moments.add(frame),
      news: (told) => this.news(told.events),
      words: (told) => this.moments.say(told),
      gains: (told) => this.takeGains(told.gains),
    });
    this.actions = new Actions(this.link);
    this.setTheme();
    fillReferee(this);
    new Keys(this);
    setInterval(() => this.drive(), DRIVING);
    setInterval(() => setWaiting(this), PANELS);
    const loop = (now) => {
      this.draw(now);
      requestAnimationFrame(loop);
    };
    requestAnimationFrame(loop);
  }

  // Another scenario, or the same from its start.
  begin(hello) {
    this.begun = performance.now();
    const same = this.moments && this.moments.told.scenario === hello.scenario;
    this.moments = new Moments(hello);
    this.moment = null; // that of before has other robots
    this.gains = hello.gains;
    if (!same) {
      this.selected = Math.max(0, hello.robots.findIndex((robot) => !robot.keeper)); // -1: arms alone
      this.trail = hello.match ? TRAIL[1] : TRAIL[2];
    }
    this.selected = Math.min(this.selected, hello.robots.length - 1);
    this.following = false;
    const canvas = byId("field");
    if (this.picture) this.picture = new Picture(canvas, hello);
    else {
      this.picture = new Picture(canvas, hello);
      this.control = new FieldControl(this);
      new ResizeObserver(() => this.picture.resize()).observe(byId("stage"));
    }
    this.picture.resize();
    byId("app").className = `live ${hello.match ? "match" : "run"}`;
    byId("box").hidden = !hello.match;
    const names = hello.match || [hello.scenario, ""];
    document.title = `${hello.scenario} · soccersim live`;
    setText(byId("home"), names[0]);
    setText(byId("away"), names[1]);
    byId("away").hidden = !hello.match;
    setText(byId("source"), `${hello.scenario} · seed ${hello.seed} · ${hello.hz} Hz`);
    byId("speed").replaceChildren(...hello.speeds.map((speed) => make("option", `${speed}×`, { value: speed })));
    fillOpener(this, hello);
    fillToggles(this);
    this.events.set(hello.events);
    setText(byId("said"), "");
    this.fillBadges();
    this.pick(this.selected);
    byId("robots").hidden = byId("charts").hidden = byId("tuning").hidden = this.selected < 0;
  }

  fillBadges() {
    const { robots } = this.moments.told;
    const wide = Math.max(...[0, 1].map((team) => robots.filter((robot) => robot.team === team).length));
    byId("badges").style.setProperty("--wide", wide);
    byId("badges").replaceChildren(...robots.map((robot, i) => {
      const badge = make("button", String(robot.number), { type: "button", "data-team": robot.team, title: robot.name, "aria-label": robot.name });
      badge.addEventListener("click", () => this.pick(i));
      return badge;
    }));
  }

  pick(index) {
    if (index < 0 || !this.moments) return;
    this.selected = index;
    const player = this.moments.told.robots[index];
    [...byId("badges").children].forEach((badge, i) => badge.setAttribute("aria-pressed", i === index));
    byId("kick").disabled = byId("power").disabled = !player.kick;
    byId("dribble").disabled = !player.dribbler;
    byId("release").hidden = !this.moments.told.match;
    if (player.kick) byId("power").max = player.kick;
    setText(byId("power-told"), player.kick ? `${byId("power").value} m/s` : "no kicker");
    this.plots.show(this.moments, index);
    fillGains(this);
    this.panelled = 0;
  }

  takeGains(gains) {
    this.gains = gains;
    if (this.selected >= 0 && !byId("gains").contains(document.activeElement)) fillGains(this);
  }

  news(events) {
    this.events.add(events);
    const last = events[events.length - 1];
    setText(byId("said"), last.text);
    byId("said").dataset.team = last.side === null || last.side === undefined ? "" : last.side;
  }

  draw(now) {
    const { moments, picture } = this;
    if (!moments || !moments.now) return;
    const moment = (this.moment = moments.moment(this.show.trails ? this.trail : 0));
    if (this.following) picture.view.centre(moment.robots[this.selected].x, moment.robots[this.selected].y);
    picture.draw(moment, this.show, this.selected);
    picture.metres();
    this.control.draw(picture, moments.told.look);
    if (now - this.panelled > PANELS) {
      this.panelled = now;
      this.drawPanels(moment);
    }
    this.drawn++;
  }

  drawPanels(moment) {
    const { moments, link } = this;
    setText(byId("clock"), clock(moment.time, 1));
    if (this.selected >= 0) showBattery(moments, this.selected);
    this.plots.draw();
    byId("play").classList.toggle("on", !moment.paused && !moment.over);
    byId("play").setAttribute("aria-label", moment.paused ? "go on" : "stop");
    byId("play").disabled = byId("step").disabled = moment.over;
    byId("whole").hidden = this.picture.view.zoom <= 1;
    byId("follow").setAttribute("aria-pressed", Boolean(this.following));
    if (document.activeElement !== byId("speed")) byId("speed").value = moment.speed;
    const watched = moment.viewers > 1 ? ` · ${moment.viewers} watch` : "";
    const pace = moment.paused ? "stands" : `pace ${number(moment.factor, 2)}×`;
    setText(byId("meter"), `${number(link.rate, 0)} Hz · delay ${number(link.delay, 0)} ms · ${pace}${watched}`);
    [...byId("badges").children].forEach((badge, i) => badge.classList.toggle("off", !moment.robots[i].inPlay));
    if (moments.told.match) showMatch(moment);
    else {
      setText(byId("half"), "");
      setText(byId("phase"), moment.paused ? "stands still" : "");
      setText(byId("about"), this.selected < 0 ? "" : `${moments.told.robots[this.selected].name} is picked`);
    }
  }

  drive() {
    if (!this.held.size || !this.moments || this.selected < 0) return;
    const way = [...this.held].reduce((sum, key) => sum.map((part, i) => part + WAYS[key][i]), [0, 0, 0]);
    this.actions.drive(this.selected, way[0], way[1], 1.5 * way[2]);
  }

  setTool(tool) {
    this.tool = tool;
    for (const button of document.querySelectorAll("[data-tool]")) button.setAttribute("aria-pressed", button.dataset.tool === tool);
  }

  follow(wanted) {
    const { view } = this.picture;
    this.following = wanted;
    if (wanted) view.zoom = Math.max(view.zoom, 3);
    else view.whole();
  }

  shift(steps) {
    const { speeds } = this.moments.told;
    const at = speeds.indexOf(this.moment.speed);
    this.actions.speed(speeds[Math.min(Math.max((at < 0 ? 3 : at) + steps, 0), speeds.length - 1)]);
  }

  setTheme(chosen = storage("soccersim-theme")) {
    const light = window.matchMedia("(prefers-color-scheme: light)").matches;
    document.documentElement.dataset.theme = chosen || (light ? "light" : "dark");
  }

  toggleTheme() {
    const next = document.documentElement.dataset.theme === "light" ? "dark" : "light";
    storage("soccersim-theme", next);
    this.setTheme(next);
  }
}

function storage(key, value) {
  try {
    if (value === undefined) return localStorage.getItem(key);
    localStorage.setItem(key, value);
  } catch {
    // it lasts as long as the page then
  }
  return value;
}

window.soccersim = new App();
