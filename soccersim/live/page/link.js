// The line to the base station: comes back by itself, knows how fast it is.

const PINGS = 1000; // ms
const RETRIES = [250, 500, 1000, 2000]; // ms
const MEASURED = 2000; // ms over which pictures are counted

class Link {
  // heard: {hello, words, gains, news, picture, state}
  constructor(heard) {
    this.heard = heard;
    this.waiting = new Map();
    this.number = 0;
    this.tries = 0;
    this.arrivals = [];
    this.delay = NaN;
    this.open();
    setInterval(() => this.ping(), PINGS);
  }

  open() {
    const scheme = location.protocol === "https:" ? "wss:" : "ws:";
    const socket = new WebSocket(`${scheme}//${location.host}/live${location.search}`);
    socket.binaryType = "arraybuffer";
    socket.addEventListener("open", () => {
      this.tries = 0;
      this.heard.state(true);
      this.ping();
    });
    socket.addEventListener("message", (event) => this.hear(event.data));
    socket.addEventListener("close", () => {
      this.heard.state(false);
      for (const { answered } of this.waiting.values()) answered({ type: "wrong", what: "the connection was lost" });
      this.waiting.clear();
      setTimeout(() => this.open(), RETRIES[Math.min(this.tries++, RETRIES.length - 1)]);
    });
    this.socket = socket;
  }

  get up() {
    return this.socket.readyState === WebSocket.OPEN;
  }

  hear(data) {
    if (typeof data !== "string") {
      const now = performance.now();
      this.arrivals.push(now);
      while (now - this.arrivals[0] > MEASURED) this.arrivals.shift();
      this.heard.picture(new Float64Array(data));
      return;
    }
    const told = JSON.parse(data);
    const asked = this.waiting.get(told.id);
    if (told.type === "pong" || told.type === "done" || told.type === "wrong") {
      this.waiting.delete(told.id);
      const took = asked ? performance.now() - asked.at : NaN;
      if (told.type === "pong") this.delay = took;
      else if (asked) asked.answered(told, took);
    } else this.heard[told.type](told);
  }

  // Says something; answered(answer, ms) comes later.
  say(message, answered = () => {}) {
    if (!this.up) return;
    const id = ++this.number;
    this.waiting.set(id, { at: performance.now(), answered });
    this.socket.send(JSON.stringify({ ...message, id }));
  }

  ping() {
    if (!this.up) return;
    const id = ++this.number;
    this.waiting.set(id, { at: performance.now(), answered: () => {} });
    this.socket.send(JSON.stringify({ do: "ping", id }));
  }

  // Pictures a second.
  get rate() {
    const { arrivals } = this;
    const now = performance.now();
    const recent = arrivals.filter((at) => now - at < MEASURED);
    return recent.length < 2 ? 0 : (1000 * (recent.length - 1)) / (recent[recent.length - 1] - recent[0]);
  }
}
