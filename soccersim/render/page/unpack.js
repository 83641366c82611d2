// Reads what pack.py has written: a JSON document, and channels of numbers over time.

const FIRST = 35; // "#": the first of 91 letters
const LEFT_OUT = 60; // "<" is none of them

// The bytes of a text: 13 bits of each two letters. Whatever is no letter, like a new line, is left out.
function bytesOf(text) {
  const bytes = new Uint8Array(Math.ceil((text.length * 13) / 16));
  let [at, held, count, first] = [0, 0, 0, -1];
  for (let i = 0; i < text.length; i++) {
    const code = text.charCodeAt(i);
    if (code < FIRST) continue;
    const digit = code - FIRST - (code > LEFT_OUT ? 1 : 0);
    if (first < 0) first = digit;
    else {
      held = ((held & 127) << 13) | (91 * first + digit); // seven bits at most are left
      first = -1;
      count += 13;
      while (count >= 8) {
        count -= 8;
        bytes[at++] = held >> count;
      }
    }
  }
  return bytes.subarray(4, 4 + new DataView(bytes.buffer).getUint32(0, true));
}

async function inflated(text) {
  const stream = new Blob([bytesOf(text)]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// One channel from `at` on: a column after another, each a Float64Array; where the next one begins.
function readChannel(bytes, words, at, rows, told, below) {
  const columns = [];
  for (let column = 0; column < told.columns; column++) {
    const numbers = new Float64Array(rows);
    let value = 0;
    let change = 0;
    for (let row = 0; row < rows; row++) {
      let zigzag = bytes[at++];
      if (zigzag === 255) {
        zigzag = words.getUint32(at, true);
        at += 4;
      }
      const number = zigzag % 2 ? -(zigzag + 1) / 2 : zigzag / 2;
      if (told.order === 2) value += change += number;
      else if (told.order === 1) value += number;
      else value = number;
      numbers[row] = value * told.step + (below ? below[column][row] : 0);
    }
    columns.push(numbers);
  }
  return { columns, at };
}

// The document, and the channels by name.
async function unpacked(text) {
  const bytes = await inflated(text);
  const words = new DataView(bytes.buffer);
  const size = words.getUint32(0, true);
  const told = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + size)));
  const channels = {};
  let at = 4 + size;
  for (const channel of told.channels) {
    const read = readChannel(bytes, words, at, told.rows, channel, channels[channel.on]);
    channels[channel.key] = read.columns;
    at = read.at;
  }
  for (const key of Object.keys(channels)) {
    const known = channels[key + "?"];
    if (known) {
      channels[key].forEach((column, i) => column.forEach((_, row) => {
        if (!known[i][row]) column[row] = NaN;
      }));
    }
  }
  return { told, channels };
}
