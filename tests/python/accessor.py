#!/usr/bin/python3
"""The accessor `asp` of datasets, the results that it shows, and functions, stages and results that are pickled."""
import concurrent.futures
import copy
import inspect
import math
import multiprocessing
import pickle
import subprocess
import sys
import warnings

import support
from support import STEEL, SURFACE

import numpy
import asperity as asp

FLATS = dict(young="208GPa", poisson=0.3, load="20N", add="grid_errors")
FINE = dict(shape=(64, 64), size="1mm", rq="0.4um", length="150um", model="gaussian", periodic=True, cutoff="8px", seed=7)


class Accessor(support.TestCase):
    def test_a_method_is_the_function_of_its_tool(self):
        surface = asp.generate(**SURFACE)
        self.assertTrue(surface.asp.stats().equals(asp.stats(surface)))
        other = asp.generate(**dict(SURFACE, seed=8))
        self.assertTrue(surface.asp.stats(other, compare=True).equals(asp.stats(surface, other, compare=True)))
        self.assertEqual(surface.asp.plot(), asp.plot(surface, kind="map"))
        self.assertEqual(surface.asp.contact.__doc__, asp.contact.__doc__)
        self.assertEqual(inspect.signature(surface.asp.contact), inspect.signature(asp.contact))
        self.assertEqual(list(inspect.signature(surface.asp.convert).parameters)[:2], ["from_", "channel"])
        self.assertRaisesRegex(TypeError, "did you mean 'radius'", surface.asp.contact, raduis="1m")
        self.assertRaisesRegex(AttributeError, "did you mean 'contact'", lambda: surface.asp.kontact)
        self.assertEqual(dir(surface.asp), sorted(n for n in dir(asp) if n in dir(asp.stage)))

    def test_a_field_is_what_its_method_works_on(self):
        pressed = asp.generate(**FINE).asp.contact(**FLATS)
        self.assertEqual(pressed.pressure.asp.stats().loc["Sq", "unit"], "Pa")
        self.assertEqual(pressed.pressure.asp.plot(), asp.plot(pressed, variable="pressure"))

    def test_a_result_has_its_value_error_unit_and_meaning(self):
        pressed = asp.generate(**FINE).asp.contact(**FLATS)
        area = pressed.asp.contact.area
        self.assertEqual(area, (pressed.contact_area, pressed.contact_area_error, "m2", "real contact area"))
        self.assertEqual(float(area), pressed.contact_area)
        self.assertIs(pressed.asp.contact.converged.value, True)
        self.assertEqual(pressed.asp.contact.boundary.value, "periodic")
        self.assertTrue(math.isnan(pressed.asp.contact.residual.error))
        numpy.testing.assert_array_equal(pressed.asp.contact.young.value, [2.08e11, 2.08e11])
        self.assertEqual(pressed.asp.kernel.error.value, pressed.kernel_error)  # no error of another result
        self.assertNotIn("area_error", dir(pressed.asp.contact))
        self.assertIn("real contact area: ", repr(pressed.asp.contact))
        self.assertEqual(repr(pressed.asp), "\n".join(repr(getattr(pressed.asp, n)) for n in ("contact", "generate", "kernel")))
        self.assertEqual(repr(pressed.pressure.asp), "<asperity: no results>")
        self.assertRaisesRegex(AttributeError, "has no result contact_aera: did you mean 'area'",
                               lambda: pressed.asp.contact.aera)
        self.assertRaisesRegex(AttributeError, "no result stress_max_shear: the tool has left none",
                               lambda: pressed.asp.stress.max_shear)

    # contact_yield was contact.yield, which is no Python, and no type checker read the types of the module.
    def test_a_result_whose_name_is_a_keyword_has_an_underscore(self):
        surface = asp.generate(**SURFACE).assign_attrs(contact_yield=[2e9, 1e9])
        numpy.testing.assert_array_equal(surface.asp.contact.yield_.value, [2e9, 1e9])

    # Two digits of the error: 1234.56 +- 7.8 is 1234.6 +- 7.8.
    def test_a_result_is_printed_to_the_digits_of_its_error(self):
        nan = math.nan
        for value, error, unit, text in (
                (1234.567, 7.84, "N", "1234.6 ± 7.8 N"), (9.99e-7, 1.2e-8, "m", "9.99e-07 ± 1.2e-08 m"),
                (0.012345, 0.5, "1", "0.01 ± 0.5"), (2.0, nan, "m", "2 m"), (0.0, 1.0, "m", "0 m"),
                (math.inf, nan, "Pa", "inf Pa"), (math.inf, 1.0, "Pa", "inf Pa"), (3, nan, "1", "3"),
                (1.0, "odd", "1", "1"), ("free", nan, "", "free")):
            self.assertEqual(str(asp.Result(value, error, unit, "")), text)

    def test_each_result_that_a_tool_tells_of_has_its_prefix_and_each_attribute_of_a_chain_is_one(self):
        warnings.simplefilter("ignore", asp.ToolWarning)
        one = asp.pipe(asp.stage.generate(**SURFACE), asp.contact(**STEEL, add="grid_errors,patches,contact_ratios"),
                       asp.stress(maximum=True), asp.acf())
        shown = {f"{tool}_{name}" for tool in ("kernel", "generate", "contact", "stress", "acf")
                 for name in dir(getattr(one.asp, tool))}
        left = {n for n in one.attrs if n not in shown and n.removesuffix("_error") not in one.attrs.keys() - {n}}
        self.assertLessEqual(left, {"Conventions", "history", "source"})

    def test_warnings_stay_in_the_dataset_and_in_the_table(self):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            pressed = asp.contact(asp.generate(**SURFACE), **STEEL)
            half = asp.stats(pressed.isel(x=slice(0, 32)))
        texts = [str(one.message) for one in told if one.category is asp.ToolWarning]
        self.assertEqual(texts, [f"asperity-contact: {pressed.asp.contact.warnings.value}",
                                 *(f"asperity-stats: {line}" for line in half.attrs["warnings"])])
        self.assertNotIn("warnings", asp.stats(asp.generate(**SURFACE)).attrs)

    def test_it_is_there_whichever_of_the_two_modules_is_imported_first(self):
        for modules in ("xarray, asperity", "asperity, xarray", "asperity, importlib.util; importlib.util.find_spec('xarray'); "
                        "import xarray, asperity"):
            code = (f"import sys; sys.path.insert(0, sys.argv[1]); import {modules}\n"
                    "print(type(xarray.Dataset().asp).__name__, type(xarray.DataArray(1).asp).__name__)")
            run = subprocess.run([sys.executable, "-W", "error::UserWarning", "-c", code, support.SOURCE / "tools/python"],
                                 capture_output=True, text=True)
            self.assertEqual((run.stdout, run.stderr), ("Accessor Accessor\n", ""))


