#!/usr/bin/python3
"""The numbers are the shell's, and what Python knows of the tools is what they say."""
import inspect
import io
import json
import subprocess
import warnings

import support
from support import DATA, STEEL, STEEL_WORDS, SURFACE, SURFACE_WORDS, other_reader, shell

import numpy
import asperity as asp
from asperity import _encode, _options

PRESSED = f"asperity-generate {SURFACE_WORDS} | asperity-contact {STEEL_WORDS}"
DEPTHS = "0:0.2mm:8"


class SameBits(support.TestCase):
    def test_a_surface_is_the_shells(self):
        self.assert_same_bits(asp.generate(**SURFACE), shell(f"asperity-generate {SURFACE_WORDS}")[0])

    def test_a_pipe_is_the_shells_whether_the_surface_is_drawn_before_it_or_in_it(self):
        expected = shell(f"{PRESSED} 2>/dev/null | asperity-stress --depths {DEPTHS} 2>/dev/null")[0]
        with self.assertWarns(asp.ToolWarning):
            one = asp.pipe(asp.generate(**SURFACE), asp.contact(**STEEL), asp.stress(depths=DEPTHS))
        with self.assertWarns(asp.ToolWarning):
            other = asp.pipe(asp.stage.generate(**SURFACE), asp.contact(**STEEL), asp.stress(depths=DEPTHS))
        self.assert_same_bits(one, expected)
        self.assert_same_bits(other, expected)

    def test_a_table_is_the_shells(self):
        rows = shell(f"asperity-generate {SURFACE_WORDS} | asperity-stats --parameters all")[0].decode().splitlines()
        table = asp.stats(asp.generate(**SURFACE), parameters="all")
        self.assertEqual(len(table), len(rows) - 1)
        for row in rows[1:]:
            name, *numbers, unit, meaning = row.split("\t")
            numpy.testing.assert_array_equal(table.loc[name, list(table.columns[:4])].astype(float),
                                             [float(n) for n in numbers], name)
            self.assertEqual((table.loc[name, "unit"], table.loc[name, "meaning"]), (unit, meaning))

    def test_a_comparison_is_a_table_of_two_surfaces(self):
        one, other = (asp.generate(**{**SURFACE, "seed": seed}) for seed in (7, 8))
        table = asp.stats([one, other], compare=True)
        self.assertEqual(table.loc["Sq", "first"], asp.stats(one).loc["Sq", "value"])
        self.assertEqual(table.loc["Sq", "others"], asp.stats(other).loc["Sq", "value"])
        self.assertEqual((table.loc["Sq", "verdict"], table.loc["N", "verdict"]), ("agrees", "unknown"))

    def test_an_ensemble_is_the_shells_however_many_processes_draw_it(self):
        for processes in (1, 3):
            drawn = list(asp.ensemble(**SURFACE, count=3, first=2, processes=processes))
            for k, surface in enumerate(drawn, 2):
                words = SURFACE_WORDS.replace("--seed 7", f"--first {k} --seed 7")
                self.assert_same_bits(surface, shell(f"asperity-generate {words}")[0])

    # The table of asperity.acf(taper=True) has all that twins are drawn with.
    def test_twins_are_the_shells_whatever_the_map_comes_as(self):
        map_of_file = str(DATA / "profiler-96x96.x3p")
        shells = other_reader(shell(f"asperity-generate --like {map_of_file} --remove-form plane --seed 1")[0])[0]
        read = asp.convert(map_of_file)
        array = asp.dataset(read.heights.values, size=asp.si((read.x.length, read.y.length)))
        warnings.simplefilter("ignore", asp.errors.ToolWarning)  # a map of few waves
        for one in (map_of_file, DATA / "profiler-96x96.x3p", (DATA / "profiler-96x96.x3p").read_bytes(), read,
                    read.heights, read.heights.transpose("y", "x"), array):
            twin = asp.generate(like=one, remove_form="plane", seed=1)
            self.assertEqual(twin.heights.values.tobytes(), shells["heights"][0].astype("f8").tobytes())
        level = asp.generate(**SURFACE)
        twin = asp.generate(like=level, seed=1)
        for again in (asp.generate(acf=asp.acf(level, taper=True), seed=1),
                      asp.pipe(level, asp.acf(taper=True), asp.stage.generate(acf="-", seed=1)),
                      next(asp.ensemble(like=level, seed=1, count=2))):
            self.assertEqual(again.heights.values.tobytes(), twin.heights.values.tobytes())

    def test_a_number_is_the_quantity_in_si(self):
        one = asp.generate(**{**SURFACE, "size": asp.si((1e-3, 6e-4)), "rq": asp.si(numpy.float64(4e-7)),
                              "length": asp.si(5e-5)})
        other = asp.generate(**{**SURFACE, "size": "1e-3m,6e-4m", "rq": "4e-7m", "length": "5e-5m"})
        self.assertEqual(one.heights.values.tobytes(), other.heights.values.tobytes())

    def test_a_mean_pressure_is_the_load_over_the_surface(self):
        flats = dict(smooth=True, shape=(32, 24), size="1mm,0.6mm", boundary="periodic", young="208GPa", poisson=0.3)
        for pressure in ("50MPa", asp.si(5e7)):
            self.assertAlmostEqual(asp.contact(**flats, mean_pressure=pressure).contact_load / (5e7 * 1e-3 * 0.6e-3), 1, 11)

    def test_a_dataset_that_comes_back_is_the_one_that_went(self):
        surface = asp.generate(**SURFACE)
        back = asp.convert(surface, no_history=True)
        self.assertTrue(surface.identical(back))
        # The other reader understands what is written, too.
        raw = b"".join(_encode.encoded(surface))
        self.assert_same_bits(surface, raw)
        with support.xarray.open_dataset(io.BytesIO(raw), engine="scipy") as seen:
            self.assertTrue(seen.equals(surface))


class OneTable(support.TestCase):
    def test_every_tool_is_a_function_and_every_option_of_its_help_a_parameter(self):
        listed = [line.split()[1] for line in shell("asperity")[0].decode().splitlines() if line.startswith("  asp")]
        self.assertLessEqual(set(listed), set(dir(asp)))
        for tool in listed:
            parameters = inspect.signature(getattr(asp, tool)).parameters
            text = subprocess.run([f"asperity-{tool}", "--help"], capture_output=True, text=True).stdout
            for line in text.partition("\nAccuracy:")[0].splitlines():
                if line.startswith("  -"):
                    name = next(w for w in line.replace(",", " ").split() if w.startswith("--")) if "--" in line else "-h"
                    self.assert_known(tool, name.lstrip("-"), parameters)

    def assert_known(self, tool, option, parameters):
        left_out = ("h", "help", "man", "completion", "describe", "version", "dump-config", "quiet", "json",
                    "table")
        self.assertEqual(_options.python_name(option) in parameters, option not in left_out, f"{tool} --{option}")

    def test_documentation_has_the_text_of_each_option_and_the_unit_of_a_number(self):
        text = asp.contact.__doc__
        about = json.loads(shell("asperity-contact --describe")[0])
        for option in about["options"]:
            if option["names"] and not option["prints"] and option["name"] not in ("quiet", "json", "table"):
                self.assertIn(option["text"], text)
        self.assertIn("load : QUANTITY, a number of asperity.si is in N\n", text)
        self.assertIn("yield_ : A[,B], a number of asperity.si is in Pa\n", text)
        self.assertIn("radius : A[,B], a number of asperity.si is in m\n", text)
        self.assertIn("poisson : A[,B]\n", text)


if __name__ == "__main__":
    support.main()
