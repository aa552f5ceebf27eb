"""What can go wrong."""

from __future__ import annotations

from typing import TYPE_CHECKING, List

if TYPE_CHECKING:
    from ._compiler import Diagnostic


class TaskError(Exception):
    """A task has mistakes. `diagnostics` holds them as data, warnings too."""

    def __init__(self, diagnostics: "List[Diagnostic]"):
        self.diagnostics = diagnostics
        super().__init__("\n".join(str(each) for each in diagnostics if each.severity == "error"))


class CompilerError(Exception):
    """taskc could not be found or run, or could not read or write a file."""


class HostError(Exception):
    """libtaskc refuses something. `status` is its code: TASKC_ERROR_UNKNOWN_NAME, say, is 6."""

    def __init__(self, status: int, message: str):
        self.status = status
        super().__init__(message)
