"""What a tool writes: a dataset, a table, a picture, a page, or the bytes of another program's file."""
import html
import logging
import os
import re
import struct
import sys
import warnings

from .errors import ToolWarning

MEDIA = {rb"\x89PNG": "image/png", rb"%PDF": "application/pdf", rb"(?i)<!DOCTYPE html": "text/html",
         rb"(?s)(<\?xml.{0,200})?<svg": "image/svg+xml"}
BROKEN = (EOFError, ValueError, KeyError, IndexError, struct.error)


class Document(bytes):
    """A picture or a page, which a notebook shows. `media` is its type; save(name) writes it to a file."""

    media = "application/octet-stream"

    def save(self, name):
        with open(name, "wb") as file:
            file.write(self)

    def __repr__(self):
        return f"<{self.media}, {len(self)} bytes>"

    __str__ = __repr__  # that of bytes prints them all

    def _repr_mimebundle_(self, include=None, exclude=None):
        shown = self.decode() if self.media.startswith(("text", "image/svg")) else bytes(self)
        if self.media == "text/html":
            shown = f'<iframe srcdoc="{html.escape(shown)}" width="100%" height="600"></iframe>'
        return {self.media: shown, "text/plain": repr(self)}


class Written:
    """Takes the bytes as they come; those of a dataset go into its arrays at once."""

    def __init__(self):
        self.pieces, self.decoder, self.target, self.dataset, self.broken = [], None, None, None, ""

    def read(self, descriptor):
        """Reads what is there; False at the end."""
        if self.target is not None:
            return self._decode(os.readv(descriptor, [self.target]))
        piece = os.read(descriptor, 1 << 16)
        if self.decoder and piece:
            self.broken = "bytes follow the dataset"
        self.pieces.append(piece)
        if not self.decoder and len(self.pieces[0]) + len(piece) >= 4:
            first = b"".join(self.pieces[:2])
            if first.startswith(b"CDF") and len(self.pieces) <= 2:
                from . import _decode
                self.decoder, self.pieces = _decode.decoder(first), []
                return self._decode(None)
        return bool(piece)

    def _decode(self, count):
        try:
            self.target = self.decoder.send(count)
        except StopIteration as end:
            self.dataset, self.target = end.value, None
        except BROKEN as error:
            self.broken, self.target = str(error), None
            return False
        return True

    def result(self, run):
        if self.dataset is not None and "history" in self.dataset.attrs:
            self.dataset.attrs["history"] = run.named(str(self.dataset.attrs["history"]))
        raw = b"".join(self.pieces)
        if self.decoder or not raw:
            return self.dataset
        out = _table(raw, run) if run.stages[-1].prints_tables else _document(raw)
        return raw if out is None else out


class Outcome:
    """A run that has ended. Its result is delivered in the caller's thread, with warnings, or as an exception."""

    def __init__(self, run, written):
        self.run, self.written = run, written

    def deliver(self):
        error = self.run.failure(self.written)
        self._tell()
        if error:
            raise error
        return self.written.result(self.run)

    def _tell(self):
        for number, stage in enumerate(self.run.stages):
            for text in self.run.warnings(number):
                warnings.warn(f"{stage.tool}: {text}", ToolWarning, stacklevel=_calls_above())
            for note in self.run.notes(number):
                logging.getLogger("asperity").info(note)


def _calls_above():
    """The stacklevel of the first caller outside of this module."""
    level, frame, own = 1, sys._getframe(1), os.path.dirname(__file__)
    while frame and os.path.dirname(frame.f_code.co_filename) == own:
        level, frame = level + 1, frame.f_back
    return level


def _document(raw):
    for mark, media in MEDIA.items():
        if re.match(mark, raw):
            out = Document(raw)
            out.media = media
            return out
    return None


# ---- tables: a header '# name [unit]  …', then rows ----


def _table(raw, run):
    if not raw.startswith(b"# "):
        return None
    head, *rows = raw.decode().rstrip("\n").split("\n")
    names, units = zip(*map(_column, head[2:].split("\t")))
    columns = list(zip(*(row.split("\t") for row in rows))) or [()] * len(names)
    values = {n: list(map(run.named, c)) if u is None else [float(v.removeprefix("<")) for v in c]
              for n, u, c in zip(names, units, columns)}
    for name, unit, column in zip(names, units, columns):  # "<" stands before what the quantity is below
        if unit is not None and any(v.startswith("<") for v in column):
            values[f"{name}_is_bound"] = [v.startswith("<") for v in column]
    units = {n: u for n, u in zip(names, units) if u is not None}
    first = names[0]
    key = first if first not in units and len(set(values[first])) == len(values[first]) else None
    try:
        import pandas
    except ImportError:
        return _as_dict(values, key)
    out = pandas.DataFrame(values)
    out.attrs = {"units": units, "tool": run.stages[-1].tool}
    if told := run.warnings(-1):
        out.attrs["warnings"] = told
    return out.set_index(key) if key else out


def _column(head):
    """A column of numbers is headed by its name and [unit], one of words by its name alone."""
    name, bracket, unit = head.partition(" [")
    return name, unit.rstrip("]") if bracket else None


def _as_dict(values, key):
    """{'Sq': {'value': …, 'unit': …}, …}; columns where none of words names the rows."""
    others = [name for name in values if name != key]
    rows = range(len(values[others[0]]))
    return {values[key][row]: {n: values[n][row] for n in others} for row in rows} if key else values
