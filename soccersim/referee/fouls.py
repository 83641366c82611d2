"""What stops play besides the ball going out: fouls, and a ball that gets nowhere."""

from math import hypot, inf

from soccersim.referee.events import Call, Place
from soccersim.referee.ground import Ground
from soccersim.referee.phases import Phase
from soccersim.referee.scene import Scene
from soccersim.referee.watch import Watch

PUSHING, DRIBBLING = "Law 12: pushing", "RC-12.3: dribbling"
KEEPER, AREA = "Law 12: touching the keeper", "Law 12: robots in a penalty area"
STUCK = "Law 8: dropped ball"


class Fouls:
    """The clocks of what may last only so long; all stand while the ball is not in play."""

    def __init__(self, scene: Scene, ground: Ground) -> None:
        self.scene, self.ground = scene, ground
        rules = scene.rules
        self.area_ticks = scene.ticks(rules.area_time or 0.0)
        self.grace_ticks = scene.ticks(rules.area_grace)
        self.stuck_ticks = scene.ticks(rules.stuck_time)
        self.leave_ticks = scene.ticks(rules.leave_time or 0.0)
        area = scene.field.penalty_area
        played = rules.area_time is not None and area is not None
        self.area_x = ground.half_length - area.depth if played and area else inf
        self.area_y = area.width / 2 if area else 0.0
        self.beyond_x = [ground.half_length + radius for radius in scene.radius]
        self.beyond_y = [ground.half_width + radius for radius in scene.radius]
        self.begin()

    def begin(self) -> None:
        """The ball comes into play."""
        scene = self.scene
        self.seen = scene.tick
        self.anchor: Place = (scene.x, scene.y)
        self.anchored = scene.tick
        self.entered: dict[int, int] = {}  # row in a penalty area: since when
        self.crowded: dict[tuple[bool, int], int] = {}  # end, slot with two in an area: since
        self.outside: dict[int, int] = {}  # row outside the lines: since when

    def check(self, watch: Watch) -> Call | None:
        """The first foul that is seen, if any."""
        rules = self.scene.rules
        call = self._pushing(watch) if rules.pushing else None
        if call is None and rules.dribble:
            call = self._dribbling(watch, rules.dribble)
        if call is None and rules.keeper_protected:
            call = self._keeper(watch)
        inside = self._look()
        if call is None and (inside or self.entered):
            call = self._areas(inside)
        self.seen = self.scene.tick
        return call or self._stuck()

    def _foul(
        self, kind: str, rule: str, text: str, at: Place, by: int, to: tuple[int, ...] = ()
    ) -> Call:
        """A free kick for the other side."""
        slot = self.scene.slot[by]
        ball = self.ground.free_kick(*at)
        return Call(kind, rule, text, at, Phase.FREE_KICK, 1 - slot, ball, (by, *to), slot)

    def _pushing(self, watch: Watch) -> Call | None:
        if watch.pushed[0] < 0.0:
            return None
        _, pusher, pushed, x, y = watch.pushed.tolist()
        by, to = int(pusher), int(pushed)
        scene, mark = self.scene, self.ground.mark
        slot, names = scene.slot[by], scene.names
        text = f"{names[by]} pushes {names[to]}"
        own_end = -scene.direction[slot]
        if scene.rules.penalties and mark and self.ground.penalty_end(x, y) == own_end:
            ball = (own_end * mark, 0.0)
            text += " in its own penalty area"
            return Call(
                "pushing", PUSHING, text, (x, y), Phase.PENALTY, 1 - slot, ball, (by, to), slot
            )
        return self._foul("pushing", PUSHING, text, (x, y), by, (to,))

    def _dribbling(self, watch: Watch, most: float) -> Call | None:
        now = self.scene.tick - watch.release
        for row, touched in enumerate(watch.touched.tolist()):
            if touched >= now:
                (x0, y0), (x, y) = watch.caught[row].tolist(), watch.kicker[row].tolist()
                if hypot(x - x0, y - y0) > most:
                    text = f"{self.scene.names[row]} dribbles farther than {most:g} m"
                    return self._foul("dribbling", DRIBBLING, text, (x, y), row)
        return None

    def _keeper(self, watch: Watch) -> Call | None:
        """An opponent touches a keeper in its goal area."""
        scene, met = self.scene, watch.met
        if watch.contact[0] <= self.seen:
            return None
        for pair, tick in enumerate(met.tolist()):
            if tick <= self.seen:
                continue
            for keeper, other in (watch.pairs[pair].tolist(), watch.pairs[pair].tolist()[::-1]):
                at = scene.place(keeper)
                own_end = -scene.direction[scene.slot[keeper]]
                if scene.keeper[keeper] and self.ground.goal_end(*at) == own_end:
                    text = f"{scene.names[other]} touches the keeper {scene.names[keeper]}"
                    return self._foul("keeper", KEEPER, text, at, other, (keeper,))
        return None

    def _look(self) -> list[int]:
        """Who is in a penalty area, keepers in their own excepted; notes who is outside."""
        scene, tick = self.scene, self.scene.tick
        inside, outside = [], {}
        for row in scene.rows:
            body = scene.body[row]
            x, y = abs(body[0]), abs(body[1])
            if not scene.playing[row]:
                continue
            own_keeper = scene.keeper[row] and scene.ahead(row, body[0]) < 0.0
            if x >= self.area_x and y <= self.area_y and not own_keeper:
                inside.append(row)
            if x > self.beyond_x[row] or y > self.beyond_y[row]:
                outside[row] = self.outside.get(row, tick)
        self.outside = outside
        return inside

    def _areas(self, inside: list[int]) -> Call | None:
        """One robot of each side may be in a penalty area for a while, besides its keeper."""
        scene, tick = self.scene, self.scene.tick
        groups: dict[tuple[bool, int], list[int]] = {}
        for row in inside:
            groups.setdefault((scene.body[row][0] > 0.0, scene.slot[row]), []).append(row)
        self.entered = {row: self.entered.get(row, tick) for row in inside}
        crowds = {key: rows for key, rows in groups.items() if len(rows) > 1}
        self.crowded = {key: self.crowded.get(key, tick) for key in crowds}
        for row, since in self.entered.items():
            if tick - since > self.area_ticks:
                return self._area(row, "stays too long")
        for key, since in self.crowded.items():
            if tick - since > self.grace_ticks:
                last = max(crowds[key], key=self.entered.__getitem__)
                return self._area(last, "is the second")
        return None

    def _area(self, row: int, what: str) -> Call:
        scene = self.scene
        own = "the opponents'" if scene.ahead(row, scene.place(row)[0]) > 0.0 else "its own"
        text = f"{scene.names[row]} {what} in {own} penalty area"
        return self._foul("area", AREA, text, (scene.x, scene.y), row)

    def _stuck(self) -> Call | None:
        scene, (x, y) = self.scene, self.anchor
        if hypot(scene.x - x, scene.y - y) > scene.rules.stuck_distance:
            self.anchor, self.anchored = (scene.x, scene.y), scene.tick
        elif scene.tick - self.anchored >= self.stuck_ticks:
            at = (scene.x, scene.y)
            ball = self.ground.dropped(*at)
            return Call("stuck", STUCK, "the ball is stuck", at, Phase.DROPPED_BALL, None, ball)
        return None

    def leavers(self) -> list[int]:
        """Robots that have been wholly outside the lines for too long."""
        if not self.outside or self.scene.rules.leave_time is None:
            return []
        tick = self.scene.tick
        return [row for row, since in self.outside.items() if tick - since > self.leave_ticks]
