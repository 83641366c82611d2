// Puts source, picture and controls together. window.soccersim is there for tests and tinkering.

const PANELS = 100; // ms between two pictures of the panels while it plays

// Light or dark: as the system has it, until somebody chooses.
class Theme {
  constructor(changed) {
    this.changed = changed;
    this.system = window.matchMedia("(prefers-color-scheme: light)");
    this.system.addEventListener("change", () => this.set(this.stored()));
    this.set(this.stored());
  }

  stored() {
    try {
      return localStorage.getItem("soccersim-theme");
    } catch {
      return null; // a page from disk may have no storage
    }
  }

  set(chosen) {
    document.documentElement.dataset.theme = chosen || (this.system.matches ? "light" : "dark");
    this.changed();
  }

  toggle() {
    const next = document.documentElement.dataset.theme === "light" ? "dark" : "light";
    try {
      localStorage.setItem("soccersim-theme", next);
    } catch {
      // it lasts as long as the page then
    }
    this.set(next);
  }
}

class App {
  constructor(recording, theme) {
    const { told } = recording;
    this.recording = recording;
    this.theme = theme;
    this.show = { believed: true, trails: true, commands: false, seen: true, sightings: true, words: true, plan: true };
    this.trail = told.match ? TRAILS[1] : TRAILS[2];
    this.selected = told.robots.length === 1 ? 0 : -1;
    this.following = false;
    this.drawn = 0;
    this.panelled = 0;
    this.player = new Player(told.duration, () => this.changed());
    this.picture = new Picture(byId("field"), told);
    this.timeline = new Timeline(byId("timeline"), byId("tip"), {
      duration: told.duration,
      events: told.events,
      ribbon: (pieces) => this.ribbon(pieces),
      notch: told.match && told.match.length / 2 < told.duration ? told.match.length / 2 : 0,
    });
    this.fillPage();
    this.controls = new Controls(this);
    new ResizeObserver(() => this.resize()).observe(byId("stage"));
    window.addEventListener("resize", () => this.resize());
    window.addEventListener("hashchange", () => this.goToHash());
    this.resize();
    this.goToHash();
  }

  // What never changes.
  fillPage() {
    const { told } = this.recording;
    byId("app").className = told.match ? "match" : "run";
    const names = told.match ? told.match.names : [told.scenario, ""];
    setText(byId("home"), names[0]);
    setText(byId("away"), names[1]);
    byId("away").hidden = !told.match;
    byId("figures").hidden = !told.match;
    byId("robots").hidden = !told.robots.length;
    setText(byId("source"), `${told.scenario} · seed ${told.seed} · soccersim ${told.soccersim} · ${told.digest.slice(0, 12)}`);
    fillEvents(told.events, told.match ? 0 : 1, (event) => this.player.seek(event.time));
    const wide = Math.max(...[0, 1].map((team) => told.robots.filter((robot) => robot.team === team).length));
    byId("badges").style.setProperty("--wide", wide);
    byId("badges").replaceChildren(...told.robots.map((robot, i) => {
      const badge = make("button", String(robot.number), { type: "button", "data-team": robot.team, title: robot.name, "aria-label": robot.name });
      badge.addEventListener("click", () => this.pick(this.selected === i ? -1 : i));
      return badge;
    }));
    byId("keys").replaceChildren(...KEYS.flatMap(([key, does]) => {
      const name = make("dt");
      name.append(...key.split(" ").flatMap((each) => [make("kbd", each), " "]));
      return [name, make("dd", does)];
    }));
    fillSigns(told);
  }

  // Of so many equal pieces of time, who had the ball in the middle of each.
  ribbon(pieces) {
    const { holder } = this.recording.channels;
    const { told } = this.recording;
    return Array.from({ length: pieces }, (_, i) => {
      const row = this.recording.row(((i + 0.5) / pieces) * told.duration);
      const robot = holder ? holder[0][row] : -1;
      return robot < 0 ? -1 : told.robots[robot].team;
    });
  }

  // #t=12.5 in the address: a link to a moment.
  goToHash() {
    const found = /[#&]t=([0-9.]+)/.exec(location.hash);
    if (found) this.player.seek(Number(found[1]));
  }

  resize() {
    this.picture.resize();
    this.timeline.resize();
    this.changed();
  }

  // Draw with the next picture of the screen.
  changed() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame((now) => {
      this.asked = false;
      this.draw(now);
    });
  }

