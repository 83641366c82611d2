"""What one team is told at one decision: a flat row of numbers, cheap to send to another process.

The header, then the team's own robots in the scenario's order, then the opponents it knows of.
Team frame: own goal at -x, y left; metres, radians, seconds; twists in the robot's body frame.
"""

PHASES = (  # a phase is told by its place here
    "stop",
    "kick_off",
    "throw_in",
    "goal_kick",
    "corner",
    "free_kick",
    "penalty",
    "dropped_ball",
    "play",
    "over",
)

# the header: where each number stands
TIME = 0  # s since the match began
PHASE = 1
WHOSE = 2  # 1: the restart is ours, 0: theirs, -1: nobody's
STARTED = 3  # 1: START has been given, the ball may be played
GOALS = 4  # ours, then theirs
LEFT = 6  # s to the end of the match
HALF = 7  # 1 or 2
BALL_KNOWN = 8
BALL = 9  # x, y, vx, vy, age of the sighting
OPPONENTS_KNOWN = 14
HEADER = 15

ROBOT = 11  # in play, number, keeper, x, y, heading, vx, vy, omega, has the ball, age of the report
OPPONENT = 5  # x, y, vx, vy, age of the sighting


def sheet_size(robots: int, opponents: int) -> int:
    """How many numbers a sheet has for a team of so many robots against so many."""
    return HEADER + ROBOT * robots + OPPONENT * opponents
