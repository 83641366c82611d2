"""A strategy as one zip of plain files: taken once, so that no later edit gets into a run."""

import hashlib
import io
import json
from dataclasses import dataclass
from functools import cached_property
from importlib.metadata import PackageNotFoundError, packages_distributions, version
from pathlib import Path, PurePosixPath
from typing import Any
from zipfile import BadZipFile, ZipFile, ZipInfo

from soccersim.problems import InputError, Problem, one_line
from soccersim.regress.reach import Reach
from soccersim.strategy.load import Origin, locate

Document = dict[str, Any]
BEGINNING = (1980, 1, 1, 0, 0, 0)  # of zip files: whenever it is bundled, it is the same bundle
UNIX, PLAIN = 3, 0o644 << 16


@dataclass(frozen=True)
class Bundle:
    """A strategy's code, and all that it needs to be loaded elsewhere."""

    name: str  # as the strategy was named
    data: bytes  # a zip; its comment names module, class and versions of libraries

    @cached_property
    def sha(self) -> str:
        """SHA-256 of the zip: another code, class or version of a library has another."""
        return hashlib.sha256(self.data).hexdigest()


def bundle(source: str, beside: Path | None = None) -> Bundle:
    """The strategy of this name as it is now; InputError where there is none. Runs none of it."""
    origin = locate(source, beside)
    reach = Reach(origin)
    told = {"module": origin.module, "cls": origin.cls, "needs": versions(reach.libraries)}
    file = io.BytesIO()
    with ZipFile(file, "w") as archive:  # stored as it is: compressed, other zlibs write others
        for name, data in sorted(reach.files.items()):
            entry = ZipInfo(name, BEGINNING)
            entry.create_system, entry.external_attr = UNIX, PLAIN
            archive.writestr(entry, data)
        archive.comment = json.dumps(told, sort_keys=True).encode()
    return Bundle(source, file.getvalue())


def same_program(one: Bundle, two: Bundle) -> bool:
    """Whether both are the same code byte for byte; a single file may have another name."""
    return one.sha == two.sha or content(one) == content(two)


def content(bundle: Bundle) -> tuple[Document, dict[str, bytes]]:
    """What a bundle tells and holds, without the name of the file that was named."""
    with ZipFile(io.BytesIO(bundle.data)) as archive:
        told = json.loads(archive.comment)
        files = {name: archive.read(name) for name in archive.namelist()}
    main = f"{told['module']}.py"
    if main in files:
        told["module"], files[""] = "", files.pop(main)
    return told, files


def unpack(bundle: Bundle, folder: Path) -> Origin:
    """Put a bundle's files into a folder, from which the strategy is loaded."""
    shown = one_line(bundle.name, 200)
    try:
        with ZipFile(io.BytesIO(bundle.data)) as archive:
            told = json.loads(archive.comment)
            for name in archive.namelist():
                parts = PurePosixPath(name).parts
                if ".." in parts or name.startswith("/") or "\\" in name or ":" in name:
                    raise BadZipFile(name)
                path = folder.joinpath(*parts)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(archive.read(name))
            return Origin(bundle.name, str(folder), told["module"], told["cls"])
    except (BadZipFile, ValueError, KeyError, TypeError) as error:
        raise InputError(Problem("is a damaged bundle", shown)) from error


def versions(modules: set[str]) -> dict[str, str]:
    """The installed libraries that these modules are of, with their versions."""
    if not modules:
        return {}
    known = packages_distributions()
    found = {}
    for library in sorted({name for module in modules for name in known.get(module, ())}):
        try:
            found[library] = version(library)
        except PackageNotFoundError:
            continue
    return found
