"""What comes with soccersim: scenarios, robots, fields, strategies and the papers' tables."""

from difflib import get_close_matches
from pathlib import Path

from soccersim.problems import InputError, Problem, one_line

PLACES = {
    "scenario": ("scenarios", ".yaml"),
    "robot": ("scenarios/robots", ".yaml"),
    "field": ("scenarios/fields", ".yaml"),
    "rules": ("scenarios/rules", ".yaml"),
    "senses": ("scenarios/senses", ".yaml"),
    "strategy": ("strategies", ".py"),
}


def root() -> Path:
    """The folder that holds scenarios/, strategies/ and assets/: in the wheel, or the checkout."""
    package = Path(__file__).parent
    inside = package / "bundled"
    return inside if inside.is_dir() else package.parent


def names(kind: str) -> list[str]:
    """The bundled scenarios, robots, fields or strategies, by name."""
    folder, suffix = PLACES[kind]
    return sorted(path.stem for path in (root() / folder).glob(f"*{suffix}"))


def is_path(source: str) -> bool:
    """Whether a source names a file, not something bundled: it has a slash or a suffix."""
    return "/" in source or "\\" in source or bool(Path(source).suffix)


def find(kind: str, source: str, beside: Path | None = None) -> Path:
    """The file of a source: a path (from the folder `beside`), or a bundled name.

    InputError with the nearest names where there is nothing of this name.
    """
    folder, suffix = PLACES[kind]
    if is_path(source):
        return (beside / source) if beside else Path(source)
    path = root() / folder / f"{source}{suffix}"
    if source and path.is_file():
        return path
    near = get_close_matches(source, names(kind), n=1)
    hint = f"did you mean `{near[0]}`?" if near else f"there are {', '.join(names(kind))}"
    if source and ((beside or Path()) / f"{source}{suffix}").is_file():
        hint = f"for the file here write `./{source}{suffix}`"
    raise InputError(Problem(f"no {kind} `{one_line(source)}` is bundled: {hint}"))
