// What moves, in metres, at its own place: the pen stands at its centre, turned to its heading.

function at(pen, pose, draw) {
  pen.save();
  pen.translate(pose.x, pose.y);
  pen.rotate(pose.heading);
  draw();
  pen.restore();
}

// A piece of cake between two angles, its tip cut off.
function sector(pen, radius, half, inner, middle = 0) {
  pen.beginPath();
  pen.arc(0, 0, radius, middle - half, middle + half);
  pen.arc(0, 0, inner, middle + half, middle - half, true);
  pen.closePath();
}

// pixel: how long a pixel is here, m.
function drawRobot(pen, look, model, team, robot, pixel) {
  const radius = model.radius;
  pen.save();
  if (!robot.inPlay) pen.globalAlpha = look.dim;
  disc(pen, robot.x + 0.06 * radius, robot.y - 0.09 * radius, radius, look.shadow);
  at(pen, robot, () => {
    const shell = radius - Math.min(Math.max(0.05 * radius, pixel), 0.3 * radius);
    disc(pen, 0, 0, radius, look.outline);
    disc(pen, 0, 0, shell, look.rims[team]);
    disc(pen, 0, 0, 0.9 * shell, look.teams[team]);
    sector(pen, shell, look.nose_angle, look.hub_share * radius);
    pen.fillStyle = look.nose;
    pen.fill();
    disc(pen, 0, 0, look.hub_share * radius, look.hub);
    if (radius > 7 * pixel) for (const wheel of model.wheels) drawWheel(pen, look, wheel);
  });
  pen.restore();
}

function drawWheel(pen, look, [x, y, direction, length, thickness, roller, dead]) {
  at(pen, { x, y, heading: direction }, () => {
    const [long, wide] = [length / 2, thickness / 2];
    pen.fillStyle = dead ? look.dead_tyre : look.tyre;
    pen.beginPath();
    pen.roundRect(-long, -wide, length, thickness, 0.35 * wide);
    pen.fill();
    pen.strokeStyle = dead ? look.dead_roller : look.roller;
    pen.lineWidth = 0.08 * length;
    pen.lineCap = "butt";
    const lean = 0.7 * wide * Math.sin(roller);
    pen.beginPath();
    for (const share of [-0.45, 0, 0.45]) {
      pen.moveTo(share * length + lean, -0.7 * wide);
      pen.lineTo(share * length - lean, 0.7 * wide);
    }
    pen.stroke();
  });
}

// Where a robot believes it is: an outline with the nose of a robot, tied to where it is.
function drawGhost(pen, look, model, robot, pixel) {
  const { believed } = robot;
  pen.strokeStyle = look.believed;
  pen.lineWidth = 1.2 * pixel;
  trace(pen, [[robot.x, robot.y], [believed.x, believed.y]]);
  pen.stroke();
  at(pen, believed, () => {
    disc(pen, 0, 0, model.radius, look.believed + "20");
    sector(pen, model.radius, look.nose_angle, look.ghost_nose * model.radius);
    pen.fillStyle = look.believed + "a0";
    pen.fill();
    pen.lineWidth = Math.min(Math.max(0.06 * model.radius, 1.6 * pixel), model.radius);
    pen.beginPath();
    pen.arc(0, 0, model.radius - pen.lineWidth / 2, 0, 2 * Math.PI);
    pen.stroke();
  });
}

const GLOW = 9; // px, radius: on a large field the eye must find the ball
const PATCHES = [0, 1, 2, 3, 4].map((i) => 0.4 * i * Math.PI);
const BALL_LEAST = 3.5; // px, radius as drawn

function drawBall(pen, look, size, ball, pixel) {
  const radius = Math.max(size, BALL_LEAST * pixel);
  disc(pen, ball.x, ball.y, Math.max(GLOW * pixel, 1.3 * radius), look.glow);
  disc(pen, ball.x + 0.2 * radius, ball.y - 0.28 * radius, 1.04 * radius, look.shadow);
  at(pen, ball, () => {
    disc(pen, 0, 0, radius, look.ball_rim);
    const white = radius - Math.min(0.09 * radius, 0.6 * pixel);
    disc(pen, 0, 0, white, look.ball);
    trace(pen, PATCHES.map((a) => [0.34 * radius * Math.cos(a), 0.34 * radius * Math.sin(a)]), true);
    pen.fillStyle = look.ball_patch;
    pen.fill();
    for (const angle of PATCHES) {
      sector(pen, white, 0.22, 0.78 * radius, angle);
      pen.fill();
    }
  });
}

function drawArm(pen, look, arm, links, pixel) {
  const width = Math.max(arm.thickness, 3 * pixel);
  const ends = links.map((link, i) => {
    const [dx, dy] = [Math.cos(link.heading), Math.sin(link.heading)].map((c) => (c * arm.lengths[i]) / 2);
    return [[link.x - dx, link.y - dy], [link.x + dx, link.y + dy]];
  });
  pen.lineCap = "round";
  for (const end of ends) {
    for (const [colour, wide] of [[look.link_edge, width + 2 * pixel], [look.link, width]]) {
      pen.strokeStyle = colour;
      pen.lineWidth = wide;
      trace(pen, end);
      pen.stroke();
    }
  }
  for (const [[x, y]] of ends) {
    disc(pen, x, y, 0.75 * width + pixel, look.link_edge);
    disc(pen, x, y, 0.75 * width, look.joint);
  }
  disc(pen, ...ends[ends.length - 1][1], 0.5 * width, look.believed);
}
