// Fingers and mouse on the field: pick a robot, send it, put the ball, push, zoom.

const CLICK = 6; // px: a press that moves farther is a drag
const AIM = 14; // px from which on a drag tells a heading

class FieldControl {
  constructor(app) {
    this.app = app;
    this.pointers = new Map();
    this.press = null;
    const { canvas } = app.picture;
    const place = (event) => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button > 0) return;
      canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, place(event));
      this.press = this.pointers.size === 1 ? this.begin(...place(event)) : null;
    });
    canvas.addEventListener("pointermove", (event) => {
      if (this.pointers.has(event.pointerId)) this.drag(event.pointerId, place(event));
    });
    canvas.addEventListener("pointerup", (event) => {
      this.pointers.delete(event.pointerId);
      if (this.press) this.finish();
      this.press = null;
    });
    canvas.addEventListener("pointercancel", (event) => {
      this.pointers.delete(event.pointerId);
      this.press = null;
    });
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      app.picture.view.zoomAt(...place(event), Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.002)));
    }, { passive: false });
  }

  begin(u, v) {
    const { app } = this;
    const robot = app.moment ? app.picture.robotAt(app.moment, u, v, 10) : -1;
    return { from: [u, v], to: [u, v], robot };
  }

  drag(id, now) {
    const before = this.pointers.get(id);
    const other = [...this.pointers.entries()].find(([each]) => each !== id);
    this.pointers.set(id, now);
    const { view } = this.app.picture;
    if (other) {
      const away = (point) => Math.max(1, Math.hypot(point[0] - other[1][0], point[1] - other[1][1]));
      view.zoomAt((now[0] + other[1][0]) / 2, (now[1] + other[1][1]) / 2, away(now) / away(before));
    } else if (this.press) this.press.to = now;
  }

  // How far the press has been drawn: pixels, and from where to where on the field.
  drawn() {
    const { from, to } = this.press;
    const { view } = this.app.picture;
    const [start, end] = [view.place(...from), view.place(...to)];
    return { pixels: Math.hypot(to[0] - from[0], to[1] - from[1]), start, end, dx: end[0] - start[0], dy: end[1] - start[1] };
  }

  finish() {
    const { app, press } = this;
    const { pixels, start, dx, dy } = this.drawn();
    const robot = press.robot;
    if (robot >= 0 && pixels <= CLICK && app.tool !== "ball") app.pick(robot);
    else if (app.tool === "ball") app.actions.ball(...start, ...(pixels > CLICK ? [dx, dy] : [0, 0]));
    else if (app.tool === "push") {
      if (pixels > CLICK) app.actions.push(robot >= 0 ? robot : app.selected, dx, dy);
    } else app.actions.go(app.selected, ...start, pixels > AIM ? Math.atan2(dy, dx) : null);
  }

  // What letting go would do, and in numbers.
  draw(picture, look) {
    if (!this.press) return;
    const { pen, pixel, view } = picture;
    const { app, press } = this;
    const { pixels, start, end, dx, dy } = this.drawn();
    if (press.robot >= 0 && pixels <= CLICK && app.tool !== "ball") return;
    pen.strokeStyle = pen.fillStyle = app.tool === "send" ? look.target : app.tool === "ball" ? look.ball : "#ff8f7a";
    const aims = pixels > (app.tool === "send" ? AIM : CLICK);
    if (app.tool === "send") {
      const robot = app.moment.robots[app.selected];
      if (!robot) return;
      drawTarget(pen, look, { x: start[0], y: start[1], heading: aims ? Math.atan2(dy, dx) : robot.believed.heading }, pixel);
    } else if (app.tool === "ball") disc(pen, ...start, Math.max(app.moments.told.ball || 0.11, 5 * pixel), look.ball);
    if (!aims) return;
    pen.lineWidth = 2 * pixel;
    trace(pen, [start, end]);
    pen.stroke();
    arrowHead(pen, ...end, Math.atan2(dy, dx), 7 * pixel);
    const [u, v] = view.pixel(...end);
    picture.pixels();
    drawWords(pen, this.tells(dx, dy), u, v - 18, look.ink, 12);
  }

  tells(dx, dy) {
    const length = Math.hypot(dx, dy);
    const { tool } = this.app;
    if (tool === "send") return `heading ${number(Math.atan2(dy, dx) * DEGREES, 0)}°`;
    return tool === "ball" ? `${number(ROLL * length, 1)} m/s` : `${number(POWER * length, 0)} N`;
  }
}
