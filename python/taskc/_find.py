"""Where the program `taskc`, the libraries and the tasks that come with them are."""

from __future__ import annotations

import os
import shutil
import sysconfig
from pathlib import Path
from typing import Iterator, List, Optional

from ._abi import ABI_VERSION
from ._errors import CompilerError


def _prefixes() -> Iterator[Path]:
    home = os.environ.get("TASKC_HOME")
    if home:
        yield Path(home)
        return
    package = Path(__file__).resolve().parent
    if package.parent.name == "python" and package.parent.parent.name == "taskc":
        yield package.parents[3]  # PREFIX/share/taskc/python/taskc
    found = shutil.which("taskc")
    if found:
        yield Path(found).resolve().parent.parent


def find_program() -> str:
    """The path of `taskc`."""
    for prefix in _prefixes():
        program = prefix / "bin" / "taskc"
        if program.is_file():
            return str(program)
    raise CompilerError(
        "there is no program `taskc`: put it into PATH, or set TASKC_HOME to the folder that it was "
        "installed to, with bin/ and lib/ in it"
    )


def _beside_program(file: str) -> Optional[Path]:
    folders = ["lib", "lib64"]
    multiarch = sysconfig.get_config_var("MULTIARCH")
    if multiarch:
        folders.append(f"lib/{multiarch}")
    for prefix in _prefixes():
        for folder in folders:
            library = prefix / folder / file
            if library.is_file():
                return library
    return None


def find_library(name: str) -> str:
    """The path of a library, "libtaskc", or the file's name by which the system may know it."""
    file = f"{name}.so.{ABI_VERSION}"
    beside = _beside_program(file)
    return file if beside is None else str(beside)


def shared_task(name: str) -> Optional[Path]:
    """The file of a task that comes with taskc, by its name; None where there is none."""
    for prefix in _prefixes():
        file = prefix / "share" / "taskc" / "tasks" / f"{name}.task"
        if file.is_file():
            return file
    return None


def shared_task_names() -> List[str]:
    return sorted({file.stem for prefix in _prefixes()
                   for file in (prefix / "share" / "taskc" / "tasks").glob("*.task")})
