"""A team's own space of modules: two teams may both ship strategy.py and utils.py.

The modules of a space stand in sys.modules under a prefix of their own, and their builtins have
an __import__ that looks there first: also for an import inside decide(), long after loading.
"""

import builtins
import sys
from collections.abc import Mapping, Sequence
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from itertools import count
from pathlib import Path
from types import ModuleType
from typing import Any

NEVER_OWN = {"soccersim", *sys.builtin_module_names}  # Command must be everybody's Command
numbers = count(1)


class Loader(SourceFileLoader):
    """Runs a module with the builtins of its space; compiles it from the source as it is now."""

    def __init__(self, name: str, path: str, space: "Space") -> None:
        super().__init__(name, path)
        self.space = space

    def get_code(self, fullname: str) -> Any:
        """The module's code; no cached one, which an edit within the same second would outlive."""
        path = self.get_filename(fullname)
        return self.source_to_code(self.get_data(path), path)

    def exec_module(self, module: ModuleType) -> None:
        """Run the module."""
        module.__dict__["__builtins__"] = self.space.builtins
        super().exec_module(module)


class Space:
    """The modules of one team. Stays in sys.meta_path as long as the process lives."""

    def __init__(self, folder: Path, only: str | None = None) -> None:
        """The folder's modules and packages are the team's own; with `only`, that one alone."""
        self.prefix = f"team_{next(numbers)}"
        self.folder = str(folder)
        self.only = only
        self.builtins = {**vars(builtins), "__import__": self.import_}
        self.known: dict[str, bool] = {}
        root = ModuleType(self.prefix)
        root.__path__ = [self.folder]
        sys.modules[self.prefix] = root
        sys.meta_path.insert(0, self)

    def find_spec(
        self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """How importlib loads a module of this space; None for all others."""
        if not name.startswith(self.prefix + "."):
            return None
        spec = PathFinder.find_spec(name, path, target)
        if spec and type(spec.loader) is SourceFileLoader:
            spec.loader = Loader(spec.loader.name, spec.loader.path, self)
        return spec

    def owns(self, top: str) -> bool:
        """Whether a module's first name is the team's own: its file or package is in the folder."""
        if top not in self.known:
            mine = self.only == top if self.only else self.looks_own(top)
            self.known[top] = mine and top not in NEVER_OWN
        return self.known[top]

    def looks_own(self, top: str) -> bool:
        """As Python finds modules: a folder without __init__.py gives way to a real package."""
        spec = PathFinder.find_spec(top, [self.folder])
        return spec is not None and (spec.loader is not None or not PathFinder.find_spec(top))

    def import_(
        self,
        name: str,
        globals: Mapping[str, object] | None = None,
        locals: Mapping[str, object] | None = None,
        fromlist: Sequence[str] | None = (),
        level: int = 0,
    ) -> ModuleType:
        """The __import__ of this space's modules."""
        top = name.partition(".")[0]
        if level or not self.owns(top):
            return builtins.__import__(name, globals, locals, fromlist or (), level)
        try:
            found = builtins.__import__(f"{self.prefix}.{name}", globals, locals, fromlist or ())
        except ImportError as error:
            error.msg = error.msg.replace(f"{self.prefix}.", "")
            raise
        return found if fromlist else sys.modules[f"{self.prefix}.{top}"]
