// Marks about what moves: in metres ways, commands, targets, kicks, balls believed and seen; in pixels words.

const FADES = 8; // steps in which a trail fades
const FAINTEST = 0.1;
const AHEAD = 0.4; // s: an arrow ends where the command leads in that time
const SLOWEST = 0.03; // m/s; a slower command has no arrow
const TURN = 0.25; // rad/s; a slower turn has no arc

function drawTrail(pen, points, colour, width, dash) {
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.lineCap = "butt"; // round ends would shine through where two steps meet
  pen.lineJoin = "round";
  pen.setLineDash(dash || []);
  const size = Math.max(1, Math.ceil((points.length - 1) / FADES));
  for (let start = 0, step = 0; start + 1 < points.length; start += size, step++) {
    pen.globalAlpha = FAINTEST + ((1 - FAINTEST) * (step + 1)) / FADES;
    pen.beginPath();
    let broken = true;
    for (const [x, y] of points.slice(start, start + size + 1)) {
      if (Number.isNaN(x)) broken = true;
      else if (broken) pen.moveTo(x, y);
      else pen.lineTo(x, y);
      if (!Number.isNaN(x)) broken = false;
    }
    pen.stroke();
  }
  pen.globalAlpha = 1;
  pen.setLineDash([]);
}

function arrowHead(pen, x, y, angle, size) {
  pen.beginPath();
  pen.moveTo(x + size * Math.cos(angle), y + size * Math.sin(angle));
  for (const side of [2.5, -2.5]) pen.lineTo(x + size * Math.cos(angle + side), y + size * Math.sin(angle + side));
  pen.closePath();
  pen.fill();
}

// The velocity that a robot is told, and the sense in which it shall turn.
function drawCommand(pen, colour, radius, robot, pixel) {
  const { x, y, turn } = robot.command;
  const speed = Math.hypot(x, y);
  const angle = robot.heading + Math.atan2(y, x);
  pen.strokeStyle = pen.fillStyle = colour;
  pen.lineWidth = 2 * pixel;
  pen.lineCap = "butt";
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  if (speed > SLOWEST) {
    const [from, to] = [radius, radius + AHEAD * speed];
    trace(pen, [[robot.x + from * c, robot.y + from * s], [robot.x + to * c, robot.y + to * s]]);
    pen.stroke();
    arrowHead(pen, robot.x + to * c, robot.y + to * s, angle, 5 * pixel);
  }
  if (Math.abs(turn) > TURN) {
    const [ring, end] = [radius + 4 * pixel, robot.heading + Math.max(-2.6, Math.min(2.6, AHEAD * turn))];
    pen.lineWidth = 1.5 * pixel;
    pen.beginPath();
    pen.arc(robot.x, robot.y, ring, robot.heading, end, turn < 0);
    pen.stroke();
    const tip = [robot.x + ring * Math.cos(end), robot.y + ring * Math.sin(end)];
    arrowHead(pen, ...tip, end + (Math.sign(turn) * Math.PI) / 2, 4 * pixel);
  }
}

// A ring with a cross, and an arrow head for the heading.
function drawTarget(pen, look, pose, pixel) {
  const radius = Math.max(look.target_radius, 7 * pixel);
  pen.strokeStyle = pen.fillStyle = look.target;
  pen.lineWidth = Math.max(0.16 * radius, 1.6 * pixel); // far less than the radius
  at(pen, pose, () => {
    pen.beginPath();
    pen.arc(0, 0, radius - pen.lineWidth / 2, 0, 2 * Math.PI);
    for (const [x, y] of [[0.62, 0], [0, 0.62]]) {
      pen.moveTo(-x * radius, -y * radius);
      pen.lineTo(x * radius, y * radius);
    }
    pen.stroke();
    trace(pen, [[1.85 * radius, 0], [1.12 * radius, 0.5 * radius], [1.12 * radius, -0.5 * radius]], true);
    pen.fill();
  });
}

// The set-point of this moment: a small diamond with its heading.
function drawReference(pen, look, pose, pixel) {
  const size = 5 * pixel;
  pen.fillStyle = look.target;
  at(pen, pose, () => {
    trace(pen, [[1.6 * size, 0], [0, 0.8 * size], [-0.8 * size, 0], [0, -0.8 * size]], true);
    pen.fill();
  });
}

function drawRoute(pen, look, points, pixel) {
  trace(pen, points);
  pen.setLineDash([6 * pixel, 4 * pixel]);
  pen.strokeStyle = look.target + "b0";
  pen.lineWidth = 1.4 * pixel;
  pen.stroke();
  pen.setLineDash([]);
  for (const [x, y] of points) disc(pen, x, y, 2.5 * pixel, look.target);
}