def area(seed):
    return asp.generate(**dict(FINE, seed=seed)).asp.contact(**FLATS).asp.contact.area


class Pickled(support.TestCase):
    def test_functions_stages_datasets_and_results_are_the_same_again(self):
        surface = asp.generate(**FINE)
        for one in (asp.contact, asp.stage.generate, asp.pipe, asp.dataset):
            self.assertIs(pickle.loads(pickle.dumps(one)), one)
        press = asp.contact(**FLATS, counter=surface)
        pressed = press(surface)
        self.assertEqual(pressed.asp.contact.area, pickle.loads(pickle.dumps(press))(surface).asp.contact.area)
        for again in (pickle.loads(pickle.dumps(pressed)), copy.deepcopy(pressed)):
            self.assertTrue(again.identical(pressed))
            self.assertEqual(again.asp.contact.area, pressed.asp.contact.area)
        picture = surface.asp.plot()
        self.assertEqual(pickle.loads(pickle.dumps(picture)).media, "image/png")
        self.assertEqual(str(picture), repr(picture))  # was all of its bytes

    def test_the_options_of_a_tool_are_a_type(self):
        texture: asp.GenerateOptions = asp.GenerateOptions(shape=(9, 9), rq="1um")
        self.assertEqual(texture, {"shape": (9, 9), "rq": "1um"})
        self.assertIn("yield_", asp.ContactOptions.__annotations__)
        self.assertNotIn("datasets", asp.ContactOptions.__annotations__)
        self.assertRaisesRegex(AttributeError, "no function 'nonsense'", lambda: asp.NonsenseOptions)

    def test_other_processes_run_them(self):
        with concurrent.futures.ProcessPoolExecutor(2, multiprocessing.get_context("fork")) as pool:
            found = list(pool.map(area, (1, 2)))
            tables = list(pool.map(asp.stats, [asp.generate(**FINE)]))
        self.assertEqual(found, [area(1), area(2)])
        self.assertTrue(tables[0].equals(asp.stats(asp.generate(**FINE))))


if __name__ == "__main__":
    support.main()
