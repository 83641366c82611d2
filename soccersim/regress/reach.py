"""Which files a strategy is made of: those that its code names. None of it is run to find out.

Its own file, and what that imports from its folder, and so on; a package as a whole, with its data.
Of other files those whose names stand in the code as they are: `Path(__file__).parent / "net.npz"`.
Installed libraries are left where they are, only their versions are noted.
"""

import ast
import sys
import sysconfig
from collections.abc import Iterator, Sequence
from importlib.machinery import ModuleSpec, PathFinder
from pathlib import Path

from soccersim.problems import InputError, Problem, one_line
from soccersim.strategy.load import Origin
from soccersim.strategy.space import NEVER_OWN

MOST_BYTES = 16 * 2**20
MOST_FILES = 1000
BY_NAME = {"import_module", "__import__"}  # code that has these may import what it spells out
LONGEST = 200  # characters of a text that may be a file's name


class Reach:
    """The files of a strategy, by their names in its bundle, and what it needs besides."""

    def __init__(self, origin: Origin) -> None:
        """InputError where they are too many, or cannot be read."""
        self.origin = origin
        self.files: dict[str, bytes] = {}
        self.libraries: set[str] = set()  # installed modules that it imports
        self.seen: set[str] = set()
        self.size = 0
        self._follow(origin.module.partition(".")[0])

    def _follow(self, top: str) -> None:
        """A module of this first name is imported."""
        if top in self.seen or top in NEVER_OWN:
            return
        self.seen.add(top)
        spec = self._own(top)
        if spec is None and top not in sys.stdlib_module_names:
            spec = found(top)
            if spec and is_installed(spec):
                self.libraries.add(top)
                return
        if spec is None:
            return
        for folder in map(Path, spec.submodule_search_locations or ()):
            for path in package_files(folder):
                self._take(path, f"{top}/{path.relative_to(folder).as_posix()}")
        if not spec.submodule_search_locations and spec.origin:
            self._take(Path(spec.origin), Path(spec.origin).name)

    def _own(self, top: str) -> ModuleSpec | None:
        """Where the module is among the team's own, as strategy/space.py decides it."""
        origin = self.origin
        if not origin.whole:
            own = top == origin.module.partition(".")[0]
            return found(top, [origin.folder]) if own else None
        spec = found(top, [origin.folder])
        return spec if spec and (spec.loader or not found(top)) else None

    def _take(self, path: Path, name: str) -> None:
        """A file of the strategy, and what it names if it is code."""
        if name in self.files:
            return
        shown = one_line(self.origin.source, 200)
        try:
            self.size += path.stat().st_size
            if self.size > MOST_BYTES or len(self.files) >= MOST_FILES:
                most = f"{MOST_BYTES >> 20} MiB in {MOST_FILES} files"
                wrong = f"with all that it imports it is more than {most}"
                raise InputError(Problem(f"{wrong}: it stopped at {one_line(name)}", shown))
            self.files[name] = path.read_bytes()
        except OSError as error:
            wrong = f"{one_line(str(path), 200)}: {error.strerror or error}"
            raise InputError(Problem(wrong, shown)) from error
        if path.suffix == ".py":
            self._read(path, name)

    def _read(self, path: Path, name: str) -> None:
        """Follow what a file of code names."""
        try:
            tree = ast.parse(self.files[name])
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            return  # the match will tell
        nodes = list(ast.walk(tree))
        for top in imported(nodes, name.count("/") + 1):
            self._follow(top)
        texts = {n.value for n in nodes if isinstance(n, ast.Constant) and isinstance(n.value, str)}
        if BY_NAME & {getattr(n, "id", getattr(n, "attr", getattr(n, "name", ""))) for n in nodes}:
            for text in sorted(texts):
                if text.partition(".")[0].isidentifier():
                    self._follow(text.partition(".")[0])
        if "/" not in name:  # a package is taken whole
            for text in sorted(texts):
                if data := named(path.parent, text):
                    self._take(data, data.relative_to(path.parent).as_posix())


def imported(nodes: Sequence[ast.AST], root: int) -> Iterator[str]:
    """First names of the modules that code imports; root: as many dots lead to the top folder."""
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from (alias.name.partition(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level in (0, root):
            names = [node.module] if node.module else [alias.name for alias in node.names]
            yield from (name.partition(".")[0] for name in names)


def found(top: str, path: Sequence[str] | None = None) -> ModuleSpec | None:
    """Where Python finds a module of this name, on this path or on its own."""
    try:
        return PathFinder.find_spec(top, path)
    except (ImportError, ValueError, OSError):
        return None


def is_installed(spec: ModuleSpec) -> bool:
    """Whether a module belongs to a library that has a version, or to Python."""
    places = [spec.origin, *(spec.submodule_search_locations or ())]
    homes = [sysconfig.get_path(key) for key in ("purelib", "platlib", "stdlib", "platstdlib")]
    homes += [entry for entry in sys.path if entry.endswith(("site-packages", "dist-packages"))]
    paths = [Path(place).resolve() for place in places if place]
    return any(path.is_relative_to(Path(home).resolve()) for home in homes for path in paths)


def package_files(folder: Path) -> Iterator[Path]:
    """All files of a package that are not hidden, nor Python's own."""
    for path in sorted(folder.rglob("*")):
        parts = path.relative_to(folder).parts
        hidden = any(part.startswith(".") or part == "__pycache__" for part in parts)
        if not hidden and path.is_file():
            yield path


def named(folder: Path, text: str) -> Path | None:
    """The file in this folder that a text in the code names."""
    if not 0 < len(text) <= LONGEST or not text.isprintable():
        return None
    path = Path(text)
    if path.is_absolute() or ".." in path.parts:
        return None
    try:
        return folder / path if (folder / path).is_file() else None
    except OSError:
        return None
