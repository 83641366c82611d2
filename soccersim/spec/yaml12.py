"""Strict YAML 1.2 with places: plain data, and where in which file each piece of it stands.

PyYAML scans and parses; the values are built here, because its own constructor reads YAML 1.1
(`no` is false, 010 is 8), lets the last of two equal keys win and forgets every place. Anchors,
aliases, merge keys and tags are refused: nothing here needs them, and they can blow up.
"""

import copy
import os
import re
import stat
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, NamedTuple, NoReturn, TypeAlias

import yaml

from soccersim.problems import InputError, Problem, one_line
from soccersim.spec import core_schema
from soccersim.spec.wording import NO_ALIAS, NO_TAG, dotted, instead_of, retold, show

MAX_BYTES = 96 * 1024  # PyYAML's scanner, itself Python, takes up to 2 us a byte ...
MAX_NODES = 12_000  # ... and 25 us a key or value; 22 robots written out are some 5 000
MAX_DEPTH = 32

Path: TypeAlias = tuple[str | int, ...]
Value: TypeAlias = "bool | int | float | str | list[Value] | dict[str, Value] | None"

FORBIDDEN = re.compile(  # control characters, unusual line breaks, halves of a surrogate pair
    "[^\t\n\r\x20-\x7e\xa0-\u2027\u202a-\ud7ff\ue000-\ufefe\uff00-\ufffd\U00010000-\U0010ffff]"
)


class Mark(NamedTuple):
    """A place: line and column from 1, or 0 where there are none (on the command line)."""

    file: str
    line: int = 0
    column: int = 0


@dataclass
class Tree:
    """Plain data with its places: `marks` of every value, `keys` of every key of a mapping."""

    value: Value = None
    marks: dict[Path, Mark] = field(default_factory=dict)
    keys: dict[Path, Mark] = field(default_factory=dict)

    def place(self, path: Path) -> Mark:
        """Where the value at path stands, or else the deepest part of the way to it."""
        while path and path not in self.marks:
            path = path[:-1]
        return self.marks.get(path, Mark(""))

    def graft(self, path: Path, other: "Tree") -> None:
        """Put a copy of other at path, over what is there; its places stay its own."""
        size = len(path)
        self.marks = {at: mark for at, mark in self.marks.items() if at[:size] != path}
        self.keys = {at: mark for at, mark in self.keys.items() if at[:size] != path or at == path}
        self.marks |= {path + at: mark for at, mark in other.marks.items()}
        self.keys |= {path + at: mark for at, mark in other.keys.items()}
        if not path:
            self.value = copy.deepcopy(other.value)
            return
        parent: Any = self.value
        for step in path[:-1]:
            parent = parent[step]
        parent[path[-1]] = copy.deepcopy(other.value)
        if isinstance(parent, dict):
            self.keys.setdefault(path, other.place(()))

    def set(self, path: str, text: str, file: str = "--set") -> None:
        """Put a value, written in YAML, at a dotted path: `robots.0.model.mass`, `25`.

        Keys may be new, also on the way: validation says whether they are known. No text is null.
        """
        mark = Mark(f"{file} {one_line(f'{path}={text}')}")
        steps, missing = self._steps(path, mark)
        try:
            new = parse(text or "null", mark.file)
        except InputError as error:
            raise InputError(Problem(error.problems[0].message, mark.file)) from None
        for name in reversed(missing):
            outer = Tree({}, {(): mark})
            outer.graft((name,), new)
            new = outer
        new.marks = dict.fromkeys(new.marks, mark)
        new.keys = dict.fromkeys(new.keys, mark)
        self.graft(steps, new)

    def _steps(self, path: str, mark: Mark) -> tuple[Path, list[str]]:
        """The dotted path as steps from value to value, and the keys that follow a new one."""
        steps: Path = ()
        value = self.value
        names = path.split(".")
        can_add = all(names) and len(names) <= MAX_DEPTH
        for done, name in enumerate(names):
            if isinstance(value, list) and (index := index_of(name, value)) is not None:
                steps, value = (*steps, index), value[index]
            elif isinstance(value, dict) and name in value:
                steps, value = (*steps, name), value[name]
            elif can_add and isinstance(value, dict):
                return (*steps, name), names[done + 1 :]
            elif can_add and steps and value is None:
                return steps, names[done:]
            else:
                raise InputError(Problem(no_step(value, name), mark.file, path=dotted(steps)))
        return steps, []


