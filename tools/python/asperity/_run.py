"""Runs of tools: one process, or several in a pipe.

One loop serves all pipes of a run: it feeds the first tool, reads what the last one writes, and hears what each of
them says. Data besides standard input is a file in memory without a name. Nothing waits for anything else, nothing
is on a disk, and an exception, of whatever kind, ends all processes of the run.
"""
import contextlib
import errno
import fcntl
import os
import re
import selectors
import signal
import subprocess
import time

from . import _progress, _results
from .errors import ToolError, kind_of

PIPE_BYTES = 1 << 20
PATIENCE = 2  # seconds between asking a process to end and ending it
FIRST_ANSWER = 5  # the least exit status that is an answer and no failure
FILE_IN_MEMORY = re.compile(r"/proc/self/fd/\d+")
PROGRESS = re.compile(r"\r([^\r\n\x1b]*)\x1b\[K")


class Said:
    """What a tool prints on standard error: its lines, and its last line of progress."""

    def __init__(self):
        self.lines, self.progress, self._rest = [], "", ""

    def hear(self, raw):
        """The whole lines that the bytes end."""
        text = self._rest + raw.decode(errors="replace")
        for self.progress in PROGRESS.findall(text):
            pass
        *whole, self._rest = PROGRESS.sub("", text).split("\n")
        if not raw:
            whole, self._rest = [*whole, self._rest], ""
        whole = [line for line in whole if line.strip()]
        self.lines += whole
        return whole


