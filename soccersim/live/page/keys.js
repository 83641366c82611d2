// Buttons and keys.

class Keys {
  constructor(app) {
    this.app = app;
    this.buttons();
    this.forms();
    document.addEventListener("keydown", (event) => this.down(event));
    document.addEventListener("keyup", (event) => this.up(event.key.length > 1 ? event.key : event.key.toLowerCase()));
    window.addEventListener("blur", () => app.held.clear());
    byId("clicks").replaceChildren(...CLICKS.flatMap(([what, does]) => [make("dt", what), make("dd", does)]));
    byId("keys").replaceChildren(...HELP.flatMap(([keys, does]) => {
      const name = make("dt");
      name.append(...keys.split(" ").flatMap((each) => [make("kbd", each), " "]));
      return [name, make("dd", does)];
    }));
    byId("signs").replaceChildren(...SIGNS.flatMap(([kind, does]) => {
      const name = make("dt");
      name.append(make("span", "", { class: `sign ${kind}` }));
      return [name, make("dd", does)];
    }));
    app.setTool("send");
  }

  buttons() {
    const { app } = this;
    const on = (id, act) => byId(id).addEventListener("click", act);
    on("play", () => app.moment && app.actions.pause(!app.moment.paused));
    on("step", () => app.actions.step(app.moments.told.control));
    on("again", () => openedBy(app));
    on("follow", () => app.follow(!app.following));
    on("whole", () => app.follow(false));
    on("theme", () => app.toggleTheme());
    on("help", () => this.help());
    on("halt", () => app.actions.halt(app.selected));
    on("release", () => app.actions.release(app.selected));
    on("kick", () => app.actions.kick(app.selected, Number(byId("power").value)));
    on("dribble", () => app.moment && app.actions.dribble(app.selected, app.moments.of(app.moments.now, app.selected, "dribble") === 0));
    for (const button of document.querySelectorAll("[data-tool]")) button.addEventListener("click", () => app.setTool(button.dataset.tool));
    byId("power").addEventListener("input", () => setText(byId("power-told"), `${byId("power").value} m/s`));
    byId("speed").addEventListener("change", () => {
      app.actions.speed(Number(byId("speed").value));
      byId("speed").blur();
    });
  }

  forms() {
    const { app } = this;
    byId("open").addEventListener("submit", (event) => {
      event.preventDefault();
      openedBy(app);
    });
    byId("send").addEventListener("submit", (event) => {
      event.preventDefault();
      const [x, y, heading] = ["x", "y", "heading"].map((id) => {
        const text = byId(id).value.trim().replace(",", ".").replace("−", "-");
        return text === "" ? null : Number(text);
      });
      if (x === null || y === null || [x, y, heading].some(Number.isNaN)) app.actions.complain("type x and y in metres, as 1.5 and -2; the heading in degrees may stay empty");
      else app.actions.go(app.selected, x, y, heading === null ? null : heading / DEGREES);
    });
  }

  help() {
    const guide = byId("guide");
    if (guide.open) guide.close();
    else guide.showModal();
  }

  down(event) {
    const { app } = this;
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (byId("guide").open) {
      if (["Escape", "?"].includes(event.key)) this.help();
      return;
    }
    if (!(app.moment || event.key === "?") || event.target.closest("input, select, textarea")) return;
    if (event.target.closest("button, summary") && [" ", "Enter"].includes(event.key)) return;
    const key = event.key.length > 1 ? event.key : event.key.toLowerCase();
    if (WAYS[key]) {
      app.held.add(key);
      if (!event.repeat) app.drive();
    } else if (!this.act(event, key)) return;
    event.preventDefault();
  }

  up(key) {
    const { app } = this;
    if (app.held.delete(key) && !app.held.size) app.actions.halt(app.selected);
  }

  // Whether the key does something here.
  act(event, key) {
    const { app } = this;
    const digit = /^(?:Digit|Numpad)([1-9])$/.exec(event.code);
    const click = (id) => () => byId(id).disabled || byId(id).click();
    const keys = {
      " ": click("play"),
      ".": click("step"),
      ":": () => app.actions.step(1),
      ">": () => app.actions.step(1),
      "-": () => app.shift(-1),
      "+": () => app.shift(1),
      "=": () => app.shift(1),
      0: () => app.actions.speed(1),
      r: click("again"),
      s: () => app.setTool("send"),
      b: () => app.setTool("ball"),
      p: () => app.setTool("push"),
      h: click("halt"),
      k: click("kick"),
      d: click("dribble"),
      f: () => app.follow(!app.following),
      m: () => app.toggleTheme(),
      "?": () => this.help(),
      Escape: () => app.follow(false),
    };
    if (digit) {
      const found = app.moments.told.robots.findIndex((robot) => robot.number === Number(digit[1]) && robot.team === Number(event.shiftKey));
      app.pick(found);
      return true;
    }
    if (!keys[key] || event.repeat) return Boolean(keys[key]);
    keys[key]();
    return true;
  }
}

// Chips for what is shown.
function fillToggles(app) {
  const { told } = app.moments;
  const fits = { seen: told.match, sightings: told.match, words: told.match };
  byId("toggles").replaceChildren(...SHOWN.filter(([what]) => fits[what] !== null).map(([what, name]) => {
    const chip = make("button", "", { type: "button" });
    const tell = () => {
      setText(chip, what === "trails" && app.show.trails ? `${name} ${app.trail} s` : name);
      chip.setAttribute("aria-pressed", Boolean(app.show[what]));
    };
    chip.addEventListener("click", () => {
      if (what === "trails") {
        app.trail = TRAIL[(TRAIL.indexOf(app.trail) + 1) % TRAIL.length];
        app.show.trails = app.trail > 0;
      } else app.show[what] = !app.show[what];
      tell();
    });
    tell();
    return chip;
  }));
}

const PATIENCE = 1500; // ms without a picture; then one is told so

// What is waited for, and for how long.
function setWaiting(app) {
  const { link, moments } = app;
  const waits = moments && moments.told.waits;
  let [text, since] = ["", link.silence];
  if (!link.up) text = link.refusal || "no connection; trying again …";
  else if (waits && !(app.moment && app.moment.time > 0)) [text, since] = [waits[0], 1000 * waits[1] + performance.now() - app.begun];
  else if (since > PATIENCE) text = "the simulation is busy; one moment …";
  setText(byId("veil"), text && !link.refusal ? `${text} · ${Math.floor(since / 1000)} s` : text);
  byId("veil").hidden = !text;
}

// Score, phase and clock of a match.
function showMatch(moment) {
  setText(byId("score"), moment.score.join(" : "));
  setText(byId("half"), moment.over ? "" : `${moment.half === 1 ? "1st" : "2nd"} half, ${clock(moment.left)} to the end`);
  const word = moment.phase.replace("_", "-");
  setText(byId("phase"), moment.paused ? `${word}, stands` : word);
  byId("phase").dataset.team = moment.whose < 0 ? "" : moment.whose;
  const next = { stop: "the next signal is awaited", play: "the ball is in play", over: "the match is over" }[moment.phase];
  const who = moment.whose < 0 ? "all" : ["home", "away"][moment.whose];
  setText(byId("about"), next || (moment.started ? `START: ${who} may play the ball` : "robots take their places"));
}
