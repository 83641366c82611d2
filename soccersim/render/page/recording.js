// A recording as a source of moments: all that picture.js draws and the panels tell.

const ROBOT_JUMP = 10; // m/s; faster, it was carried there: nothing lies between
const BALL_JUMP = 25;
const SPAN = 3; // rows to either side, over which velocities are measured
const NOTE_NUMBERS = { line: 4, circle: 3, text: 2 };
const SIGHTINGS = 0.5; // s for which a sighting is shown

// The last index whose number is not above the value; -1 before the first.
function lastUpTo(count, value, numberAt) {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (numberAt(middle) <= value) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

class Recording {
  constructor(told, channels) {
    this.told = told;
    this.channels = channels;
    this.rows = told.rows;
    this.times = channels.tick[0].map((tick) => tick / told.hz);
    this.duration = told.duration;
    this.dt = this.rows > 1 ? this.times[1] - this.times[0] : 1;
    this.labels = told.robots.map((_, row) => (told.match ? told.match.labels.filter((label) => label[1] === row) : []));
  }

  // The row that holds at a time.
  row(time) {
    return Math.max(0, lastUpTo(this.rows, time + 1e-6, (i) => this.times[i]));
  }

  // A pose from the channels name_x, name_y, name_heading, between two rows.
  pose(name, column, row, share, jump) {
    const [x, y, heading] = ["x", "y", "heading"].map((part) => this.channels[`${name}_${part}`]);
    const pose = { x: x[column][row], y: y[column][row], heading: heading[column][row] };
    if (share > 0 && row + 1 < this.rows) {
      const dx = x[column][row + 1] - pose.x;
      const dy = y[column][row + 1] - pose.y;
      if (Math.hypot(dx, dy) <= jump * (this.times[row + 1] - this.times[row])) {
        pose.x += share * dx;
        pose.y += share * dy;
        pose.heading += share * (heading[column][row + 1] - pose.heading);
      }
    }
    return pose;
  }

  velocity(name, column, row, jump) {
    let [first, last] = [Math.max(0, row - SPAN), Math.min(this.rows - 1, row + SPAN)];
    const [x, y, heading] = ["x", "y", "heading"].map((part) => this.channels[`${name}_${part}`][column]);
    for (let i = first; i < last; i++) {
      const step = Math.hypot(x[i + 1] - x[i], y[i + 1] - y[i]);
      if (step > jump * (this.times[i + 1] - this.times[i])) {
        if (i < row) first = i + 1;
        else last = i;
      }
    }
    const time = this.times[last] - this.times[first] || 1;
    return {
      speed: Math.hypot(x[last] - x[first], y[last] - y[first]) / time,
      turn: (heading[last] - heading[first]) / time,
    };
  }

  value(key, column, row) {
    const channel = this.channels[key];
    return channel ? channel[column][row] : undefined;
  }

  // What holds at a row of a list of [row, value].
  holding(list, row) {
    const at = lastUpTo(list.length, row, (i) => list[i][0]);
    return at < 0 ? null : list[at][1];
  }

  saidAt(list, time) {
    const at = lastUpTo(list.length, time + 1e-6, (i) => list[i][0]);
    return at < 0 ? null : list[at][2];
  }

  robot(index, row, share, time) {
    const player = this.told.robots[index];
    const robot = {
      ...this.pose("robot", index, row, share, ROBOT_JUMP),
      believed: this.pose("believed", index, row, share, ROBOT_JUMP),
      inPlay: this.value("in_play", index, row) !== 0,
      contact: this.value("contact", index, row) === 1,
      label: this.saidAt(this.labels[index], time) || "",
    };
    if (this.channels.command_x) {
      const [x, y, turn] = ["x", "y", "turn"].map((part) => this.value(`command_${part}`, index, row));
      robot.command = { x, y, turn };
      robot.kick = this.value("kick", index, row);
      robot.dribble = this.value("dribble", index, row);
    }
    if (this.channels.reference_x) {
      const pose = this.pose("reference", index, row, 0, 0);
      robot.reference = Number.isFinite(pose.x) ? pose : null;
      robot.target = this.target(player, this.value("leg", index, row));
    }
    return robot;
  }

  target(player, leg) {
    const count = player.targets.length;
    if (!count) return null;
    const [x, y, heading] = player.targets[player.repeat ? leg % count : Math.min(leg, count - 1)];
    return { x, y, heading };
  }

  // Where a body was in the last seconds, since it was last carried.
  trail(name, column, row, seconds, jump) {
    const x = this.channels[`${name}_x`][column];
    const y = this.channels[`${name}_y`][column];
    const points = [];
    const first = Math.max(0, row - Math.round(seconds / this.dt));
    for (let i = first; i <= row; i++) {
      if (i > first && Math.hypot(x[i] - x[i - 1], y[i] - y[i - 1]) > jump * this.dt) points.length = 0;
      points.push([x[i], y[i]]);
    }
    return points;
  }

  // Where the camera of each robot has put the ball lately, the newest last. What is told is how far
  // from the ball it was, as that lay when the picture was taken.
  sightings(time, row) {
    const { sighted_x: dx, sighted_y: dy, ball_x: [x], ball_y: [y] } = this.channels;
    const found = [];
    for (let i = row; dx && i >= 0 && time - this.times[i] < SIGHTINGS; i--) {
      const then = Math.max(0, i - this.told.late);
      const share = 1 - (time - this.times[i]) / SIGHTINGS;
      dx.forEach((column, robot) => {
        const place = { x: x[then] + column[i], y: y[then] + dy[robot][i] };
        if (Number.isFinite(place.x)) found.push({ ...place, robot, share });
      });
    }
    return found.reverse();
  }

  // What a team has drawn: the kind of each note, its numbers, of a text the words.
  notes(team, row) {
    const columns = this.channels[`notes_${team}`];
    let next = 0;
    return (this.holding(this.told.match.notes[team], row) || []).map(([kind, ...words]) => {
      const numbers = columns.slice(next, (next += NOTE_NUMBERS[kind])).map((column) => column[row]);
      return [kind, ...numbers, ...words];
    });
  }

  kicks(time, seconds) {
    const list = this.told.match ? this.told.match.kicks : [];
    const kicks = [];
    for (let i = lastUpTo(list.length, time, (k) => list[k][0]); i >= 0 && list[i][0] > time - seconds; i--) {
      const [at, robot, x, y, vx, vy] = list[i];
      kicks.push({ x, y, vx, vy, team: this.told.robots[robot].team, age: (time - at) / seconds });
    }
    return kicks;
  }

  links(row, share) {
    return this.told.arms.map((_, arm) => [0, 1, 2].map((k) => this.pose("link", 3 * arm + k, row, share, 1e9)));
  }

  // Everything at a time; trail: seconds of it.
  moment(time, trail) {
    const { told, channels } = this;
    const row = this.row(time);
    const gap = row + 1 < this.rows ? this.times[row + 1] - this.times[row] : 1;
    const share = Math.min(Math.max((time - this.times[row]) / gap, 0), 1);
    const moment = {
      time,
      row,
      robots: told.robots.map((_, i) => this.robot(i, row, share, time)),
      ball: told.ball === null ? null : this.pose("ball", 0, row, share, BALL_JUMP),
      links: this.links(row, share),
      trails: told.robots.map((_, i) => this.trail("robot", i, row, trail, ROBOT_JUMP)),
      believedTrails: told.match ? [] : told.robots.map((_, i) => this.trail("believed", i, row, trail, ROBOT_JUMP)),
      ballTrail: told.ball === null ? [] : this.trail("ball", 0, row, trail, BALL_JUMP),
      routes: told.match ? [] : told.robots.map((player) => this.route(player)),
      kicks: this.kicks(time, told.look.flash),
      seen: [null, null],
      sightings: told.match ? this.sightings(time, row) : [],
      notes: told.match ? [0, 1].map((team) => this.notes(team, row)) : [[], []],
      direction: 1,
      state: this.holding(told.match ? told.match.states : told.states, row) || ["", null, ""],
    };
    if (told.match) {
      moment.direction = channels.direction[0][row];
      moment.seen = [0, 1].map((team) => {
        const [x, y, age] = ["x", "y", "age"].map((part) => channels[`seen_${part}`][team][row]);
        return Number.isFinite(x) ? { x, y, age } : null;
      });
      moment.score = this.holding(told.match.scores, row);
      moment.half = this.holding(told.match.halves, row);
      moment.possession = channels.possession[0][row];
    }
    return moment;
  }

  // The way that a robot is told to go: its start and its targets.
  route(player) {
    const places = player.targets.length ? [player.start, ...player.targets] : [];
    if (player.repeat && places.length) places.push(player.targets[0]);
    return places.map(([x, y]) => [x, y]);
  }

  // The referee's last decision: text, slot or null, and its age in seconds.
  decision(time) {
    const list = this.told.match ? this.told.match.said : [];
    const at = lastUpTo(list.length, time + 1e-6, (i) => list[i][0]);
    return at < 0 ? null : { text: list[at][1], team: list[at][2], age: time - list[at][0] };
  }
}
