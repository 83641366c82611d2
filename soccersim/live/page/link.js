// The line to the base station: comes back by itself, knows how fast it is.

const PINGS = 1000; // ms
const RETRIES = [250, 500, 1000, 2000]; // ms
const MEASURED = 2000; // ms over which pictures are counted

class Link {
  // heard: {hello, words, gains, news, picture}
  constructor(heard) {
    this.heard = heard;
    this.waiting = new Map();
    this.number = 0;
    this.tries = 0;
    this.since = performance.now(); // when it was opened or lost
    this.refusal = ""; // why the station does not let us in
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
      this.since = performance.now();
      this.refusal = "";
      this.ping();
    });
    socket.addEventListener("message", (event) => this.hear(event.data));
    socket.addEventListener("close", () => {
      if (this.tries === 0) this.since = performance.now();
      else this.why();
      for (const { answered } of this.waiting.values()) answered({ type: "wrong", what: "the connection was lost" });
      this.waiting.clear();
      setTimeout(() => this.open(), RETRIES[Math.min(this.tries++, RETRIES.length - 1)]);
    });
    this.socket = socket;
  }

  get up() {
    return this.socket.readyState === WebSocket.OPEN;
  }

  // A WebSocket does not tell why it is refused; the same address does.
  async why() {
    try {
      const answer = await fetch(`/live${location.search}`);
      if ([403, 503].includes(answer.status)) this.refusal = (await answer.text()).replace("soccersim live: ", "");
    } catch {
      this.refusal = ""; // nobody is there
    }
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

  // Milliseconds since something came, or since the line was opened or lost.
  get silence() {
    const last = this.arrivals[this.arrivals.length - 1] || 0;
    return performance.now() - (this.up ? Math.max(last, this.since) : this.since);
  }

  // Pictures a second.
  get rate() {
    const { arrivals } = this;
    const now = performance.now();
    const recent = arrivals.filter((at) => now - at < MEASURED);
    return recent.length < 2 ? 0 : (1000 * (recent.length - 1)) / (recent[recent.length - 1] - recent[0]);
  }
}
