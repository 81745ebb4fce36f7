# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of parts: what is to be made, under which names, and what is there already.

A part has two numbers that may change while it is made, the memory and the time that a run may take. Everything
else of its command line is fixed by its row.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any, NamedTuple

MIB = 1 << 20
# The workflow's own; a row cannot set them.
OWN_OPTIONS = {"help", "version", "report", "repaired", "quiet", "skip-if-same", "picture",
               "picture-size"}  # fmt: skip
YES, NO = {"1", "yes", "true"}, {"", "0", "no", "false"}


class TableError(Exception):
    """The table cannot be read as one; its text says why."""


class Program(NamedTuple):
    path: str
    version: str
    options: dict[str, bool]  # name: whether it takes a value


class Part(NamedTuple):
    file: str  # as the table has it
    cells: dict[str, str]  # of all columns
    source: str  # where the surface is
    arguments: list[str]  # but for the files, the two limits and the threads
    memory: str  # MiB, the first limit
    timeout: str  # seconds, the first limit
    threads: str
    fault: str  # why the row is no part; empty: it is one
    name: str  # of its files


def look_at(path: str) -> Program:
    """The options that the program has, from its own help."""
    try:
        version = subprocess.run([path, "--version"], capture_output=True, text=True, check=True).stdout.strip()
        text = subprocess.run([path, "--help"], capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        raise TableError(f"the program {path} does not run: {error}; build it, and name it with program=PATH") from error
    found = re.findall(r"^  --([a-z][a-z-]*)(?: ([A-Z]+))?", text, re.MULTILINE)
    if not any(name == "thickness" for name, _ in found):
        raise TableError(f"{path} is not the program thicken: its --help lists no --thickness")
    return Program(path, version, {name: bool(value) for name, value in found})


def read_table(path: Path, program: Program, usual: dict[str, str]) -> list[Part]:
    """A part for each row. `usual`: memory, timeout and threads of rows that have none of their own."""
    try:
        lines = path.read_text("utf-8-sig").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise TableError(f"the table {path} cannot be read: {error}") from error
    columns = [name.strip() for name in lines[0].split("\t")] if lines else []
    _require_columns(path, columns, program)
    parts = []
    for number, line in enumerate(lines[1:], 2):
        if not line.strip():
            continue
        cells = [cell.strip() for cell in line.split("\t")]
        if len(cells) > len(columns):
            raise TableError(f"{path}, line {number}: {len(cells)} cells are more than the {len(columns)} columns")
        row = dict(zip(columns, cells + [""] * (len(columns) - len(cells))))
        parts.append(_part(row, path.parent, program, usual))
    return parts


def _require_columns(path: Path, columns: list[str], program: Program) -> None:
    for needed in ("file", "thickness"):
        if needed not in columns:
            raise TableError(f"the table {path} has no column \"{needed}\"; its first line names the columns, between tabs")
    for name in columns:
        if columns.count(name) > 1:
            raise TableError(f"the table {path} has the column \"{name}\" twice")
        if name in OWN_OPTIONS:
            raise TableError(f"the table {path} has the column \"{name}\", which the workflow sets itself; leave it out")
        if name != "file" and name not in program.options:
            raise TableError(f"the table {path} has the column \"{name}\", which is no option of {program.path}; "
                             f"the options are {', '.join(sorted(set(program.options) - OWN_OPTIONS))}")  # fmt: skip


def _part(row: dict[str, str], folder: Path, program: Program, usual: dict[str, str]) -> Part:
    arguments, fault = [], "" if row["file"] else "the row names no file"
    for name, value in row.items():
        if name in ("file", "memory", "timeout", "threads") or (program.options[name] and not value):
            continue
        if program.options[name]:
            arguments.append(f"--{name}={value}")
        elif value.lower() in YES:
            arguments.append(f"--{name}")
        elif value.lower() not in NO:
            fault = f"{name} is a yes or a no, and the row has {value}; write 1, yes or true, or leave it empty"
    source = str(folder / row["file"])
    limits = (row.get(name) or usual[name] for name in ("memory", "timeout", "threads"))
    return Part(row["file"], row, source, arguments, *limits, fault, _name(row))


def _name(row: dict[str, str]) -> str:
    """A name of its own for each row, the same wherever the table lies: readable, and no two files of a name clash."""
    told = "\t".join(f"{name}={value}" for name, value in sorted(row.items()) if value)
    stem = re.sub(r"[^\w.-]+", "_", Path(row["file"]).stem)[:40].lstrip(".-") or "part"
    size = re.sub(r"[^\w.]+", "_", row["thickness"])[:12]
    return f"{stem}-{size}mm-{hashlib.sha256(told.encode()).hexdigest()[:8]}"


class Folder:
    """The places of what is made, below the folder that the user named."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def solid(self, name: str) -> Path:
        return self.path / f"{name}.stl"

    def report(self, name: str) -> Path:
        return self.path / f"{name}.json"

    def picture(self, name: str) -> Path:
        return self.path / "pictures" / f"{name}.png"

    def row(self, name: str) -> Path:
        return self.path / "rows" / f"{name}.json"

    def make(self) -> None:
        for folder in ("pictures", "rows", "jobs"):
            (self.path / folder).mkdir(parents=True, exist_ok=True)


def read_json(path: Path) -> dict[str, Any]:
    """What the file holds; empty where it holds no object."""
    try:
        value = json.loads(path.read_text("utf-8"))
    except (OSError, ValueError):
        return {}
    return value if isinstance(value, dict) else {}


def write_whole(path: Path, content: str | bytes) -> None:
    """The file whole, or as it was."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    temporary.write_bytes(content.encode() if isinstance(content, str) else content)
    os.replace(temporary, path)


def made_of(part: Part, version: str) -> list[Any]:
    """What a row of the summary follows from, as JSON has it; the part is made again when that changes."""
    try:
        status = os.stat(part.source)
        source = [status.st_size, status.st_mtime_ns]
    except OSError:
        source = []
    return [version, json.loads(json.dumps(part)), source]


def is_done(part: Part, folder: Folder, version: str) -> bool:
    """Whether the part's row, report and, if there are to be some, solid and picture are there and belong together.
    What was no fault of the part's, such as a full disk, is tried again."""
    row = read_json(folder.row(part.name))
    if not row.get("final") or row.get("made_of") != made_of(part, version):
        return False
    if row["status"] == "failed" or row["told"]["code"] == "unwritable":
        return False
    if not folder.report(part.name).is_file():
        return False
    if row["status"] != "ok":
        return True
    solid = folder.solid(part.name)
    return folder.picture(part.name).is_file() and solid.is_file() and solid.stat().st_size == row["solid_bytes"]


def fail(sentence: str) -> None:
    """Ends the run with one line."""
    print(f"batch: {sentence}", file=sys.stderr)
    sys.stderr.flush()
    os._exit(1)
