"""What tests of the replay page in a browser share: a match to show, and how to look at it."""

import numpy as np
from tape import RECORD_HZ, STRIDE, event, tape

ATTACK = '</script><img src=x onerror="window.pwned=1"><script>window.pwned=1</script>'
SECONDS, EVENTS = 12.0, (3.0, 7.5)
PIXEL = """(([x, y]) => {
  const {picture} = soccersim.app, [u, v] = picture.view.pixel(x, y);
  const pen = new OffscreenCanvas(1, 1).getContext("2d", {willReadFrequently: true});
  pen.drawImage(picture.canvas, -Math.round(u * picture.ratio), -Math.round(v * picture.ratio));
  return [...pen.getImageData(0, 0, 1, 1).data];
})"""


def circling():
    """Ten robots on circles, a ball on a line, two events and words that attack the page."""
    time = np.arange(0, SECONDS, 1 / RECORD_HZ)
    robots = np.zeros((len(time), 10, 3))
    for i in range(10):
        angle = 0.5 * time + i
        robots[:, i, 0] = -8 + 1.8 * i + 0.8 * np.cos(angle)
        robots[:, i, 1] = 0.8 * np.sin(angle) - (3 if i % 2 else -3)
        robots[:, i, 2] = angle
    ball = np.stack((-9 + 1.5 * time, 0 * time), axis=1)
    believed = robots.copy()
    believed[:, 2, 0] += 0.5
    sighted = np.full((len(time[::STRIDE]), 10, 2), np.nan)
    sighted[:, 7, 0], sighted[:, 7, 1] = ball[::STRIDE, 0], 2.0
    return tape(
        *(robots, ball, believed),
        ball_sighted=sighted,
        events=[event(t, "goal", "home", f"at {t} s {ATTACK}") for t in EVENTS],
        labels=[[0, 0, ATTACK]],
        notes=[[0, 0, [["text", 0.0, 2.0, ATTACK], ["circle", 0.0, 0.0, 2.0]]]],
    )


def go(tab, time):
    """Show a time, and wait until it is drawn."""
    tab.run(f"soccersim.app.player.seek({time})")
    tab.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")


def on_screen(tab, x, y):
    """A place of the field as one of the window."""
    u, v = tab.run(f"""(b => {{
      const [u, v] = soccersim.app.picture.view.pixel({x}, {y});
      return [b.x + u, b.y + v];
    }})(field.getBoundingClientRect())""")
    return u, v
