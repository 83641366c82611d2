"""What people do to a play, without any browser."""

from soccersim.live.messages import read


def seconds(play, time, piece=10):
    for _ in range(round(time * play.hz / piece)):
        play.advance(piece)


def say(play, text):
    play.obey(read(text))


def body(play, row):
    return play.simulation.machine.truth.body[row]
