#!/usr/bin/python3
"""What strangers pass to the module is understood, or refused in one line; nothing is left behind."""
import io
import tempfile
import warnings

import support
from support import STEEL, SURFACE

import numpy
import xarray
import asperity as asp
from asperity import _encode

HEIGHTS = numpy.random.default_rng(1).normal(size=(12, 16)) * 1e-6


def surface(**attributes):
    out = asp.dataset(HEIGHTS, size="3mm,4mm")
    out.attrs.update(attributes)
    return out


class Arrays(support.TestCase):
    def test_an_array_keeps_its_values_in_any_layout_and_type(self):
        arrays = [HEIGHTS, numpy.asfortranarray(HEIGHTS), HEIGHTS[::2, ::-1], HEIGHTS.astype(">f8"), HEIGHTS.T,
                  HEIGHTS.astype("f4"), HEIGHTS.astype("f2"), HEIGHTS.tolist(), numpy.arange(12).reshape(3, 4),
                  numpy.arange(12, dtype="u2").reshape(3, 4)]
        for array in arrays:
            drawn = asp.dataset(array, size="1km").heights.values
            numpy.testing.assert_array_equal(drawn, numpy.asarray(array, "f8"))

    def test_masked_points_and_nan_are_missing_there_and_back(self):
        masked = numpy.ma.masked_greater(HEIGHTS, 1e-6)
        missing = masked.mask
        out = asp.filter(asp.dataset(masked, size="3mm,4mm"), scale=1)
        numpy.testing.assert_array_equal(numpy.isnan(out.heights), missing)
        numpy.testing.assert_array_equal(out.heights.values[~missing], HEIGHTS[~missing])
        self.assertEqual(asp.stats(out).loc["N", "value"], (~missing).sum())
        integers = asp.dataset(numpy.ma.masked_equal(numpy.arange(12).reshape(3, 4), 5), size="1mm", unit="nm")
        self.assertTrue(numpy.isnan(integers.heights[1, 1]))

    def test_the_coordinates_are_middles_of_cells_in_the_unit_that_is_asked_for(self):
        out = asp.dataset([[1, 2], [3, 4], [5, 6]], size=asp.si((3e-3, 4e-3)), unit="um", periodic="x")
        numpy.testing.assert_allclose(out.x, [-1e-3, 0, 1e-3], atol=1e-18)
        numpy.testing.assert_allclose(out.heights.values.ravel(), numpy.arange(1, 7) * 1e-6, rtol=1e-15)
        self.assertEqual((out.x.periodic, out.y.periodic, out.x.length), (1, 0, 3e-3))
        for periodic in (True, 1, numpy.True_, numpy.bool_(False), 0, False):  # numpy's True, and 1, were taken for False
            self.assertEqual(asp.dataset(HEIGHTS, "1mm", periodic=periodic).y.periodic, int(periodic))
        for periodic in ("xy", 2, None):
            self.assertRaisesRegex(ValueError, "periodic=", asp.dataset, HEIGHTS, "1mm", periodic=periodic)

    def test_a_field_of_xarray_brings_its_coordinates_and_its_order(self):
        field = surface().heights
        again = asp.dataset(field.transpose("y", "x"))
        numpy.testing.assert_array_equal(again.heights, field)
        numpy.testing.assert_allclose(again.x, field.x, rtol=1e-12)

    def test_what_is_no_map_is_refused(self):
        for array in (HEIGHTS[0], numpy.zeros((0, 3)), numpy.zeros((2, 2, 2))):
            self.assertRaisesRegex(ValueError, "two dimensions", asp.dataset, array, "1mm")
        self.assertRaisesRegex(TypeError, "a Dataset is a surface already", asp.dataset, surface(), "1mm")
        for array in (HEIGHTS * 1j, "abc", None, [["a"]], numpy.array([[None]])):
            self.assertRaisesRegex(TypeError, "no real numbers", asp.dataset, array, "1mm")
        self.assertRaisesRegex(TypeError, "size is missing", asp.dataset, HEIGHTS)
        for size in ("3", 3, (3e-3, "4mm")):
            self.assertRaisesRegex(asp.UsageError, "has no unit", asp.dataset, HEIGHTS, size)
        self.assertRaisesRegex(asp.BadData, "all points are missing", asp.dataset, HEIGHTS * numpy.nan, "3mm")
        self.assertRaisesRegex(TypeError, "asperity.dataset", asp.stats, HEIGHTS)


