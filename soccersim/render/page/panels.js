// What stands beside the picture: score and phase, a robot's numbers, the list of events.

const byId = (id) => document.getElementById(id);
const DEGREES = 180 / Math.PI;
const RPM = 30 / Math.PI;

// An element with text; what teams wrote never becomes anything but text.
function make(tag, text = "", attributes = {}) {
  const element = document.createElement(tag);
  element.textContent = text;
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}

function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

// Minutes and seconds, with so many decimals.
function clock(seconds, decimals = 0) {
  const unit = 10 ** decimals;
  const whole = Math.floor(seconds * unit + 1e-6);
  const minutes = Math.floor(whole / unit / 60);
  const rest = ((whole - minutes * 60 * unit) / unit).toFixed(decimals);
  return `${minutes}:${rest.padStart(decimals ? decimals + 3 : 2, "0")}`;
}

function number(value, decimals) {
  if (value === undefined || !Number.isFinite(value)) return "–";
  const text = Math.abs(value).toFixed(decimals);
  return (value < 0 && Number(text) !== 0 ? "−" : "") + text;
}

function turn(radians) {
  return (((radians * DEGREES + 180) % 360) + 360) % 360 - 180;
}

// A table: heads, and rows of a name and cells.
function table(heads, rows) {
  const element = make("table");
  if (heads) {
    const head = make("tr");
    head.append(...heads.map((text) => make("th", text, text === "believes" ? { class: "belief" } : {})));
    element.createTHead().append(head);
  }
  const body = element.createTBody();
  for (const [name, ...cells] of rows) {
    const row = make("tr");
    row.append(make("th", name, { scope: "row" }), ...cells.map((cell) => make("td", cell)));
    body.append(row);
  }
  return element;
}

// The line above the field.
function showTop(recording, moment) {
  const { told } = recording;
  const [word, team, about] = moment.state;
  setText(byId("clock"), clock(moment.time));
  setText(byId("phase"), word);
  setText(byId("about"), about);
  byId("phase").dataset.team = team === null ? "" : team;
  if (!told.match) return;
  const left = Math.max(0, Math.ceil((told.match.length * moment.half) / 2 - moment.time - 1e-6));
  setText(byId("half"), `${moment.half === 1 ? "1st" : "2nd"} half, ${clock(left)} left`);
  setText(byId("score"), moment.score.join(" : "));
  byId("arrow-home").dataset.way = moment.direction;
  byId("arrow-away").dataset.way = -moment.direction;
  const said = recording.decision(moment.time);
  setText(byId("said"), said ? said.text : "");
  byId("said").dataset.team = said && said.team !== null ? said.team : "";
  byId("said").classList.toggle("old", Boolean(said) && said.age > 5);
}

// Possession, shots and passes so far.
function showFigures(recording, moment) {
  const { told } = recording;
  if (!told.match) return;
  const until = (kind, team) => lastUpTo(told.match[kind][team].length, moment.time, (i) => told.match[kind][team][i]) + 1;
  const share = moment.possession;
  const bar = make("div", "", { class: share < 0 ? "share none" : "share" });
  const part = make("i");
  part.style.width = `${Math.max(share, 0)}%`;
  bar.append(part, ...(share < 0 ? ["", "possession", ""] : [`${share} %`, "possession", `${100 - share} %`]).map((text) => make("span", text)));
  const rows = make("table");
  for (const [name, cell] of [
    ["shots (on goal)", (team) => `${until("shots", team)} (${until("on_goal", team)})`],
    ["passes", (team) => String(until("passes", team))],
  ]) {
    const row = make("tr");
    row.append(make("td", cell(0)), make("th", name), make("td", cell(1)));
    rows.append(row);
  }
  byId("figures").replaceChildren(bar, rows);
}

