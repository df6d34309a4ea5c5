#!/usr/bin/python3
"""However a run ends, it is told in one line, and no process, open file or temporary file is left."""
import contextlib
import errno
import io
import logging
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import unittest.mock
import warnings

import support
from support import STEEL, SURFACE

import numpy
import asperity as asp
from asperity._run import Run
from asperity._stage import in_a_pipe

LONG = dict(shape=(512, 512), size="3mm", rq="0.4um", length="17px", seed=7)
PRESS = dict(young="208GPa", poisson=0.3, load="50N")
ENDLESS = dict(young="208GPa", poisson=0.3, sweep="1N:100N:5000")  # hours


@contextlib.contextmanager
def alarm(seconds):
    """Ctrl-C after a while, unless all is over before."""
    timer = threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


class Errors(support.TestCase):
    def test_exceptions_have_the_tools_line_and_status(self):
        for options, kind, status, line in (
                (dict(), asp.UsageError, 2, "asperity-contact: --young is required"),
                (dict(PRESS, report="/nowhere/r.json"), asp.NoFile, 1,
                 "asperity-contact: /nowhere/r.json: No such file or directory")):
            with self.assertRaises(kind) as caught:
                asp.contact(asp.generate(**SURFACE), **options)
            self.assertEqual((str(caught.exception), caught.exception.status), (line, status))
            self.assertEqual((caught.exception.tool, caught.exception.line), ("asperity-contact", line))
            again = pickle.loads(pickle.dumps(caught.exception))
            self.assertEqual((type(again), str(again), again.status), (kind, line, status))
        self.assertRaisesRegex(asp.BadData, "^asperity-stats: heights is missing", asp.stats,
                               asp.generate(**SURFACE).drop_vars("heights"))

    def test_a_file_that_is_not_there_is_pythons_error(self):
        surface = asp.generate(**SURFACE)
        for call, name in ((lambda: asp.stats("nowhere.nc"), "nowhere.nc"),
                           (lambda: asp.contact(surface, **STEEL, counter=pathlib.Path("/no/where.nc")), "/no/where.nc"),
                           (lambda: asp.generate(**SURFACE, output="/no/where.nc"), "/no/where.nc")):
            with self.assertRaises(FileNotFoundError) as caught:
                call()
            again = pickle.loads(pickle.dumps(caught.exception))
            for error in (caught.exception, again):
                self.assertIsInstance(error, asp.ToolError)
                self.assertEqual((error.filename, error.errno), (name, errno.ENOENT))
                self.assertRegex(str(error), f"^asperity-.*{name}: No such file or directory$")

    def test_a_solver_that_does_not_converge_gives_its_best_and_the_pipe_goes_on(self):
        warnings.simplefilter("ignore", asp.ToolWarning)
        for run in (lambda: asp.contact(asp.generate(**SURFACE), **STEEL, max_convolutions=3),
                    lambda: asp.pipe(asp.stage.generate(**SURFACE), asp.contact(**STEEL, max_convolutions=3),
                                     asp.stress(maximum=True))):
            with self.assertRaisesRegex(asp.NotConverged, "^asperity-contact: ") as caught:
                run()
            self.assertEqual((caught.exception.status, caught.exception.dataset.contact_converged), (3, 0))

    def test_a_tool_is_ended_when_the_one_that_reads_it_has_failed(self):
        run = Run(*in_a_pipe([asp.stage.contact(asp.generate(**LONG), **ENDLESS),
                              asp.stress(poisson="little", maximum=True)]))
        self.assertRaisesRegex(asp.UsageError, "^asperity-stress: --poisson", run.execute().deliver)
        self.assertEqual(run.ended, {0})

    def test_the_tool_that_failed_is_named_not_the_one_that_it_starved_or_deafened(self):
        flat = asp.dataset(numpy.zeros((1500, 1500)), size="3mm")
        self.assertRaisesRegex(asp.UsageError, "^asperity-contact: --young", asp.contact, flat, young="much")
        self.assertRaisesRegex(asp.UsageError, "^asperity-stress: --poisson", asp.pipe, flat, asp.contact(**PRESS),
                               asp.stress(poisson="little", maximum=True))
        self.assertRaisesRegex(asp.UsageError, "^asperity-generate: --rq", asp.pipe,
                               asp.stage.generate(**dict(SURFACE, rq="1")), asp.contact(**STEEL))

    def test_an_answer_is_no_error(self):
        table = asp.validate(asp.generate(**SURFACE), rq="2um")
        self.assertIn("differs", set(table.verdict))

    def test_warnings_point_at_the_caller_and_notes_are_logged(self):
        with self.assertWarnsRegex(asp.ToolWarning, "^asperity-contact: the contact has") as told:
            asp.contact(asp.generate(**dict(SURFACE, shape=(8, 8), length="200um")), **STEEL)
        self.assertEqual(told.filename, __file__)
        with self.assertLogs("asperity", logging.INFO) as log:
            asp.filter(asp.generate(**SURFACE), scale=2)
        self.assertIn("dropped results", log.output[0])

    def test_a_tool_that_is_not_there_is_told_in_one_line(self):
        surface = asp.generate(**SURFACE)
        stats = asp.stats
        with unittest.mock.patch.dict(os.environ, PATH="/nowhere"):
            with self.assertRaisesRegex(asp.ToolError, "^asperity-stats is not on PATH: install") as caught:
                stats(surface)
            self.assertEqual(caught.exception.status, 127)
            self.assertEqual([name for name in dir(asp) if name == "stats"], [])
            self.assertRaisesRegex(AttributeError, "asperity-stats is not on PATH", lambda: asp.stats)
        self.assertRaisesRegex(AttributeError, "no function 'genrate': did you mean 'generate'?", lambda: asp.genrate)

    def test_a_tool_that_a_signal_ends_or_that_writes_half_a_dataset_is_told(self):
        for script, line in (("kill -9 $$", "^asperity-odd: ended by SIGKILL$"),
                             ("printf 'CDF\\002abc'", "^asperity-odd: the dataset is cut short$"),
                             ("echo >&2 'asperity-odd: warning: low'; exit 1", "^asperity-odd: warning: low$"),
                             ("exit 1", "^asperity-odd: ended with 1$")):
            with tempfile.TemporaryDirectory() as folder:
                tool = pathlib.Path(folder, "asperity-odd")
                tool.write_text(f"#!/bin/sh\n[ \"$1\" != --describe ] || exec asperity-generate --describe\n{script}\n")
                tool.chmod(0o755)
                with unittest.mock.patch.dict(os.environ, PATH=f"{folder}:{os.environ['PATH']}"):
                    about = asp._options.table("odd")
                    about["tool"] = "asperity-odd"
                    warnings.simplefilter("ignore", asp.ToolWarning)
                    self.assertRaisesRegex(asp.ToolError, line, asp.odd)