class Datasets(support.TestCase):
    tools_may_warn = True

    def test_orders_types_and_units_are_understood(self):
        one = surface()
        expected = asp.stats(one).loc["Sq", "value"]
        micro = one.assign(heights=one.heights * 1e6)
        micro.heights.attrs.update(one.heights.attrs, units="um", unit="um")
        for other, accuracy in ((one.transpose("y", "x"), 0), (one.heights, 0), (micro, 1e-15),
                                (one.assign(heights=one.heights.astype("f4")), 1e-7)):
            if isinstance(other, xarray.Dataset) and other.heights.dtype == "f4":
                other.heights.attrs.update(one.heights.attrs)
            self.assertLessEqual(abs(asp.stats(other).loc["Sq", "value"] / expected - 1), accuracy)

    def test_a_field_with_a_name_is_the_one_that_is_measured(self):
        pressed = asp.contact(surface(), **STEEL, add="elastic_energy")
        table = asp.stats(pressed.pressure)
        self.assertEqual(table.loc["Sq", "unit"], "Pa")

    def test_coordinates_attributes_and_history_pass_through(self):
        one = surface(note="µ", number=7, many=[1, 2], large=2**40, truth=True)
        one = one.assign_coords(sample="A12", time=numpy.datetime64("2020-01-01T12:00", "ns"),
                                label=("part", ["a", "bc"]), count=("part", [1, 2]))
        out = asp.convert(one)
        self.assertEqual(out.sample.item(), "A12")
        self.assertEqual(list(out.label.values), ["a", "bc"])
        self.assertEqual(list(out["count"].values), [1, 2])
        self.assertEqual(out.time.values, one.time.values)
        self.assertLessEqual({"sample", "time", "label", "count"}, set(out.coords))
        self.assertEqual([out.attrs[n] for n in ("note", "number", "large", "truth")], ["µ", 7, 2.0**40, 1])
        self.assertEqual(out.history.splitlines()[1:], one.history.splitlines())

    def test_what_netcdf_does_not_hold_is_told(self):
        with self.assertWarnsRegex(asp.ToolWarning, "left out: settings, nothing, 'a/b', '', 'trail '"):
            asp.convert(surface(settings={"a": 1}, nothing=None, **{"a/b": 1, "": 1, "trail ": 1}))
        for name, held in ((" lead", False), ("\ud800", False), ("a\nb", False), ("x" * 257, False), ("µ", True),
                           ("x" * 256, True), ("1 a", True)):
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                self.assertEqual(name in asp.convert(surface(**{name: 1})).attrs, held, name)
            self.assertEqual(len(told), not held)
        for values in (numpy.zeros(3, complex), numpy.array([1, "a"], object)):
            self.assertRaisesRegex(TypeError, "'odd'", asp.stats, surface().assign(odd=("w", values)))
        self.assertRaisesRegex(asp.BadData, "x is missing; the dataset has heights, u, y", asp.stats,
                               surface().rename(x="u"))

    def test_several_surfaces_have_the_names_that_their_list_or_dictionary_gives(self):
        surfaces = list(asp.ensemble(**SURFACE, count=2))
        table = asp.contact({"rough": surfaces[0], "other": surfaces[1]}, young="1GPa", poisson=0.3, load="1N")
        self.assertEqual(list(table.index[:2]), ["rough", "other"])
        self.assertEqual(list(asp.contact(surfaces, young="1GPa", poisson=0.3, load="1N").index[:2]),
                         ["datasets[0]", "datasets[1]"])
        self.assertEqual(asp.stats(*surfaces).loc["Sq", "surfaces"], 2)
        names = ["two\nlines", "a\ttab", "x" * 300, "/proc/self/fd/3"]  # the first split its row
        odd = dict(zip(names, asp.ensemble(**SURFACE, count=4)))
        self.assertEqual(list(asp.contact(odd, young="1GPa", poisson=0.3, load="1N").index[:4]), names)

    # Standard error 0 of two surfaces; and the other file's statistics, of bytes that name one.
    def test_the_same_surface_twice_and_bytes_that_name_a_file_are_refused_as_in_a_shell(self):
        one = surface()
        for pair in ([one, one], [one, one.copy(deep=True)], [one.heights, one.heights]):
            self.assertRaisesRegex(asp.UsageError, r"'datasets\[0\]' is given twice", asp.stats, pair)
        self.assertRaisesRegex(asp.UsageError, "'a' is given twice", asp.stats, {"a": one, "b": one})
        other = one.copy(deep=True)
        other.heights[0, 0] += 1e-9
        self.assertEqual(asp.stats([one, other]).loc["Sq", "surfaces"], 2)
        with tempfile.NamedTemporaryFile(suffix=".nc") as file:
            one.to_netcdf(file.name, engine="scipy")
            names = file.name.encode() + b"\n"
            self.assertRaisesRegex(asp.BadData, "--files-from -", asp.stats, names)
            self.assertEqual(len(asp.stats(files_from=names)), len(asp.stats(one)))

    def test_a_dataset_a_table_or_bytes_stand_for_a_file(self):
        one = surface()
        self.assertIn("--counter counter", asp.contact(one, **STEEL, counter=one).history)
        self.assertEqual(len(asp.convert(asp.convert(one, to="gsf"), from_="gsf").x), 12)
        points = asp.stress(asp.contact(one, **STEEL),
                            points={"x [um]": [0, 1], "y [um]": [0, 0], "depth [um]": [5, 5]})
        self.assertEqual(list(points.x), [0, 1e-6])
        kernel = asp.kernel(shape=(32, 32), size="1mm", length="60um", rq="1um")
        drawn = asp.generate(kernel=kernel, shape=(32, 32), size="1mm", seed=3)
        self.assertEqual(dict(drawn.sizes)["x"], 32)
        sweep = asp.contact(smooth=True, shape=(32, 32), size="1mm", radius=asp.si((0.01, numpy.inf)), young="208GPa",
                            poisson=0.3, sweep=asp.si(numpy.array([10., 20, 40])))
        self.assertEqual(list(sweep.load.round(9)), [10, 20, 40])
        self.assertEqual(asp.plot(sweep, kind="sweep").media, "image/png")

    # Lines of an open file were taken for names of files.
    def test_an_open_file_is_read(self):
        one = surface()
        packed = io.BytesIO(b"".join(_encode.encoded(one)))
        self.assertEqual(asp.stats(packed).loc["Sq", "value"], asp.stats(one).loc["Sq", "value"])
        points = io.StringIO("# x [um]\ty [um]\tdepth [um]\n0\t0\t5\n")
        self.assertAlmostEqual(asp.stress(asp.contact(one, **STEEL), points=points).z[0] / 5e-6, 1, 14)
        with tempfile.NamedTemporaryFile(suffix=".txt") as file:
            numpy.savetxt(file.name, HEIGHTS)
            for opened in (open(file.name), open(file.name, "rb")):
                with opened:
                    numpy.testing.assert_array_equal(asp.convert(opened, size="1mm", unit="m").heights, HEIGHTS)

    # Of a dataset of several surfaces, tools said that acf_achieved does not have two dimensions.
    def test_a_dataset_with_a_further_dimension_is_several_surfaces(self):
        drawn = list(asp.ensemble(**SURFACE, count=3))
        several = xarray.concat(drawn, xarray.DataArray([30, 40, 50], dims="length"))
        self.assertEqual(asp.stats(several).loc["Sq", "mean"], asp.stats(drawn).loc["Sq", "mean"])
        self.assertEqual(asp.stats(several.heights.transpose(..., "length")).loc["Sq", "surfaces"], 3)
        flats = dict(young="1GPa", poisson=0.3, load="1N")
        self.assertEqual(list(asp.contact(several, **flats).index[:3]), ["length=30", "length=40", "length=50"])
        self.assertIn("actual_range", several.heights.attrs)
        with warnings.catch_warnings(record=True) as told:  # the first one's, in the dataset of another
            warnings.simplefilter("always")
            self.assertEqual(asp.stats(several.isel(length=1)).loc["Sq", "value"], asp.stats(drawn[1]).loc["Sq", "value"])
        self.assertRegex(str(told[0].message), "heights: the values are not those of actual_range")
        self.assertRaisesRegex(TypeError, "asperity-convert takes one dataset, not 3", asp.convert, several)
        with self.assertRaisesRegex(asp.BadData, r"heights is not a field on \(x, y\)"):
            asp.stats(several.heights.expand_dims("other").to_dataset())

    def test_parts_of_a_dataset_keep_their_places_and_are_not_periodic(self):
        one = asp.generate(**dict(SURFACE, shape=(48, 48), periodic=True))
        half = asp.filter(one.isel(x=slice(0, 24)), scale=1)
        self.assertEqual((half.x.periodic, half.y.periodic), (0, 1))
        numpy.testing.assert_array_equal(half.heights, one.heights[:24])
        for same in (one.sel(x=slice(None, None, -1)), one.sortby("y", ascending=False), one.transpose("x", "y", ...)):
            self.assertAlmostEqual(asp.stats(same).loc["Sq", "value"] / asp.stats(one).loc["Sq", "value"], 1, 12)
        self.assertRaisesRegex(asp.BadData, "x: coordinates are not evenly spaced", asp.stats, one.isel(x=[0, 1, 3]))
        self.assertRaisesRegex(asp.BadData, "^asperity-stats: heights has no unit: add the attribute units", asp.stats,
                               one - one.mean())
        with xarray.set_options(keep_attrs=True):
            self.assertEqual(asp.stats(one * 2).loc["Sq", "value"], 2 * asp.stats(one).loc["Sq", "value"])

    # Smoothed heights had the errors of those that were drawn: a fifth of the right ones, without a word.
    def test_heights_that_were_changed_have_errors_of_their_own(self):
        one = asp.generate(**dict(SURFACE, shape=(128, 128)))
        changed = one.copy(deep=True)
        changed.heights.values[:] = (one.heights.values + numpy.roll(one.heights.values, 3, 0)) / 2
        with self.assertWarnsRegex(asp.ToolWarning, "^asperity-stats: heights: the values are not those of actual_range"):
            table = asp.stats(changed)
        self.assertTrue(table.equals(asp.stats(changed, correlation="estimate")))
        part = one.isel(x=slice(0, 64))
        for same in (one, one.astype("f4"), one.transpose("y", "x", ...), one.sortby("x", ascending=False), part):
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                self.assertTrue(asp.stats(same).equals(asp.stats(same, correlation="drawn")))
            self.assertFalse([w for w in told if "actual_range" in str(w.message) and "values" in str(w.message)])

    # The width of a row was unknown: "y is no coordinate", or "only one point is left of those in actual_range".
    def test_a_profile_that_is_cut_from_a_surface_is_a_row_of_its_cells(self):
        one = asp.generate(**dict(SURFACE, shape=(48, 48), periodic=True))
        row = asp.dataset(one.heights.values[:, 5:6], size=asp.si((one.x.length, one.y.length / 48)), periodic="x")
        expected = list(asp.stats(row).loc[["N", "Sa", "Sq", "Ssk", "Sku"], "value"])
        for cut in (one.isel(y=5), one.isel(y=[5]), one.sel(y=one.y[5]), one.heights.isel(y=5),
                    one.transpose("y", "x", ...).isel(y=5)):
            self.assertEqual(list(asp.stats(cut).loc[["N", "Sa", "Sq", "Ssk", "Sku"], "value"]), expected)
        again = asp.filter(one.isel(y=5), scale=1)
        self.assertEqual((dict(again.sizes)["y"], again.x.periodic, again.y.periodic), (1, 1, 0))
        self.assertAlmostEqual(again.y.length / row.y.length, 1, 12)  # length less the range: 48 roundings
        self.assertEqual(list(asp.filter(one.isel(x=3), scale=1).heights.values[0]), list(one.heights.values[3]))
        stressed = asp.stress(asp.contact(one, young="1GPa", poisson=0.3, load="1N"), depths="0:0.1mm:3")
        self.assertEqual(stressed.von_mises.isel(y=5).asp.plot(kind="section").media, "image/png")
        self.assertRaisesRegex(asp.BadData, r"heights is not a field on \(x, y\)", asp.stats, one.isel(x=5, y=5))

    def test_a_spectrum_is_a_table_a_dictionary_or_an_array(self):
        options = dict(shape=(32, 32), size="32um", seed=1)
        measured = asp.psd(asp.generate(**SURFACE), result="radial")
        asp.generate(psd=measured, shape=(32, 32), size="3mm", rms_slope=0.1)
        q, c = numpy.array([0.2, 1, 3]), numpy.array([5, 5, 0.1])
        columns = asp.generate(psd={"wave_number [rad/um]": q, "psd [um4]": c}, **options)
        array = xarray.DataArray(c, dims="q", coords={"q": ("q", q, {"units": "rad/um"})}, name="psd",
                                 attrs={"units": "um4"})
        numpy.testing.assert_array_equal(asp.generate(psd=array, **options).heights, columns.heights)


    def test_a_map_of_which_twins_are_drawn_is_understood_or_refused_in_one_line(self):
        one = surface()
        masked = asp.dataset(numpy.ma.masked_greater(HEIGHTS, 1.5e-6), size="3mm,4mm")
        twin = asp.generate(like=masked, seed=1)
        self.assertEqual((dict(twin.sizes)["x"], dict(twin.sizes)["y"], int(twin.heights.isnull().sum())), (12, 16, 0))
        named = asp.generate(like=one.heights.rename("topography"), variable="topography", seed=1)
        self.assertTrue((named.heights == asp.generate(like=one, seed=1).heights).all())
        self.assertRaisesRegex(asp.BadData, "^asperity-generate: like: heights is missing; the dataset has x, y, topo",
                               asp.generate, like=one.heights.rename("topography"))
        flat = asp.dataset(HEIGHTS * 0, size="3mm,4mm")
        for wrong, kind, words in (
                ([one, one], TypeError, "^like=<list>: the name of a file, a Dataset"),
                (asp.filter(median="3px"), TypeError, "^like=<stage: asperity-filter --median 3px>"),
                (3, TypeError, "^like=3: the name of a file"), (flat, asp.BadData, "like: heights: every value is"),
                (HEIGHTS, asp.BadData, "like: .* size"), ("nowhere.x3p", asp.ToolError, "nowhere.x3p: No such file")):
            self.assertRaisesRegex(kind, words, asp.generate, like=wrong)
        self.assertRaisesRegex(TypeError, "^asperity-generate takes no dataset: it is given as acf= or .*like=$",
                               asp.generate, one)
        self.assertRaisesRegex(asp.UsageError, "--acf cannot be combined with --like", asp.generate, like=one, acf=one)
        self.assertRaisesRegex(asp.UsageError, "--variable needs --like", asp.generate, **SURFACE, variable="heights")