// The numbers of one robot.
function showNumbers(recording, moment, index) {
  const panel = byId("numbers");
  if (index < 0) {
    panel.replaceChildren(make("p", "Pick a robot, here or on the field, for its numbers."));
    return;
  }
  const robot = moment.robots[index];
  const { believed } = robot;
  const player = recording.told.robots[index];
  const title = make("h3", player.name);
  title.append(make("span", robot.inPlay ? robot.label : "out of play"));
  const off = Math.hypot(robot.x - believed.x, robot.y - believed.y);
  const pose = table(["", "true", "believes", "off by"], [
    ["x, m", number(robot.x, 3), number(believed.x, 3), number(believed.x - robot.x, 3)],
    ["y, m", number(robot.y, 3), number(believed.y, 3), number(believed.y - robot.y, 3)],
    ["heading, °", number(turn(robot.heading), 1), number(turn(believed.heading), 1), number(turn(believed.heading - robot.heading), 1)],
    ["distance, cm", "", "", number(100 * off, 1)],
  ]);
  const moves = recording.velocity("robot", index, moment.row, ROBOT_JUMP);
  const rows = [["speed, m/s", number(moves.speed, 2)], ["turning, °/s", number(moves.turn * DEGREES, 0)]];
  if (robot.command) {
    const { x, y, turn: omega } = robot.command;
    rows.push(["told: ahead, left, m/s", `${number(x, 2)}, ${number(y, 2)}`]);
    rows.push(["told: turning, °/s", number(omega * DEGREES, 0)]);
  }
  if (recording.told.match) {
    const [kick, dribble] = [robot.kick > 0 ? `kick at ${number(robot.kick, 1)} m/s` : "", robot.dribble ? "dribble" : ""];
    rows.push(["told: ball", [kick, dribble].filter(Boolean).join(", ") || "–"]);
    const seen = moment.sightings.filter((sighting) => sighting.robot === index).pop();
    rows.push(["sees the ball at x, y, m", seen ? `${number(seen.x, 2)}, ${number(seen.y, 2)}` : "–"]);
    rows.push(["ball in its mouth", robot.contact ? "yes" : "no"]);
  }
  panel.replaceChildren(title, pose, table(null, [...rows, ...planned(recording, robot, index, moment.row)]), ...wheels(recording, index, moment.row));
}

// How far a robot is from where it is sent.
function planned(recording, robot, index, row) {
  if (!robot.target) return [];
  const { targets } = recording.told.robots[index];
  const leg = recording.value("leg", index, row);
  const away = Math.hypot(robot.x - robot.target.x, robot.y - robot.target.y);
  return [
    ["leg", leg < targets.length || recording.told.robots[index].repeat ? `${(leg % targets.length) + 1} of ${targets.length}` : "done"],
    ["to its target, m, °", `${number(away, 3)}, ${number(turn(robot.target.heading - robot.heading), 1)}`],
  ];
}

// Wheels and gyro, as far as the run has recorded them.
function wheels(recording, index, row) {
  const { channels, told } = recording;
  const rows = [];
  if (channels.gyro) rows.push(table(null, [["gyro, °/s", number(recording.value("gyro", index, row) * DEGREES, 1)]]));
  const keys = [["wheel_speed", "rpm", RPM, 0], ["wheel_setpoint", "set", RPM, 0], ["pwm", "PWM", 1, 0], ["counts", "counts", 1, 0]];
  const known = keys.filter(([key]) => channels[key]);
  if (!known.length) return rows;
  const each = channels[known[0][0]].length / told.robots.length;
  const model = told.models[told.robots[index].model];
  const lines = model.wheels.map(([, , , , , , dead], wheel) => {
    const cells = known.map(([key, , unit, decimals]) => {
      const there = key === "counts" ? model.counted[Number(dead)] : key === "wheel_speed" || !dead;
      return number(there ? recording.value(key, index * each + wheel, row) * unit : NaN, decimals);
    });
    return [`wheel ${wheel + 1}`, ...cells];
  });
  return [...rows, table(["", ...known.map(([, head]) => head)], lines)];
}

// Names like home-1 stay on one line.
function unbroken(text) {
  return text.replace(/(\w)-(\d)/g, "$1\u2011$2");
}

// The list of events, each a button that goes there.
function fillEvents(events, decimals, go) {
  const items = events.filter((event) => event.level > 0).map((event) => {
    const button = make("button", "", { type: "button", "data-level": event.level, "data-kind": event.kind, title: event.rule || "" });
    if (event.side !== null) button.dataset.team = event.side;
    button.append(make("time", clock(event.time, decimals)), make("i"), make("span", unbroken(event.text)));
    button.addEventListener("click", () => go(event));
    const item = make("li");
    item.append(button);
    return item;
  });
  byId("list").replaceChildren(...items);
  if (!items.length) byId("list").append(make("li", "none", { class: "faint" }));
}

// Marks the last event so far, and brings it into sight.
function showEvents(events, time) {
  const listed = events.filter((event) => event.level > 0);
  const at = lastUpTo(listed.length, time + 1e-6, (i) => listed[i].time);
  const list = byId("list");
  const old = list.querySelector(".now");
  const now = at < 0 ? null : list.children[at].firstElementChild;
  if (old === now) return;
  if (old) old.classList.remove("now");
  if (!now) return;
  now.classList.add("now");
  const item = list.children[at];
  list.scrollTop = item.offsetTop - list.clientHeight / 2;
}
