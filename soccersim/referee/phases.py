"""What a match may be in, and what leads from one to the next: one table.

A stoppage is STOP, then the signal of the restart, then START, then the ball is in play. START is
no phase of its own: `started` is told beside the phase.
"""

from enum import StrEnum


class Phase(StrEnum):
    """Named and ordered as teams are told them."""

    STOP = "stop"
    KICK_OFF = "kick_off"
    THROW_IN = "throw_in"
    GOAL_KICK = "goal_kick"
    CORNER = "corner"
    FREE_KICK = "free_kick"
    PENALTY = "penalty"
    DROPPED_BALL = "dropped_ball"
    PLAY = "play"
    OVER = "over"


class Cue(StrEnum):
    """What moves a match on. A restart's cue is its signal."""

    WHISTLE = "whistle"  # STOP, for whatever reason
    KICK_OFF = "kick_off"
    THROW_IN = "throw_in"
    GOAL_KICK = "goal_kick"
    CORNER = "corner"
    FREE_KICK = "free_kick"
    PENALTY = "penalty"
    DROPPED_BALL = "dropped_ball"
    IN_PLAY = "in_play"  # the ball has been played, or the time to play it is over
    TIME_UP = "time_up"


RESTART = {Cue.WHISTLE: Phase.STOP, Cue.IN_PLAY: Phase.PLAY, Cue.TIME_UP: Phase.OVER}

TRANSITIONS: dict[Phase, dict[Cue, Phase]] = {
    Phase.STOP: {  # ends after stop_time
        Cue.WHISTLE: Phase.STOP,
        Cue.KICK_OFF: Phase.KICK_OFF,
        Cue.THROW_IN: Phase.THROW_IN,
        Cue.GOAL_KICK: Phase.GOAL_KICK,
        Cue.CORNER: Phase.CORNER,
        Cue.FREE_KICK: Phase.FREE_KICK,
        Cue.PENALTY: Phase.PENALTY,
        Cue.DROPPED_BALL: Phase.DROPPED_BALL,
        Cue.TIME_UP: Phase.OVER,
    },
    # a restart: START at the latest restart_time after STOP, in play at the latest play_time later
    Phase.KICK_OFF: RESTART,
    Phase.THROW_IN: RESTART,
    Phase.GOAL_KICK: RESTART,
    Phase.CORNER: RESTART,
    Phase.FREE_KICK: RESTART,
    Phase.PENALTY: RESTART,
    Phase.DROPPED_BALL: RESTART,
    # a ball that gets nowhere for stuck_time is dropped
    Phase.PLAY: {Cue.WHISTLE: Phase.STOP, Cue.TIME_UP: Phase.OVER},
    Phase.OVER: {},
}

RESTARTS = tuple(phase for phase, cues in TRANSITIONS.items() if cues is RESTART)
RULES = {  # the section that a restart stands in: FIFA's laws, which the league's book follows
    Phase.KICK_OFF: "Law 8: kick-off",
    Phase.THROW_IN: "Law 15: throw-in",
    Phase.GOAL_KICK: "Law 16: goal kick",
    Phase.CORNER: "Law 17: corner kick",
    Phase.FREE_KICK: "Law 13: free kick",
    Phase.PENALTY: "Law 14: penalty kick",
    Phase.DROPPED_BALL: "Law 8: dropped ball",
}
