// How the field lies on the canvas: metres to CSS pixels. On tall screens it stands upright.

const MARGIN = 6; // px round the boards
const CLOSEST = 12; // times as large as the whole field

class View {
  constructor(field) {
    this.floor = field.floor.map((side) => side + 2 * field.board);
    this.whole();
    this.resize(1, 1);
  }

  // The whole field in the middle.
  whole() {
    this.zoom = 1;
    this.x = 0;
    this.y = 0;
  }

  resize(width, height) {
    this.width = width;
    this.height = height;
    this.upright = height > width;
    const [long, short] = this.upright ? [height, width] : [width, height];
    this.fit = Math.max(1, Math.min((long - 2 * MARGIN) / this.floor[0], (short - 2 * MARGIN) / this.floor[1]));
  }

  get scale() {
    return this.fit * this.zoom;
  }

  // [a, b, c, d, e, f] as canvases take them.
  get matrix() {
    const s = this.scale;
    const [a, b, c, d] = this.upright ? [0, -s, -s, 0] : [s, 0, 0, -s];
    return [a, b, c, d, this.width / 2 - a * this.x - c * this.y, this.height / 2 - b * this.x - d * this.y];
  }

  pixel(x, y) {
    const [a, b, c, d, e, f] = this.matrix;
    return [a * x + c * y + e, b * x + d * y + f];
  }

  place(u, v) {
    const s = this.scale;
    const [right, down] = [(u - this.width / 2) / s, (v - this.height / 2) / s];
    return this.upright ? [this.x - down, this.y - right] : [this.x + right, this.y - down];
  }

  // Zoom so that the place under a pixel stays there.
  zoomAt(u, v, factor) {
    const [x, y] = this.place(u, v);
    this.zoom = Math.min(Math.max(this.zoom * factor, 1), CLOSEST);
    const [nx, ny] = this.place(u, v);
    this.centre(this.x + x - nx, this.y + y - ny);
  }

  pan(du, dv) {
    const [x, y] = this.place(this.width / 2 - du, this.height / 2 - dv);
    this.centre(x, y);
  }

  // Look at a place, but no farther out than the boards.
  centre(x, y) {
    const [across, along] = this.upright ? [this.height, this.width] : [this.width, this.height];
    const roomX = Math.max(0, this.floor[0] / 2 - across / this.scale / 2 + MARGIN / this.scale);
    const roomY = Math.max(0, this.floor[1] / 2 - along / this.scale / 2 + MARGIN / this.scale);
    this.x = Math.min(Math.max(x, -roomX), roomX);
    this.y = Math.min(Math.max(y, -roomY), roomY);
  }
}
