"""Axes of a small chart in SVG: scales, ticks, labels. Colours come from the page's style sheet."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import ceil, floor, log10

from soccersim.regress.report.markup import Html, join, tag, text
from soccersim.regress.report.words import number

# of the drawing, in its own units: small, so that letters stay large on a phone
WIDTH, HEIGHT = 460, 300
LEFT, RIGHT, TOP, BOTTOM = 58, 16, 16, 50

Points = Sequence[tuple[float, float]]


@dataclass(frozen=True)
class Axes:
    """What numbers the drawing spans."""

    x: tuple[float, float]
    y: tuple[float, float]

    def px(self, x: float) -> float:
        """Where x lies in the drawing."""
        low, high = self.x
        return LEFT + (WIDTH - LEFT - RIGHT) * (x - low) / (high - low)

    def py(self, y: float) -> float:
        """Where y lies in the drawing."""
        low, high = self.y
        return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * (y - low) / (high - low)

    def line(self, points: Points, class_: str, **more: object) -> Html:
        """A line through points."""
        told = " ".join(f"{self.px(x):.1f},{self.py(y):.1f}" for x, y in points)
        return tag("polyline", points=told, class_=class_, **more)

    def band(self, points: Points, class_: str, **more: object) -> Html:
        """An area within points."""
        told = " ".join(f"{self.px(x):.1f},{self.py(y):.1f}" for x, y in points)
        return tag("polygon", points=told, class_=class_, **more)

    def level(self, y: float, class_: str) -> Html:
        """A line right across."""
        return self.line(((self.x[0], y), (self.x[1], y)), class_)

    def upright(self, x: float, class_: str) -> Html:
        """A line from the bottom to the top."""
        return self.line(((x, self.y[0]), (x, self.y[1])), class_)

    def box(
        self, left: float, right: float, y0: float, y1: float, class_: str, *of: object
    ) -> Html:
        """A rectangle, with what it says when it is pointed at."""
        x, y = self.px(left), self.py(max(y0, y1))
        wide, high = self.px(right) - x, self.py(min(y0, y1)) - y
        place = {"x": f"{x:.1f}", "y": f"{y:.1f}", "width": f"{wide:.1f}", "height": f"{high:.1f}"}
        return tag("rect", *of, class_=class_, **place)

    def dot(self, x: float, y: float, class_: str, said: str) -> Html:
        """A mark, with what it says when it is pointed at."""
        place = {"cx": f"{self.px(x):.1f}", "cy": f"{self.py(y):.1f}"}
        return tag("circle", tag("title", said), r="3.2", class_=class_, **place)

    def words(
        self, x: float, y: float, said: str, class_: str, below: float = -5.0, anchor: str = "start"
    ) -> Html:
        """Words that begin, or end, beside a place and so much below it."""
        beside = 5.0 if anchor == "start" else -5.0
        place = {"x": f"{self.px(x) + beside:.1f}", "y": f"{self.py(y) + below:.1f}"}
        return tag("text", said, class_=class_, text_anchor=anchor, **place)

    def frame(
        self, x_label: str, y_label: str, x_whole: bool = True, y_whole: bool = False
    ) -> Html:
        """Grid, ticks and what the axes are of."""
        marks = []
        for x in ticks(*self.x, most=7, whole=x_whole):
            place = {"x": f"{self.px(x):.1f}", "y": HEIGHT - BOTTOM + 18}
            marks.append(self.upright(x, "grid"))
            marks.append(tag("text", told(x), class_="tick", text_anchor="middle", **place))
        for y in ticks(*self.y, most=6, whole=y_whole):
            place = {"x": LEFT - 7, "y": f"{self.py(y) + 4.5:.1f}"}
            marks.append(self.level(y, "grid"))
            marks.append(tag("text", told(y), class_="tick", text_anchor="end", **place))
        middle = (LEFT + WIDTH - RIGHT) / 2, (TOP + HEIGHT - BOTTOM) / 2
        below = {"x": middle[0], "y": HEIGHT - 8}
        beside = {"x": 0, "y": 0, "transform": f"translate(15 {middle[1]}) rotate(-90)"}
        marks.append(tag("text", x_label, class_="axis", text_anchor="middle", **below))
        marks.append(tag("text", y_label, class_="axis", text_anchor="middle", **beside))
        return join(*marks)


def chart(name: str, said: str, *inside: object) -> Html:
    """A drawing in a figure; `said` tells those who do not see it what it shows, and all others."""
    drawing = tag(
        "svg",
        tag("title", name),
        *inside,
        viewBox=f"0 0 {WIDTH} {HEIGHT}",
        role="img",
        aria_label=f"{name}: {said}",
    )
    return tag("figure", tag("h3", name), drawing, tag("figcaption", text(said)))


def ticks(low: float, high: float, most: int, whole: bool = False) -> list[float]:
    """Round numbers from low to high, at most so many."""
    rough = (high - low) / most
    power = 10.0 ** floor(log10(rough))
    step = next(m * power for m in (1.0, 2.0, 5.0, 10.0) if m * power >= rough * 0.999)
    if whole:
        step = max(step, 1.0)
    return [k * step for k in range(ceil(low / step - 1e-9), floor(high / step + 1e-9) + 1)]


def told(value: float) -> str:
    """A tick's number, with as many places as it has."""
    return next(number(value, p) for p in (0, 1, 2, 3, 4) if abs(value - round(value, p)) < 1e-9)


def around(values: Iterable[float], share: float = 0.08) -> tuple[float, float]:
    """From below the least to above the largest."""
    each = list(values)
    low, high = min(each), max(each)
    room = share * ((high - low) or 1.0)
    return low - room, high + room
