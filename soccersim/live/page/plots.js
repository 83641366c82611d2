// Small plots of one robot's last seconds.

const SPAN = 12; // s
const LINES = ["#4c9be8", "#f2a33c", "#5cc689", "#d96fb4", "#b0a1ff", "#e5e06a", "#6fd3d6", "#ee7d6b"];

// What each plot shows of a robot: [name, unit, floor of its range, lines: [name, dashed, value]]
function plotsOf(moments, robot) {
  const of = (name) => (frame) => moments.of(frame, robot, name);
  const wheel = (k, name, unit = 1) => (frame) => unit * moments.wheel(frame, robot, k, name);
  const player = moments.told.robots[robot];
  const driven = Array.from({ length: player.driven }, (_, k) => k);
  const off = (x, y) => (frame) => 100 * Math.hypot(of(x)(frame) - of("tx")(frame), of(y)(frame) - of("ty")(frame));
  const speed = (x, y) => (frame) => Math.hypot(of(x)(frame), of(y)(frame));
  return [
    ["to its target", "cm", 2, [["true", false, off("x", "y")], ["believes", true, off("bx", "by")]]],
    ["speed", "m/s", 0.1, [["true", false, speed("vx", "vy")], ["told", true, speed("cx", "cy")]]],
    ["turning", "°/s", 10, [
      ["gyro", false, (frame) => DEGREES * of("gyro")(frame)],
      ["told", true, (frame) => DEGREES * of("cturn")(frame)],
    ]],
    ["wheels", "rpm", 20, driven.flatMap((k) => [
      [String(k + 1), false, wheel(k, "true", RPM)],
      ["", true, wheel(k, "wanted", RPM)],
    ])],
    ["PWM", "", 20, driven.map((k) => [String(k + 1), false, wheel(k, "pwm")])],
    ["slip", "cm/s", 2, driven.map((k) => [String(k + 1), false, wheel(k, "slip", 100)])],
  ];
}

class Plots {
  constructor(element) {
    this.element = element;
    this.plots = [];
  }

  // Makes the canvases for a robot.
  show(moments, robot) {
    this.moments = moments;
    this.element.replaceChildren();
    this.plots = robot < 0 ? [] : plotsOf(moments, robot).map(([name, unit, least, lines]) => {
      const figure = make("figure");
      const caption = make("figcaption");
      const range = make("small");
      const key = make("span", "", { class: "key" });
      const colours = lines.map(([label, dashed], i) => LINES[(lines.some((line) => line[0] === "" ) ? i >> 1 : dashed ? i : i) % LINES.length]);
      lines.forEach(([label], i) => {
        if (!label) return;
        const mark = make("i", label);
        mark.style.color = colours[i];
        key.append(mark);
      });
      caption.append(make("b", unit ? `${name}, ${unit}` : name), key, range);
      const canvas = make("canvas");
      figure.append(caption, canvas);
      this.element.append(figure);
      return { canvas, lines, range, least, colours };
    });
  }

  draw() {
    const { moments } = this;
    if (!moments || !moments.now) return;
    const end = moments.time(moments.now);
    const frames = moments.frames.filter((frame) => moments.time(frame) >= end - SPAN);
    const faint = getComputedStyle(document.documentElement).getPropertyValue("--edge").trim();
    for (const plot of this.plots) this.drawOne(plot, frames, end, faint);
  }

  drawOne({ canvas, lines, range, least, colours }, frames, end, faint) {
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (!width) return;
    if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
    if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
    const rows = lines.map(([, , value]) => frames.map(value));
    let [low, high] = [0, least];
    for (const row of rows) for (const value of row) if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
    if (low < 0) low = Math.min(low, -least);
    const pen = canvas.getContext("2d");
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    const x = (time) => width * (1 - (end - time) / SPAN);
    const y = (value) => height - 2 - ((height - 4) * (value - low)) / (high - low);
    pen.strokeStyle = faint;
    pen.lineWidth = 1;
    pen.beginPath();
    for (let second = Math.ceil(end - SPAN); second <= end; second += 2) {
      pen.moveTo(x(second), 0);
      pen.lineTo(x(second), height);
    }
    pen.moveTo(0, y(0));
    pen.lineTo(width, y(0));
    pen.stroke();
    rows.forEach((row, i) => this.drawLine(pen, frames, row, colours[i], lines[i][1], x, y));
    setText(range, `${number(low, tidy(high - low))} … ${number(high, tidy(high - low))}`);
  }

  drawLine(pen, frames, row, colour, dashed, x, y) {
    pen.strokeStyle = colour;
    pen.lineWidth = dashed ? 1.2 : 1.6;
    pen.setLineDash(dashed ? [3, 3] : []);
    pen.beginPath();
    let broken = true;
    row.forEach((value, k) => {
      if (!Number.isFinite(value)) broken = true;
      else {
        const at = [x(this.moments.time(frames[k])), y(value)];
        if (broken) pen.moveTo(...at);
        else pen.lineTo(...at);
        broken = false;
      }
    });
    pen.stroke();
    pen.setLineDash([]);
  }
}

function tidy(range) {
  return range < 2 ? 2 : range < 20 ? 1 : 0;
}
