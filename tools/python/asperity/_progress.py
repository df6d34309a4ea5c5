"""The tools' own lines of progress, in a terminal or below a cell of a notebook, for runs beyond half a second."""
import sys
import time

DELAY, PERIOD = 0.5, 0.1  # seconds: before the first line, between two


def in_notebook():
    ipython = sys.modules.get("IPython")
    return ipython is not None and hasattr(ipython.get_ipython(), "kernel")


def wanted(stages):
    """Whether a line is to be shown. The tools' option progress has the last word."""
    asked = {stage.options.get("progress") for stage in stages}
    seen = in_notebook() or bool(sys.stderr and sys.stderr.isatty())
    return "always" in asked or "never" not in asked and seen


class Line:
    """One line that is drawn again and again, and gone at the end. Of several tools one at a time has it."""

    def __init__(self, shown):
        self.shown, self.begin, self.holder, self.next = shown, time.monotonic(), None, 0
        self.width, self.displayed = 0, False  # of what is drawn; whether a notebook has a place for it

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.clear()

    def show(self, holder, text):
        if not self.shown or self.holder not in (None, holder):
            return
        self.holder = holder if text else None
        now = time.monotonic()
        if now >= max(self.next, self.begin + DELAY):
            self.next = now + PERIOD
            self._draw(text)

    def print(self, lines):
        """Lines that stay."""
        if lines and sys.stderr:
            self.clear()
            sys.stderr.write("\n".join(lines) + "\n")

    def clear(self):
        self._draw("")

    def _draw(self, text):
        if self.width or text:
            (_draw_in_notebook if in_notebook() else _draw_in_terminal)(self, text)
        self.width = len(text)


def _draw_in_terminal(line, text):
    if sys.stderr:
        sys.stderr.write("\r" + text.ljust(line.width) + ("" if text else "\r"))
        sys.stderr.flush()


def _draw_in_notebook(line, text):
    from IPython.display import display, update_display
    show, line.displayed = update_display if line.displayed else display, True
    show({"text/plain": text}, raw=True, display_id=f"asperity-{id(line)}")