class Interruptions(support.TestCase):
    def test_ctrl_c_ends_a_pipe_and_an_ensemble_at_once(self):
        surface = asp.generate(**LONG)
        for run in (lambda: asp.pipe(surface, asp.filter(scale=2), asp.contact(**ENDLESS)),
                    lambda: list(asp.ensemble(asp.stage.generate(**LONG), asp.contact(**ENDLESS), count=4))):
            with alarm(0.5):
                self.assertRaises(KeyboardInterrupt, run)

    def test_an_ensemble_that_is_left_ends_its_processes(self):
        members = asp.ensemble(asp.stage.generate(**LONG), count=50, processes=2)
        next(members)
        with unittest.mock.patch.object(Run, "stop", autospec=True, side_effect=Run.stop) as stop:
            members.close()
        self.assertEqual(stop.call_count, 2)

    def test_a_failing_member_ends_the_ensemble(self):
        self.assertRaisesRegex(asp.UsageError, "--rq", list, asp.ensemble(**dict(SURFACE, rq="1"), count=4))

    def test_an_error_in_the_data_ends_the_tool(self):
        surface = asp.generate(**SURFACE)
        surface["odd"] = ("w", numpy.zeros(3, complex))
        self.assertRaises(TypeError, asp.contact, surface, **STEEL)
        self.assertRaises(TypeError, asp.contact, asp.generate(**SURFACE), **STEEL, counter=surface)

    def test_threads_use_the_module_at_once(self):
        expected, found = {}, {}
        for seed in range(6):
            expected[seed] = asp.generate(**dict(SURFACE, seed=seed)).heights.values
        threads = [threading.Thread(target=lambda s=s: found.update({s: asp.stage.filter(scale=1)(
            asp.generate(**dict(SURFACE, seed=s))).heights.values})) for s in expected]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for seed, heights in expected.items():
            numpy.testing.assert_array_equal(found[seed], heights)

    def test_ensembles_have_their_own_seed_and_check_their_call(self):
        one, other = (next(asp.ensemble(**dict(SURFACE, seed=None), count=1)) for _ in range(2))
        self.assertNotEqual(one.generate_seed, other.generate_seed)
        for call in (dict(count=0), dict(count=2, first=-1), dict(count=2, processes=0)):
            self.assertRaises(ValueError, asp.ensemble, **SURFACE, **call)
        generate = asp.stage.generate(**SURFACE)
        for stages, options in (((generate.again(count=2),), {}), ((generate,), dict(seed=1)), ((generate,), SURFACE),
                                ((asp.contact(**STEEL),), {}), ((generate, one), {})):
            self.assertRaises(TypeError, asp.ensemble, *stages, **options, count=2)