def index_of(name: str, values: list[Value]) -> int | None:
    """The index that name spells, if the list has it."""
    index = int(name) if re.fullmatch("[0-9]{1,9}", name) else len(values)
    return index if index < len(values) else None


def no_step(value: Value, name: str) -> str:
    """Why there is no way from value to its entry name."""
    if isinstance(value, dict):
        return f"there is no key `{one_line(name)}`{instead_of(name, value)}"
    if isinstance(value, list):
        entries = f"has the entries 0 to {len(value) - 1}" if value else "is empty"
        return f"there is no entry `{one_line(name)}`: the list {entries}"
    return f"there is no `{one_line(name)}` in {show(value)}"


def parse_setting(text: str) -> tuple[str, str]:
    """The dotted path and the text of the value of a setting `a.b=c`."""
    path, equals, value = text.partition("=")
    path = path.strip()
    if not equals or not all(path.split(".")):
        raise InputError(Problem("write it as key.path=value", f"--set {one_line(text)}"))
    return path, value.strip(" ")


def read(path: str | os.PathLike[str]) -> Tree:
    """The tree of a YAML file; never waits for a pipe, never reads more than it may hold."""
    file = one_line(os.fspath(path), 300)
    try:
        if not stat.S_ISREG(os.stat(path).st_mode):
            raise InputError(Problem("is not a file: a YAML file is needed", file))
        with open(path, "rb") as stream:
            data = stream.read(MAX_BYTES + 1)
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        reason = getattr(error, "strerror", None) or error
        raise InputError(Problem(f"cannot be read: {reason}", file)) from None
    if len(data) > MAX_BYTES:
        raise InputError(too_large(file))
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        place = after(data[: error.start].decode("utf-8"), file)
        fail(place, f"byte 0x{data[error.start]:02x} is not UTF-8: a YAML text is needed")
    return parse(text, file)


def parse(text: str, file: str) -> Tree:
    """The tree of a YAML text; file is the name that its places carry."""
    text = text.removeprefix("\ufeff")
    if len(text) > MAX_BYTES:
        raise InputError(too_large(file))
    if wrong := FORBIDDEN.search(text):
        place = after(text[: wrong.start()], file)
        fail(place, f"a YAML text may not hold the character U+{ord(wrong.group()):04X}")
    loader = yaml.SafeLoader(text)
    try:
        return Builder(loader, file).document()
    except yaml.MarkedYAMLError as error:
        message, at = retold(error)
        fail(Mark(file, at.line + 1, at.column + 1) if at else Mark(file), message)
    except (ValueError, OverflowError):  # PyYAML's own, for \UFFFFFFFF or %YAML 1.999...
        fail(Mark(file, loader.line + 1, loader.column + 1), "this number is too large")
    finally:
        loader.dispose()


