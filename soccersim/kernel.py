"""Compiled kernels: the only place that imports numba.

A kernel is a plain function of floats and arrays. Compiled and plain (NUMBA_DISABLE_JIT=1) runs
give the same bits, so kernels use `math` and + - * / alone: no `**`, no numpy functions.
"""

import hashlib
import os
import sys
import tempfile
from collections.abc import Callable
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any, ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")

COMPILED = os.environ.get("NUMBA_DISABLE_JIT", "0") in ("", "0")
for option, value in (
    ("NUMBA_DISABLE_INTEL_SVML", "1"),  # its vector library rounds otherwise than libm
    ("NUMBA_LOOP_VECTORIZE", "0"),  # loops over three wheels: it costs a third of compiling
    ("NUMBA_OPT", "2"),  # as fast as 3 here, and compiled in three quarters of the time
):
    os.environ.setdefault(option, value)


def kernel(function: Callable[P, R]) -> Callable[P, R]:
    """The function, compiled at its first call and kept on disk for the next process."""
    return _compiled(function, inner=False)


def inner(function: Callable[P, R]) -> Callable[P, R]:
    """A kernel that kernels alone call.

    It gets no door to Python, which would cost more to compile than the function itself.
    """
    return _compiled(function, inner=True)


def settled(function: Callable[P, R]) -> Callable[P, R]:
    """The kernel for whoever calls it with the same types ever again: it looks at them once.

    For a tuple of hundreds of arrays that look takes 28 of the 35 us of a call. Other types later
    would be read as if they were the first.
    """
    if not COMPILED:
        return function
    kernel: Any = function
    compiled: Any = None

    def call(*arguments: P.args, **_: P.kwargs) -> R:
        nonlocal compiled
        if compiled:
            result: R = compiled(*arguments)
        else:
            result = kernel(*arguments)
            if len(kernel.overloads) == 1:  # else it is not plain which of them it was
                compiled = next(iter(kernel.overloads.values())).entry_point
        return result

    return call


def _compiled(function: Callable[P, R], inner: bool) -> Callable[P, R]:
    if not COMPILED:
        return function
    # untyped on purpose: only the newest numba brings types, and not for these options
    config: Any = import_module("numba.core.config")
    njit: Any = import_module("numba").njit
    folder = cache_folder()
    before = config.CACHE_DIR
    config.CACHE_DIR = str(folder or before)
    try:
        compile_ = njit(
            cache=folder is not None,
            error_model="numpy",
            _nrt=False,  # kernels make no arrays: nothing to count
            nogil=True,
            no_cpython_wrapper=inner,
            no_cfunc_wrapper=True,
        )
        compiled: Callable[P, R] = compile_(function)
    finally:
        config.CACHE_DIR = before
    return compiled


@cache
def cache_folder() -> Path | None:
    """Where compiled kernels are kept; None where no such folder can be written.

    numba sees edits of the file a kernel stands in, not of the kernels it calls: the folder's
    name is a digest of all our sources, so an edit anywhere starts a new one.
    """
    root = Path(os.environ.get("SOCCERSIM_CACHE") or _user_cache()) / f"kernels-{_own_digest()}"
    try:
        root.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=root):
            return root
    except OSError:
        return None


def will_compile() -> bool:
    """Whether the next simulation has to compile first: the loop, compiled last, is not kept."""
    if not COMPILED:
        return False
    folder = cache_folder()
    return folder is None or not any(folder.rglob("*.run_ticks-*.nbi"))


def _user_cache() -> Path:
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or Path.home()) / "soccersim"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "soccersim"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "soccersim"


def _own_digest() -> str:
    """A digest of every source file that holds or may shape a kernel."""
    here = Path(__file__).parent
    digest = hashlib.sha256(str(here).encode())
    for path in sorted(here.rglob("*.py")):
        text = path.read_bytes()
        if any(word in text for word in (b"@kernel", b"@inner", b"NamedTuple")):
            digest.update(path.name.encode() + text)
    return digest.hexdigest()[:16]
