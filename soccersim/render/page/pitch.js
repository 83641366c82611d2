// The empty field, in metres: floor, mown grass, lines, goals.

function trace(pen, points, closed = false) {
  pen.beginPath();
  points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
  if (closed) pen.closePath();
}

function disc(pen, x, y, radius, colour) {
  pen.fillStyle = colour;
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fill();
}

function box(pen, length, width, colour) {
  pen.fillStyle = colour;
  pen.fillRect(-length / 2, -width / 2, length, width);
}

// home: the sign of x at which home has its goal.
function drawPitch(pen, field, look, home) {
  const [length, width] = field.floor;
  box(pen, length + 2 * field.board, width + 2 * field.board, look.board);
  box(pen, length + field.board / 2, width + field.board / 2, look.board_edge);
  box(pen, length, width, look.verge);
  const stripe = field.length / field.stripes;
  box(pen, field.length, field.width, look.grass[0]); // one ground: no seams between the stripes
  pen.fillStyle = look.grass[1];
  for (let i = 1; i < field.stripes; i += 2) {
    pen.fillRect(-field.length / 2 + i * stripe, -field.width / 2, stripe, field.width);
  }
  field.goals.forEach((goal, side) => drawNet(pen, goal, field, look.nets[(side ? -home : home) > 0 ? 0 : 1]));
  pen.strokeStyle = look.line;
  pen.lineWidth = field.line_width;
  pen.lineJoin = "miter";
  pen.lineCap = "butt";
  for (const line of field.lines) {
    const [first, last] = [line[0], line[line.length - 1]];
    trace(pen, line, first[0] === last[0] && first[1] === last[1]);
    pen.stroke();
  }
  for (const [x, y] of field.spots) disc(pen, x, y, field.line_width, look.line);
  field.goals.forEach((goal, side) => {
    drawFrame(pen, goal, field, look, look.teams[(side ? -home : home) > 0 ? 0 : 1]);
  });
}

function drawNet(pen, goal, field, [floor, cord]) {
  trace(pen, goal, true);
  pen.fillStyle = floor;
  pen.fill();
  const [[x, y], [back]] = goal;
  const across = Math.round((2 * Math.abs(y)) / field.mesh);
  const along = Math.round(Math.abs(back - x) / field.mesh);
  pen.strokeStyle = cord;
  pen.lineWidth = 0.012;
  pen.beginPath();
  for (let i = 1; i < across; i++) {
    const side = y - (2 * y * i) / across;
    pen.moveTo(x, side);
    pen.lineTo(back, side);
  }
  for (let i = 1; i < along; i++) {
    const deep = x + ((back - x) * i) / along;
    pen.moveTo(deep, -y);
    pen.lineTo(deep, y);
  }
  pen.stroke();
}

function drawFrame(pen, goal, field, look, colour) {
  trace(pen, goal);
  pen.strokeStyle = colour;
  pen.lineWidth = field.post_radius;
  pen.stroke();
  for (const [x, y] of [goal[0], goal[3]]) {
    disc(pen, x, y, 1.25 * field.post_radius, look.outline);
    disc(pen, x, y, field.post_radius, look.post);
  }
}