class Builder:
    """Turns PyYAML's events into a tree; refuses what YAML 1.2 or we do not allow."""

    def __init__(self, loader: Any, file: str) -> None:
        self.loader = loader  # PyYAML's methods carry no types
        self.file = file
        self.tree = Tree()
        self.nodes = 0

    def document(self) -> Tree:
        """The one document of the text."""
        self.loader.get_event()  # the start of the stream
        start = self.loader.get_event()
        if getattr(start, "version", None) not in (None, (1, 2)) or getattr(start, "tags", None):
            fail(self.mark(start), "this is read as YAML 1.2: delete the line that starts with %")
        if isinstance(start, yaml.StreamEndEvent) or is_left_out(self.loader.peek_event()):
            fail(Mark(self.file, 1, 1), "is empty: a YAML document is needed")
        self.tree.value = self.node(())
        self.loader.get_event()  # the end of the document
        end = self.loader.get_event()
        if not isinstance(end, yaml.StreamEndEvent):
            fail(self.mark(end), "a second document starts here: only one is allowed")
        return self.tree

    def node(self, path: Path) -> Value:
        """The value that comes next; it stands at path."""
        event = self.event()
        mark = self.tree.marks[path] = self.mark(event)
        if isinstance(event, yaml.ScalarEvent):
            return self.scalar(event)
        if len(path) >= MAX_DEPTH:
            fail(mark, f"more than {MAX_DEPTH} levels: nest less deeply")
        if isinstance(event, yaml.SequenceStartEvent):
            return [self.node((*path, index)) for index in self.until(yaml.SequenceEndEvent)]
        mapping: dict[str, Value] = {}
        for _ in self.until(yaml.MappingEndEvent):
            key = self.key(path)
            mapping[key] = self.node((*path, key))
        return mapping

    def until(self, end: type[yaml.Event]) -> Iterator[int]:
        """Counts the entries of a collection from 0, to its end."""
        index = 0
        while not self.loader.check_event(end):
            yield index
            index += 1
        self.loader.get_event()

    def key(self, path: Path) -> str:
        """The key that comes next in the mapping at path: a text, and a new one."""
        event = self.event()
        mark = self.mark(event)
        if not isinstance(event, yaml.ScalarEvent):
            fail(mark, "a key must be a text, not a list or a mapping")
        key = self.scalar(event)
        if not isinstance(key, str):
            fail(mark, f"a key must be a text, not {show(key)}: put it in quotes")
        if key == "<<" and event.style is None:
            fail(mark, "merge keys (<<) are not allowed: write the keys out")
        if ":" in key and event.style is None and is_left_out(self.loader.peek_event()):
            fail(mark, f"`{one_line(key)}` is one word: put a space after the colon")
        if first := self.tree.keys.get((*path, key)):
            fail(mark, f"the key `{one_line(key)}` stands on line {first.line} already: keep one")
        self.tree.keys[(*path, key)] = mark
        return key

    def scalar(self, event: yaml.ScalarEvent) -> Value:
        """A scalar by the core schema; what is in quotes is a text."""
        try:
            return (core_schema.text if event.style else core_schema.plain)(event.value)
        except ValueError as error:
            fail(self.mark(event), str(error))

    def event(self) -> yaml.ScalarEvent | yaml.CollectionStartEvent:
        """The event that starts the next key or value."""
        event = self.loader.get_event()
        self.nodes += 1
        if self.nodes > MAX_NODES:
            fail(self.mark(event), f"more than {MAX_NODES} keys and values: a file holds fewer")
        if isinstance(event, yaml.AliasEvent) or event.anchor is not None:
            fail(self.mark(event), NO_ALIAS)
        if event.tag is not None:
            fail(self.mark(event), NO_TAG)
        node: yaml.ScalarEvent | yaml.CollectionStartEvent = event
        return node

    def mark(self, event: yaml.Event) -> Mark:
        """Where an event starts."""
        start = event.start_mark
        return Mark(self.file, start.line + 1, start.column + 1) if start else Mark(self.file)


def is_left_out(event: yaml.Event | None) -> bool:
    """Whether an event stands for a value that is not written at all."""
    return isinstance(event, yaml.ScalarEvent) and event.start_mark is event.end_mark


def after(text: str, file: str) -> Mark:
    """The place right after text."""
    return Mark(file, text.count("\n") + 1, len(text) - text.rfind("\n"))


def too_large(file: str) -> Problem:
    """The problem of a file beyond the bound."""
    return Problem(f"is larger than {MAX_BYTES // 1024} KiB: a file holds less", file)


def fail(mark: Mark, message: str) -> NoReturn:
    """Raise the one problem that ends the reading of a file."""
    raise InputError(Problem(message, *mark))
