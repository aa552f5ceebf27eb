"""Where the program `taskc` and the library libtaskc are."""

from __future__ import annotations

import os
import shutil
import sysconfig
from pathlib import Path
from typing import Iterator, Optional

from ._abi import ABI_VERSION
from ._errors import CompilerError

LIBRARY = f"libtaskc.so.{ABI_VERSION}"


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


def _beside_program() -> Optional[Path]:
    folders = ["lib", "lib64"]
    multiarch = sysconfig.get_config_var("MULTIARCH")
    if multiarch:
        folders.append(f"lib/{multiarch}")
    for prefix in _prefixes():
        for folder in folders:
            library = prefix / folder / LIBRARY
            if library.is_file():
                return library
    return None


def find_library() -> str:
    """The path of libtaskc, or the name by which the system may know it."""
    beside = _beside_program()
    return LIBRARY if beside is None else str(beside)