class Progress(support.TestCase):
    def test_a_long_run_shows_the_tools_line_and_takes_it_back(self):
        warnings.simplefilter("ignore", asp.ToolWarning)
        shown = io.StringIO()
        surface = asp.generate(**LONG)
        with unittest.mock.patch.object(sys, "stderr", shown), \
                unittest.mock.patch("asperity._progress.DELAY", 0):
            pressed = asp.contact(surface, **PRESS, progress="always")
            lines = shown.getvalue().split("\r")
            asp.contact(surface, **PRESS)
        self.assertRegex(shown.getvalue(), r"\rasperity-contact: \[#*\.*\] +\d+ %  .*residual")
        self.assertEqual(lines[-2].strip(), "")
        self.assertEqual(shown.getvalue().split("\r"), lines)  # nothing where nobody looks
        self.assertNotIn("progress", pressed.history)

    def test_steps_and_times_are_printed_when_they_are_asked_for(self):
        shown = io.StringIO()
        with unittest.mock.patch.object(sys, "stderr", shown):
            asp.generate(**SURFACE, time=True)
        self.assertRegex(shown.getvalue(), r"asperity-generate: \S+ s, CPU")


class Without(support.TestCase):
    def test_without_pandas_a_table_is_a_dictionary(self):
        with unittest.mock.patch.dict(sys.modules, pandas=None):
            table = asp.stats(asp.generate(**SURFACE))
            columns = asp.acf(asp.generate(**SURFACE), result="profiles")
        self.assertEqual(set(table["Sq"]), {"value", "standard_error", "low_95", "high_95", "unit", "meaning"})
        self.assertEqual(columns["acf"][0], 1)

    def test_the_module_is_imported_without_numpy(self):
        code = "import sys; sys.path.insert(0, sys.argv[1]); import asperity; print('numpy' in sys.modules)"
        run = subprocess.run([sys.executable, "-W", "error", "-c", code, support.SOURCE / "tools/python"],
                             capture_output=True, text=True)
        self.assertEqual((run.stdout, run.stderr), ("False\n", ""))


if __name__ == "__main__":
    support.main()
