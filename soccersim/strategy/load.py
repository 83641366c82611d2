"""Find a team's strategy by its name, and make one. Two teams never share a module."""

from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from importlib import import_module
from importlib.machinery import PathFinder
from pathlib import Path
from typing import Any, TypeGuard

from soccersim import bundled
from soccersim.problems import InputError, Problem, one_line
from soccersim.strategy.space import Space

ENTRY_POINTS = "soccersim.strategies"


@dataclass(frozen=True)
class Origin:
    """Where a strategy stands: plain texts, so that another process can load it."""

    source: str  # as it was named
    folder: str  # where its modules are looked for; absolute
    module: str  # from there: my_team, or package.module
    cls: str = ""  # "": the one class that has decide
    whole: bool = True  # all modules of the folder are the team's, not only the module's package


def locate(source: str, beside: Path | None = None) -> Origin:
    """Where the strategy of this name stands; runs nothing of it.

    source: a bundled name, `file.py`, `package.module` or an entry point of the group
    soccersim.strategies, and any of them with `:Class`. Files are looked for from the folder
    `beside` (default: the working folder), modules there and on sys.path. InputError if there
    is nothing of this name.
    """
    name, _, cls = source.rpartition(":")
    if not name or not cls.isidentifier():
        name, cls = source, ""
    if "/" in name or "\\" in name or name.endswith(".py"):
        return locate_file(source, (beside or Path()) / name, cls)
    if name in bundled.names("strategy"):
        return locate_file(source, bundled.find("strategy", name), cls)
    if "." not in name and (found := entry_point(name)):
        name, _, inside = found.partition(":")
        cls = cls or inside
    elif "." not in name and not cls:
        bundled.find("strategy", name, beside)  # raises, with the nearest name
    return locate_module(source, name, cls, beside or Path())


def locate_file(source: str, path: Path, cls: str) -> Origin:
    """The origin of a strategy's file; InputError where it cannot be one."""
    shown = one_line(str(path), 200)
    if path.is_dir():
        raise InputError(Problem(f"is a folder: name the file in it, as {shown}/team.py", shown))
    if not path.is_file():
        near = get_close_matches(path.name, [p.name for p in path.parent.glob("*.py")], n=1)
        hint = f"; did you mean `{near[0]}`?" if near else ""
        raise InputError(Problem(f"there is no such file{hint}", shown))
    if path.suffix != ".py":
        raise InputError(Problem("a strategy is a Python file: its name ends in .py", shown))
    if not path.stem.isidentifier():
        hint = "letters, digits and _ only, no digit first"
        raise InputError(Problem(f"its name cannot be a module's: {hint}", shown))
    return Origin(source, str(path.parent.resolve()), path.stem, cls)


def locate_module(source: str, name: str, cls: str, folder: Path) -> Origin:
    """The origin of a module on sys.path or in the folder; imports nothing."""
    parts = name.split(".")
    path: list[str] | None = None
    first = ""
    for at, part in enumerate(parts):
        roots = [str(folder.resolve())] if at == 0 else path
        spec = part.isidentifier() and (
            PathFinder.find_spec(part, roots) or (at == 0 and PathFinder.find_spec(part))
        )
        if not spec or (at == len(parts) - 1 and not spec.has_location):
            known = ".".join(parts[: at + 1])
            hint = "a file's name ends in .py, a module is found from here or on sys.path"
            raise InputError(
                Problem(f"no module `{one_line(known)}` for `{one_line(source)}`: {hint}")
            )
        path = list(spec.submodule_search_locations or [])
        if at == 0:
            first = path[0] if path else str(spec.origin)
    return Origin(source, str(Path(first).parent), name, cls, whole=False)


def entry_point(name: str) -> str:
    """What an installed package declares under this name in soccersim.strategies; "": nothing."""
    from importlib.metadata import entry_points

    found = entry_points(group=ENTRY_POINTS, name=name)
    return next(iter(found)).value.replace(" ", "") if found else ""


def load_team(origin: Origin) -> type:
    """The strategy's class. Runs the team's code: what that raises comes out as it is.

    Each call loads the team's modules anew, for itself alone. InputError where the module has
    no such class, or not exactly one that could be meant.
    """
    space = Space(Path(origin.folder), None if origin.whole else origin.module.split(".")[0])
    module = import_module(f"{space.prefix}.{origin.module}")
    own = [v for v in vars(module).values() if is_strategy(v) and v.__module__ == module.__name__]
    found: dict[str, type] = {value.__name__: value for value in own}
    shown = one_line(origin.source, 200)
    if origin.cls:
        named = getattr(module, origin.cls, None)
        if is_strategy(named):
            return named
        wrong = "is not a class with decide()" if named is not None else "is not there"
        near = get_close_matches(origin.cls, found, n=1) or list(found)
        hint = f"; there is `{near[0]}`" if near else ""
        raise InputError(Problem(f"`{origin.cls}` {wrong}{hint}", shown))
    if len(found) == 1:
        return next(iter(found.values()))
    if not found:
        raise InputError(Problem("defines no class with a method decide(self, view)", shown))
    names = ", ".join(f"`{name}`" for name in found)
    raise InputError(Problem(f"several classes have decide(): {names}; add :NAME", shown))


def is_strategy(value: Any) -> TypeGuard[type]:
    """Whether this is a class with a decide() of its own making, or inherited, not abstract."""
    decide = getattr(value, "decide", None) if isinstance(value, type) else None
    return callable(decide) and not getattr(decide, "__isabstractmethod__", False)


def make_team(kind: type, rng: Any, options: Mapping[str, Any]) -> Any:
    """The strategy, ready to decide. TypeError names options that its class does not take."""
    from inspect import Parameter, signature

    taken = signature(kind).parameters
    any_name = any(p.kind is Parameter.VAR_KEYWORD for p in taken.values())
    if not taken:
        raise TypeError(f"{kind.__name__} must take rng: def __init__(self, rng)")
    named = (Parameter.POSITIONAL_OR_KEYWORD, Parameter.KEYWORD_ONLY)
    known = [name for name, p in list(taken.items())[1:] if p.kind in named]  # the first is rng
    wrong = [] if any_name else [name for name in options if name not in known]
    if wrong:
        near = get_close_matches(wrong[0], known, n=1)
        has = f"it takes {', '.join(known)}" if known else "it takes none"
        hint = f"did you mean `{near[0]}`?" if near else has
        told = ", ".join(f"`{one_line(str(name))}`" for name in wrong)
        raise TypeError(f"{kind.__name__} has no option {told}: {hint}")
    missing = [n for n in known if taken[n].default is Parameter.empty and n not in options]
    if missing:
        raise TypeError(f"{kind.__name__} needs the option `{missing[0]}`")
    return kind(rng, **options)
