"""What can go wrong with a tool, as exceptions: the tool's own line and its exit status."""


class ToolError(RuntimeError):
    """A tool failed. `line` is what it printed, `tool` its name, `status` its exit status: 1, input or output
    failed; 127, the tool is not there; negative, a signal ended it."""

    def __init__(self, line, tool="", status=1, result=None):
        super().__init__(line, tool, status, result)
        self.line, self.tool, self.status, self.result = line, tool, status, result

    def __str__(self):
        return self.line


class UsageError(ToolError, ValueError):
    """An option is wrong or missing (2)."""


class NotConverged(ToolError):
    """A solver has not converged (3). `dataset` is its best result, or the table of a tool that prints one."""

    @property
    def dataset(self):
        return self.result


class BadData(ToolError, ValueError):
    """The input is unusable (4)."""


class ToolWarning(UserWarning):
    """A tool warned."""


OF_STATUS = {2: UsageError, 3: NotConverged, 4: BadData}


def brief(value):
    """A value in a message, on one line."""
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else f"<{type(value).__name__}>"
