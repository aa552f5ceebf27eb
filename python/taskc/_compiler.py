"""The program `taskc`, and what it says of a task."""

from __future__ import annotations

import json
import os
import subprocess
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Tuple

from ._errors import CompilerError, TaskError
from ._find import find_program


@dataclass(frozen=True)
class _TextAt:
    """A text that belongs to a place of a file. The end is exclusive."""

    file: str
    line: int
    column: int
    end_line: int
    end_column: int
    text: str


class Label(_TextAt):
    """Something to be seen elsewhere: "first declared here"."""


class Fix(_TextAt):
    """What to put in the place of what stands there."""


@dataclass(frozen=True)
class Diagnostic:
    """A mistake in a task or a warning; `taskc explain CODE` says more."""

    severity: str  # "error" or "warning"
    code: str
    message: str
    file: str
    line: int
    column: int
    end_line: int
    end_column: int
    note: str
    help: str
    fixes: Tuple[Fix, ...]
    labels: Tuple[Label, ...]

    def __str__(self) -> str:
        text = f"{self.file}:{self.line}:{self.column}: {self.severity}[{self.code}]: {self.message}"
        for remark, words in (("note", self.note), ("help", self.help)):
            if words:
                text += f"\n  {remark}: {words}"
        return text


def _made(kind: Any, data: Dict[str, Any], **parts: Any) -> Any:
    """Of what the report says, that which this version knows."""
    known = {name: data[name] for name in kind.__dataclass_fields__ if name not in parts}
    return kind(**known, **parts)


def _diagnostic(data: Dict[str, Any]) -> Diagnostic:
    return _made(Diagnostic, data, fixes=tuple(_made(Fix, each) for each in data["fixes"]),
                 labels=tuple(_made(Label, each) for each in data["labels"]))


def build(task: "os.PathLike[str] | str",
          robots: "Optional[os.PathLike[str] | str]" = None) -> "Tuple[str, List[Diagnostic]]":
    """The path of the task's plugin, in taskc's cache, and its warnings.

    Raises TaskError for a task with mistakes, CompilerError where taskc cannot do its work.
    """
    command = [find_program(), "build", os.fspath(task), "--json"]
    if robots is not None:
        command += ["--robots", os.fspath(robots)]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        report = json.loads(done.stdout)
    except ValueError:
        raise CompilerError(f"{command[0]}: {done.stderr.strip() or 'gives no report'}") from None
    diagnostics = [_diagnostic(each) for each in report["diagnostics"]]
    if any(each.severity == "error" for each in diagnostics):
        raise TaskError(diagnostics)
    if report["failures"] or done.returncode != 0:
        raise CompilerError("\n".join(report["failures"]) or done.stderr.strip())
    return report["tasks"][0]["plugin"], diagnostics