class Run:
    """`stages` in a pipe, the first of which is fed with a source, if there is one."""

    def __init__(self, stages, feed=None, shown=None, environment=None):
        self.stages, self.feed = stages, feed
        self.shown = _progress.wanted(stages) if shown is None else shown
        self.environment = dict(os.environ, **(environment or {}))
        if self.shown:
            self.environment.update({f"ASPERITY_{s.name.upper()}_PROGRESS": "always" for s in stages})
        self.processes, self.said, self.files = [], [Said() for _ in stages], {}
        self.stopped, self.ended = False, set()  # numbers of tools that were ended because a later one had failed

    def execute(self):
        """An Outcome."""
        try:
            with contextlib.ExitStack() as ends:
                self._start(ends)
                written = self._serve()
        finally:
            self._end()
        return _results.Outcome(self, written)

    def stop(self):
        """Ends the run, from another thread too."""
        self.stopped = True
        for process in list(self.processes):
            process.terminate()

    # ---- processes ----

    def _start(self, ends):
        before = subprocess.PIPE if self.feed else subprocess.DEVNULL
        for stage in self.stages:
            with contextlib.ExitStack() as files:
                process = self._popen(stage, files, before)
            self.processes.append(process)
            if before not in (subprocess.PIPE, subprocess.DEVNULL):
                before.close()  # the process alone reads it now
            for end in filter(None, (process.stdin, process.stdout, process.stderr)):
                ends.callback(end.close)
                with contextlib.suppress(OSError):  # where pipes may not be so long
                    fcntl.fcntl(end.fileno(), fcntl.F_SETPIPE_SZ, PIPE_BYTES)
            before = process.stdout
            if self.stopped:
                process.terminate()

    def _popen(self, stage, files, before):
        words = [stage.path]
        descriptors = []
        for word in stage.words:
            if not isinstance(word, str):
                own = _in_memory(word, files)
                same = [d for d in descriptors if _same(d, own)]
                descriptors += same[:1] or [own]
                path = f"/proc/self/fd/{descriptors[-1]}"
                self.files[path], word = self.files[path] if same else word.name, path
            words.append(word)
        try:
            return subprocess.Popen(words, stdin=before, stdout=subprocess.PIPE, stderr=subprocess.PIPE, bufsize=0,
                                    pass_fds=descriptors, env=self.environment)
        except OSError as error:
            hint = ": the arguments are too long, name a file" if error.errno == errno.E2BIG else ""
            raise ToolError(f"{stage.tool}: {error.strerror}{hint}", stage.tool, 127) from None

    def _end(self):
        for process in self.processes:
            if process.poll() is None:
                process.terminate()
        end = time.monotonic() + PATIENCE
        for process in self.processes:
            try:
                process.wait(max(0, end - time.monotonic()))
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    # ---- pipes ----

    def _serve(self):
        """Until every pipe is closed."""
        written = _results.Written()
        with selectors.DefaultSelector() as waiting, _progress.Line(self.shown) as line:
            def serve(end, event, what):
                os.set_blocking(end.fileno(), False)
                waiting.register(end, event, what)

            if self.feed:
                feeder = self._feeder()
                next(feeder)
                serve(self.processes[0].stdin, selectors.EVENT_WRITE, feeder.send)
            serve(self.processes[-1].stdout, selectors.EVENT_READ, written.read)
            for number, process in enumerate(self.processes):
                serve(process.stderr, selectors.EVENT_READ, self._listener(number, line))
            while waiting.get_map():
                for key, _ in waiting.select():
                    if not key.data(key.fd):
                        waiting.unregister(key.fileobj)
                        key.fileobj.close()
            for process in self.processes:
                process.wait()
        return written

    def _feeder(self):
        """Writes what the pipe takes, whenever its descriptor is sent; yields whether there is more."""
        descriptor = yield
        for piece in self.feed.pieces():
            left = memoryview(piece)
            while left:
                try:
                    left = left[os.write(descriptor, left):]
                except BlockingIOError:
                    descriptor = yield True
                except BrokenPipeError:  # the tool has ended, and tells why
                    yield False
        yield False

    def _listener(self, number, line):
        stage, said = self.stages[number], self.said[number]

        def listen(descriptor):
            raw = os.read(descriptor, 1 << 16)
            lines = said.hear(raw)
            if stage.prints_steps:
                line.print(lines)
            line.show(number, said.progress)
            if not raw:
                self._end_before(number)
            return bool(raw)
        return listen

    def _end_before(self, number):
        """Nobody reads what the tools before one that failed would write."""
        with contextlib.suppress(subprocess.TimeoutExpired):
            if failed(self.processes[number].wait(PATIENCE)):
                for before in range(number):
                    if self.processes[before].poll() is None:
                        self.ended.add(before)
                        self.processes[before].terminate()

    # ---- what went wrong ----

    def named(self, text):
        """A text with the names of the data in place of files in memory."""
        return FILE_IN_MEMORY.sub(lambda path: self.files.get(path[0], path[0]), text) if self.files else text

    def warnings(self, number):
        """What a tool warned of."""
        mark = f"{self.stages[number].tool}: warning: "
        return [self.named(line.removeprefix(mark)) for line in self.said[number].lines if line.startswith(mark)]

    def notes(self, number):
        """The other lines of a tool."""
        mark = f"{self.stages[number].tool}: warning: "
        return [self.named(line) for line in self.said[number].lines if not line.startswith(mark)]

    def failure(self, written):
        """The exception, or None: of the first tool that failed by itself, not because its reader had ended."""
        codes = [process.returncode for process in self.processes]
        for number, code in enumerate(codes):
            if failed(code) and number not in self.ended:
                return self._error(number, code, None)
        if written.broken:
            return ToolError(f"{self.stages[-1].tool}: {written.broken}", self.stages[-1].tool, codes[-1])
        return self._error(codes.index(3), 3, written.result(self)) if 3 in codes else None

    def _error(self, number, code, result):
        tool = self.stages[number].tool
        own = self.notes(number) or list(map(self.named, self.said[number].lines))
        line = own[-1] if own else f"{tool}: ended with {code}"
        if code < 0:
            line = f"{tool}: ended by {signal.Signals(-code).name}"
        return kind_of(line, code)(line, tool, code, result)


def failed(code):
    """Whether a tool ended without a result, and not because nobody read it."""
    return code not in (0, 3, -signal.SIGPIPE) and code < FIRST_ANSWER


def _same(one, other):
    """Whether two files in memory hold the same bytes: they are one file to the tool, which may want different ones."""
    size = os.fstat(other).st_size
    return os.fstat(one).st_size == size and all(os.pread(one, PIPE_BYTES, at) == os.pread(other, PIPE_BYTES, at)
                                                 for at in range(0, size, PIPE_BYTES))


def _in_memory(source, files):
    """A descriptor of a file without a name, which holds the data."""
    descriptor = os.memfd_create("asperity")  # not its own name, which may be too long
    files.callback(os.close, descriptor)
    for piece in source.pieces():
        left = memoryview(piece)
        while left:
            left = left[os.write(descriptor, left):]
    return descriptor