class Words(support.TestCase):
    tools_may_warn = True

    def test_a_wrong_option_is_refused_by_its_name(self):
        self.assertRaisesRegex(TypeError, "did you mean 'radius'", asp.contact, raduis="1m")
        self.assertRaisesRegex(TypeError, "^length=True: the option needs", asp.generate, length=True)
        self.assertRaisesRegex(TypeError, "^periodic=1: the option stands alone", asp.generate, periodic=1)
        self.assertRaisesRegex(asp.UsageError, "^progress='maybe' is none of auto", asp.stats, surface(), progress="maybe")
        self.assertRaisesRegex(TypeError, "^report=.*the name of a file", asp.generate, report=surface())
        self.assertRaisesRegex(TypeError, "^counter=3: the name of a file, a Dataset", asp.contact, counter=3)
        self.assertRaisesRegex(asp.UsageError, "^asperity-contact: --young is required$", asp.contact, surface())
        self.assertRaisesRegex(asp.UsageError, "--rq: 'nanm'", asp.generate, **{**SURFACE, "rq": asp.si(numpy.nan)})
        self.assertRaisesRegex(AttributeError, "asperity-nonsense is not on PATH", lambda: asp.nonsense)

    def test_a_stage_says_that_it_has_not_run(self):
        stage = asp.contact(**STEEL)
        self.assertEqual(repr(stage), f"<stage: asperity-contact {support.STEEL_WORDS}>")
        self.assertRaisesRegex(AttributeError, "it has not run", lambda: stage.pressure)
        self.assertTrue(stage(surface()).equals(asp.contact(surface(), **STEEL).assign_attrs(stage(surface()).attrs)))
        for stages in ((), (surface(),), (surface(), surface()), (stage,), (stage, stage)):
            self.assertRaises(TypeError, asp.pipe, *stages)

    def test_lists_repeat_an_option_and_steps_keep_their_order(self):
        history = asp.filter(surface(), median=["3px", "5px"], remove_form="plane", scale=-1).history
        self.assertIn("asperity-filter --median 3px --median 5px --remove-form plane --scale=-1\n", history)

    # The truth of an array was asked for.
    def test_a_stage_may_have_an_array_among_its_options(self):
        stage = asp.stress(depths=asp.si(numpy.array([0, 5e-6])))
        self.assertEqual(list(stage(asp.contact(surface(), **STEEL)).z.values), [0, 5e-6])

    def test_numbers_with_units_of_their_own_keep_them(self):
        class Quantity:  # as pint's
            magnitude = 3.0

            def to(self, unit):
                assert unit == "m"
                out = Quantity()
                out.magnitude = 3e-3
                return out
        spread = xarray.DataArray(0.4, attrs={"units": "um"})
        history = asp.generate(**{**SURFACE, "size": Quantity(), "rq": spread, "length": "150um"}).history
        self.assertIn("--size 0.003m --rq 0.4um", history)
        tens = xarray.DataArray(3, attrs={"units": "10 nm"})  # was 310 nm
        self.assertRaisesRegex(asp.UsageError, "'3 10 nm' has more than one number", asp.generate, **{**SURFACE, "rq": tens})

    # 0.4 was 0.4 m.
    def test_a_bare_number_is_no_quantity_and_the_refusal_says_how_to_write_it(self):
        for number in (0.4, numpy.float32(0.5), xarray.DataArray(0.5), True):
            kind, words = (TypeError, "needs QUANTITY") if number is True else \
                (asp.UsageError, r"^rq=(0\.\d) has no unit: .* asperity\.si\(\1\) for \1 m$")
            self.assertRaisesRegex(kind, words, asp.generate, **{**SURFACE, "rq": number})
        for options in (dict(depths=[0, 5e-6]), dict(depths=numpy.array([1e-6])), dict(maximum=True, memory=10**9)):
            self.assertRaisesRegex(asp.UsageError, "has no unit", asp.stress, **options)
        self.assertEqual(asp.contact(radius=numpy.inf, poisson=0.3).words[:2], ["--radius", "inf"])
        self.assertEqual(asp.contact(poisson=asp.si((0.3, 0.2))).words, ["--poisson", "0.3,0.2"])
        self.assertRaisesRegex(TypeError, "a text has its own unit", asp.si, "3mm")


if __name__ == "__main__":
    support.main()