function drawKick(pen, look, kick, pixel) {
  const speed = Math.hypot(kick.vx, kick.vy);
  pen.globalAlpha = 1 - kick.age;
  pen.strokeStyle = look.tints[kick.team];
  pen.lineWidth = 3 * pixel;
  if (speed > 0) {
    const length = Math.min(Math.max(0.12 * speed, 26 * pixel), 90 * pixel);
    trace(pen, [[kick.x, kick.y], [kick.x + (length * kick.vx) / speed, kick.y + (length * kick.vy) / speed]]);
    pen.stroke();
  }
  pen.lineWidth = Math.max(pixel, 2.5 * pixel * (1 - kick.age));
  pen.beginPath();
  pen.arc(kick.x, kick.y, (7 + 15 * kick.age) * pixel, 0, 2 * Math.PI);
  pen.stroke();
  pen.globalAlpha = 1;
}

// Crosses where cameras have put the ball; they fade. Those of one moment are drawn at once.
function drawSightings(pen, colour, sightings, pixel) {
  const half = 3 * pixel;
  pen.strokeStyle = colour;
  pen.lineWidth = 1.3 * pixel;
  sightings.forEach(({ x, y, share }, i) => {
    if (!i || sightings[i - 1].share !== share) pen.beginPath();
    for (const side of [half, -half]) {
      pen.moveTo(x - half, y - side);
      pen.lineTo(x + half, y + side);
    }
    if (sightings[i + 1] && sightings[i + 1].share === share) return;
    pen.globalAlpha = share;
    pen.stroke();
  });
  pen.globalAlpha = 1;
}

// From where a robot believes it is to where it saw the ball.
function drawSightLine(pen, colour, from, { x, y, share }, pixel) {
  pen.globalAlpha = 0.7 * share;
  pen.strokeStyle = colour;
  pen.lineWidth = pixel;
  trace(pen, [[from.x, from.y], [x, y]]);
  pen.stroke();
  pen.globalAlpha = 1;
}

// The ball as a team believes it.
function drawSeen(pen, look, team, seen, radius, pixel) {
  if (!seen) return;
  const old = seen.age > look.old;
  const size = Math.max(radius, 6.5 * pixel);
  disc(pen, seen.x, seen.y, size, look.teams[team] + (old ? "1e" : "3c"));
  pen.strokeStyle = look.tints[team] + (old ? "80" : "ff");
  pen.lineWidth = 1.6 * pixel;
  pen.setLineDash(old ? [3 * pixel, 3 * pixel] : []);
  pen.beginPath();
  pen.arc(seen.x, seen.y, size, 0, 2 * Math.PI);
  pen.stroke();
  pen.setLineDash([]);
}

// Lines and circles that a team drew.
function drawNote(pen, colour, [kind, ...n], pixel) {
  pen.strokeStyle = colour;
  pen.lineWidth = 1.4 * pixel;
  if (kind === "line") trace(pen, [[n[0], n[1]], [n[2], n[3]]]);
  else if (kind === "circle") {
    pen.beginPath();
    pen.arc(n[0], n[1], Math.min(Math.abs(n[2]), 1e4), 0, 2 * Math.PI);
  } else return;
  pen.stroke();
}

// Words on a plate; in pixels, the middle given.
function drawWords(pen, text, u, v, ink, size) {
  pen.font = `500 ${size}px system-ui, sans-serif`;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  const width = pen.measureText(text).width + 8;
  pen.fillStyle = "#0e141ac0";
  pen.beginPath();
  pen.roundRect(u - width / 2, v - size * 0.7, width, size * 1.4, 3);
  pen.fill();
  pen.fillStyle = ink;
  pen.fillText(text, u, v + 0.5);
}

// Sides of a robot where its label may stand; the first free one is taken.
const SIDES = [[0, 1], [0, -1], [1, 0], [-1, 0], [1, 1], [-1, 1], [1, -1], [-1, -1], [0, 2], [0, -2]];

function overlap(a, b) {
  return Math.abs(a.u - b.u) * 2 < a.width + b.width && Math.abs(a.v - b.v) * 2 < a.height + b.height;
}

// A middle moved so that what is so long to either side lies between 0 and the end.
function within(middle, half, end) {
  return middle < -half || middle > end + half ? middle : Math.min(Math.max(middle, half), end - half);
}

// Labels beside their robots where they hide nothing, as far as possible.
function drawLabels(pen, view, labels, taken, size) {
  pen.font = `500 ${size}px system-ui, sans-serif`;
  for (const { text, u, v, radius, ink } of labels) {
    const [width, height] = [pen.measureText(text).width + 8, size * 1.4];
    const tries = SIDES.map(([across, down]) => ({
      u: within(u + across * (radius + 2 + width / 2), width / 2, view.width),
      v: within(v + down * (radius + 2 + height / 2), height / 2, view.height),
      width,
      height,
    }));
    const free = tries.find((each) => !taken.some((other) => overlap(each, other))) || tries[0];
    taken.push(free);
    drawWords(pen, text, free.u, free.v, ink, size);
  }
}