  draw(now) {
    const { player, picture, recording } = this;
    const moment = recording.moment(player.time, this.show.trails ? this.trail : 0);
    this.moment = moment;
    if (this.following) {
      const goal = this.selected >= 0 ? moment.robots[this.selected] : moment.ball;
      if (goal) picture.view.centre(goal.x, goal.y);
    }
    picture.draw(moment, this.show, this.selected);
    this.timeline.draw(player.time);
    if (!player.playing || now - this.panelled > PANELS) this.drawPanels(moment, now);
    this.drawn++;
  }

  drawPanels(moment, now) {
    const { player, picture, recording } = this;
    this.panelled = now;
    showTop(recording, moment);
    showFigures(recording, moment);
    showNumbers(recording, moment, this.selected);
    showEvents(recording.told.events, moment.time);
    byId("play").classList.toggle("on", player.playing);
    byId("play").setAttribute("aria-label", player.playing ? "pause" : "play");
    byId("time").replaceChildren(clock(player.time, 2), make("small", ` / ${clock(player.duration, recording.told.match ? 0 : 2)}`));
    byId("speed").value = player.speed;
    byId("follow").setAttribute("aria-pressed", this.following);
    byId("whole").hidden = picture.view.zoom <= 1;
    picture.canvas.classList.toggle("near", picture.view.zoom > 1);
    [...byId("badges").children].forEach((badge, i) => {
      badge.setAttribute("aria-pressed", i === this.selected);
      badge.classList.toggle("off", !moment.robots[i].inPlay);
    });
  }

  // Frames back or on.
  step(frames) {
    const { player, recording } = this;
    player.pause();
    const row = recording.row(player.time);
    const between = frames < 0 && player.time > recording.times[row] + 1e-6;
    const next = Math.min(Math.max(row + (between ? 0 : frames), 0), recording.rows - 1);
    player.seek(recording.times[next]);
  }

  // To the next event, or back to the one before.
  jump(way) {
    const { player, recording } = this;
    const events = recording.told.events.filter((event) => event.level > 1);
    const late = player.playing ? 1 : 1e-3; // while it plays one may press twice
    const found = way > 0
      ? events.find((event) => event.time > player.time + 1e-3)
      : events.filter((event) => event.time < player.time - late).pop();
    if (found) player.seek(found.time);
    else if (way < 0) player.seek(0);
  }

  pick(index) {
    this.selected = index;
    if (index < 0) this.following = false;
    this.changed();
  }

  pickNumber(number, away) {
    const found = this.recording.told.robots.findIndex((robot) => robot.number === number && robot.team === Number(away));
    if (found >= 0) this.pick(found);
  }

  pickAt(u, v) {
    const index = this.picture.robotAt(this.moment, u, v);
    this.pick(index === this.selected ? -1 : index);
  }

  follow(wanted) {
    const { view } = this.picture;
    this.following = wanted;
    view.zoom = wanted ? Math.max(view.zoom, CLOSE) : 1;
    if (!wanted) view.whole();
    this.changed();
  }

  whole() {
    if (this.picture.view.zoom > 1) this.follow(false);
    else this.pick(-1);
    this.changed();
  }
}

// What the signs on the field mean.
function fillSigns(told) {
  const signs = [
    ["believed", "where a robot believes it is, where that can be told from where it is"],
    ...(told.match
      ? [["seen", "the ball as a team believes it to be; dashed: not seen for half a second"],
         ...(told.channels.some(({ key }) => key === "sighted_x")
           ? [["sighting", "where a robot's camera saw the ball in the last half second; a line to the robot that is picked"]]
           : []),
         ["halo", "this robot has the ball in its mouth"]]
      : [["target", "path, target and set-point that the robot is told"]]),
  ];
  byId("signs").replaceChildren(...signs.flatMap(([kind, text]) => {
    const name = make("dt");
    name.append(make("span", "", { class: `sign ${kind}` }));
    return [name, make("dd", text)];
  }));
  setText(byId("holds"), "Places are in the field frame: metres from the centre spot, degrees counter-clockwise.");
}

async function start() {
  const theme = new Theme(() => window.soccersim.app && window.soccersim.app.resize());
  await new Promise((done) => {
    if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", done);
    else done();
  });
  if (!window.DecompressionStream) throw new Error("this browser is too old for the page: it has no DecompressionStream");
  const { told, channels } = await unpacked(byId("data").textContent);
  byId("data").remove();
  return new App(new Recording(told, channels), theme);
}

window.soccersim = { app: null };
window.soccersim.ready = start().then(
  (app) => {
    window.soccersim.app = app;
    window.soccersim.opened = performance.now(); // ms since the page was asked for
    return true;
  },
  (error) => {
    byId("app").hidden = true;
    byId("notice").hidden = false;
    byId("notice").textContent = `The replay cannot be shown: ${error.message}`;
    throw error;
  },
);
