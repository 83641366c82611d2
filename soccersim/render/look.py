"""Colours and sizes of the pictures: everything that is a matter of taste, in one place."""

Colour = tuple[int, int, int]

SIZE = (1280, 854)  # px; both even, as H.264 wants them
BAND = 76  # px of head-up display above and below the field, in a picture of SIZE

PAGE = (21, 26, 33)  # round the field and under the head-up display
CARD = (33, 40, 50)
INK = (236, 240, 245)
FAINT = (146, 158, 173)

GRASS = ((64, 131, 86), (58, 122, 79))  # mown this way and that
VERGE = (49, 104, 68)  # the floor between the lines and the board
FLOOR = (61, 126, 82)  # what trails fade into
LINE = (234, 241, 234)
BOARD = (52, 62, 75)
BOARD_EDGE = (88, 102, 120)
POST = (247, 249, 247)

# blue and orange keep apart for every kind of colour blindness, and both from the green
TEAMS: dict[str, Colour] = {"home": (38, 120, 214), "away": (243, 134, 31)}
OUTLINE = (18, 23, 30)
HUB = (28, 34, 43)
NOSE = (246, 248, 250)
TYRE = (14, 17, 22)
ROLLER = (122, 133, 147)
DEAD_TYRE = (72, 80, 91)
DEAD_ROLLER = (168, 176, 186)
SHADOW = (8, 24, 14, 80)

BALL = (255, 255, 255)  # the only pure white in a picture
GLOW = (255, 255, 255, 60)
BALL_TRAIL = (226, 232, 236)
BALL_RIM = (120, 128, 136)
BALL_PATCH = (34, 38, 44)

BELIEVED = (255, 222, 89)
TARGET = (255, 122, 190)


def mix(first: Colour, second: Colour, share: float) -> Colour:
    """The first colour with this share of the second in it."""
    r, g, b = (round(a + (z - a) * share) for a, z in zip(first, second, strict=True))
    return r, g, b


def tint(team: str) -> Colour:
    """A team's colour, light enough for lines and letters on the grass."""
    return mix(TEAMS[team], INK, 0.4)


def scale(size: tuple[int, int]) -> float:
    """How large a picture of this size is beside one of SIZE."""
    return min(size[0] / SIZE[0], size[1] / SIZE[1])
