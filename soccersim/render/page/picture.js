// Draws a moment of play onto a canvas. It knows nothing of where moments come from: a recording
// (recording.js) makes them, and anything else may that gives objects of the same shape.
//
// stage: field, look, models, robots (name, number, team, model), ball (radius or null), arms
// moment: robots [{x, y, heading, inPlay, contact, label, believed, command, reference, target}],
//   ball {x, y, heading}, links, trails, believedTrails, ballTrail (points), routes, kicks, seen
//   [{x, y, age}], notes (by team), sightings [{x, y, robot, share: 1 when new}], direction (home plays to x of this sign)
// show: what the viewer wants: believed, trails, commands, seen, sightings, words, plan: true or false

const APART = 3; // px between truth and belief from which a ghost is drawn; more when near
const TURNED = (5 * Math.PI) / 180;
const LABEL = 11; // px, letters
const TINY = 5; // px, radius; a smaller robot goes without its number, which would hide it

class Picture {
  constructor(canvas, stage) {
    this.canvas = canvas;
    this.pen = canvas.getContext("2d");
    this.stage = stage;
    this.view = new View(stage.field);
    this.inks = stage.look.tints;
  }

  // As large as the page has made it, in the pixels of the screen.
  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    this.ratio = window.devicePixelRatio || 1;
    const [width, height] = [clientWidth, clientHeight].map((side) => Math.max(1, Math.round(side * this.ratio)));
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    this.view.resize(clientWidth, clientHeight);
  }

  metres() {
    this.pen.setTransform(...this.view.matrix.map((part) => part * this.ratio));
  }

  pixels() {
    this.pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
  }

  model(index) {
    return this.stage.models[this.stage.robots[index].model];
  }

  draw(moment, show, selected = -1) {
    const { pen, stage, view } = this;
    const { look } = stage;
    this.pixel = 1 / view.scale;
    this.pixels();
    pen.clearRect(0, 0, view.width, view.height);
    this.metres();
    drawPitch(pen, stage.field, look, -moment.direction);
    if (show.plan) this.drawPlans(moment);
    if (show.trails) this.drawTrails(moment, show);
    if (show.words) this.drawNotes(moment);
    this.drawHalos(moment, selected);
    if (show.kicks !== false) for (const kick of moment.kicks) drawKick(pen, look, kick, this.pixel);
    moment.robots.forEach((robot, i) => drawRobot(pen, look, this.model(i), stage.robots[i].team, robot, this.pixel));
    if (show.commands) this.drawCommands(moment);
    if (show.believed) this.drawGhosts(moment, selected);
    this.pixels();
    moment.robots.forEach((robot, i) => this.drawNumber(robot, i));
    this.metres();
    moment.links.forEach((links, i) => drawArm(pen, look, stage.arms[i], links, this.pixel));
    if (show.seen) {
      moment.seen.forEach((seen, team) => {
        drawSeen(pen, look, team, seen, stage.ball || 0, this.pixel);
      });
    }
    if (show.sightings) this.drawSightings(moment, selected);
    if (moment.ball) drawBall(pen, look, stage.ball, moment.ball, this.pixel);
    this.pixels();
    if (show.words) this.drawWords(moment);
  }

  drawPlans(moment) {
    const { pen, pixel } = this;
    const { look } = this.stage;
    for (const route of moment.routes) if (route.length) drawRoute(pen, look, route, pixel);
    for (const robot of moment.robots) {
      if (robot.target) drawTarget(pen, look, robot.target, pixel);
      if (robot.reference) drawReference(pen, look, robot.reference, pixel);
    }
  }

  drawTrails(moment, show) {
    const { pen, pixel, stage } = this;
    moment.trails.forEach((points, i) => {
      drawTrail(pen, points, this.inks[stage.robots[i].team], 2.2 * pixel);
    });
    if (show.believed) {
      for (const points of moment.believedTrails) {
        drawTrail(pen, points, stage.look.believed, 1.4 * pixel, [5 * pixel, 5 * pixel]);
      }
    }
    drawTrail(pen, moment.ballTrail, stage.look.ball_trail, 2.2 * pixel);
  }

  drawNotes(moment) {
    moment.notes.forEach((notes, team) => {
      for (const note of notes) drawNote(this.pen, this.inks[team], note, this.pixel);
    });
  }

  // Round the robots that have the ball, and round the one that is looked at.
  drawHalos(moment, selected) {
    const { pen, pixel, stage } = this;
    moment.robots.forEach((robot, i) => {
      const { radius } = this.model(i);
      if (robot.contact) disc(pen, robot.x, robot.y, radius + 3 * pixel, stage.look.ball + "82");
      if (i === selected) {
        pen.strokeStyle = stage.look.ink;
        pen.lineWidth = 2 * pixel;
        pen.beginPath();
        pen.arc(robot.x, robot.y, radius + 6 * pixel, 0, 2 * Math.PI);
        pen.stroke();
      }
    });
  }

  drawNumber(robot, index) {
    const { pen, view, stage } = this;
    const radius = this.model(index).radius * view.scale;
    if (radius < TINY) return;
    const text = String(stage.robots[index].number);
    const [u, v] = view.pixel(robot.x, robot.y);
    const size = Math.max(7, 1.5 * stage.look.hub_share * radius * (text.length < 2 ? 1 : 0.8));
    pen.font = `700 ${size}px system-ui, sans-serif`;
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.fillStyle = robot.inPlay ? stage.look.ink : stage.look.faint;
    pen.fillText(text, u, v + 0.06 * size);
  }

  drawCommands(moment) {
    moment.robots.forEach((robot, i) => {
      if (!robot.command || !robot.inPlay) return;
      drawCommand(this.pen, this.inks[this.stage.robots[i].team], this.model(i).radius, robot, this.pixel);
    });
  }

  // Crosses, and a line to the newest of the robot that is looked at.
  drawSightings(moment, selected) {
    const { pen, pixel, stage } = this;
    this.inks.forEach((ink, team) => {
      const own = moment.sightings.filter(({ robot }) => stage.robots[robot].team === team);
      drawSightings(pen, ink, own, pixel);
    });
    const own = moment.sightings.filter((sighting) => sighting.robot === selected).pop();
    if (own) drawSightLine(pen, stage.look.ink, moment.robots[selected].believed, own, pixel);
  }

  // Beliefs that one can see to be wrong, and always that of the robot that is looked at.
  drawGhosts(moment, selected) {
    moment.robots.forEach((robot, i) => {
      const { believed } = robot;
      const apart = Math.hypot(robot.x - believed.x, robot.y - believed.y) * this.view.scale;
      const turned = Math.abs(((robot.heading - believed.heading + 3 * Math.PI) % (2 * Math.PI)) - Math.PI);
      if (robot.inPlay && (apart > APART * Math.min(this.view.zoom, 3) || turned > TURNED || i === selected)) {
        drawGhost(this.pen, this.stage.look, this.model(i), robot, this.pixel);
      }
    });
  }

  // Words of notes, then labels where they hide neither words nor robots.
  drawWords(moment) {
    const { pen, view, stage } = this;
    const taken = [];
    moment.notes.forEach((notes, team) => {
      for (const [kind, x, y, text] of notes) {
        if (kind !== "text" || !text.trim()) continue;
        const [u, v] = view.pixel(x, y);
        drawWords(pen, text, u, v - 18, this.inks[team], LABEL + 1);
        taken.push({ u, v: v - 18, width: pen.measureText(text).width + 8, height: 1.4 * LABEL });
      }
    });
    const places = moment.robots.map((robot, i) => {
      const [u, v] = view.pixel(robot.x, robot.y);
      const radius = this.model(i).radius * view.scale;
      taken.push({ u, v, width: 1.6 * radius, height: 1.6 * radius });
      return { u, v, radius, text: robot.label.trim(), ink: this.inks[stage.robots[i].team] };
    });
    drawLabels(pen, view, places.filter((place) => place.text), taken, LABEL);
  }

  // The robot under a pixel, or near it; -1: none.
  robotAt(moment, u, v, reach = 14) {
    let [found, nearest] = [-1, Infinity];
    moment.robots.forEach((robot, i) => {
      const [x, y] = this.view.pixel(robot.x, robot.y);
      const away = Math.hypot(u - x, v - y);
      if (away < Math.max(reach, this.model(i).radius * this.view.scale) && away < nearest) {
        [found, nearest] = [i, away];
      }
    });
    return found;
  }
}
