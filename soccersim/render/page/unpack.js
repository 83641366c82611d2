// Reads what pack.py has written: a JSON document, and channels of numbers over time.

async function inflated(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
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
async function unpacked(base64) {
  const bytes = await inflated(base64);
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
