"""What can go wrong with a tool, as exceptions: the tool's own line and its exit status."""
import errno
import os
from typing import Any

NOT_THERE = ": " + os.strerror(errno.ENOENT)  # at the end of a line


class ToolError(RuntimeError):
    """A tool failed. `line` is what it printed, `tool` its name, `status` its exit status: 1, input or output
    failed; 127, the tool is not there; negative, a signal ended it."""

    def __init__(self, line: str, tool: str = "", status: int = 1, result: Any = None):
        super().__init__(line, tool, status, result)
        self.line, self.tool, self.status, self.result = line, tool, status, result

    def __str__(self):
        return self.line


class NoFile(ToolError, FileNotFoundError):
    """A file, or the folder that it would be written into, is not there; `filename` is its name."""

    def __init__(self, line: str, *rest: Any):
        super().__init__(line, *rest)
        self.errno, self.strerror = errno.ENOENT, os.strerror(errno.ENOENT)
        self.filename = line.removesuffix(NOT_THERE).rpartition(": ")[2]


class UsageError(ToolError, ValueError):
    """An option is wrong or missing (2)."""


class NotConverged(ToolError):
    """A solver has not converged (3). `dataset` is its best result, or the table of a tool that prints one."""

    @property
    def dataset(self) -> Any:
        return self.result


class BadData(ToolError, ValueError):
    """The input is unusable (4)."""


class ToolWarning(UserWarning):
    """A tool warned."""


OF_STATUS = {2: UsageError, 3: NotConverged, 4: BadData}


def kind_of(line, status):
    """Of the exception for a tool's last line and its exit status."""
    return NoFile if line.endswith(NOT_THERE) and status != 3 else OF_STATUS.get(status, ToolError)


def brief(value):
    """A value in a message, on one line."""
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else f"<{type(value).__name__}>"
