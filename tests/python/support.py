"""What the tests of the module asperity share. They need numpy, xarray and scipy, which is the other reader of NetCDF."""
import os
import pathlib
import subprocess
import sys
import unittest
import warnings

try:
    import numpy
    import scipy.io
    import xarray
except ImportError as missing:
    print(f"SKIPPED: {missing}")
    sys.exit(77)

SOURCE = pathlib.Path(__file__).resolve().parents[2]
DATA = SOURCE / "tests/data"
sys.path.insert(0, str(SOURCE / "tools/python"))
os.environ["SOURCE_DATE_EPOCH"] = "0"  # so that no time is recorded

SURFACE = dict(shape=(64, 48), size="1mm,0.6mm", rq="0.4um", length="50um", model="gaussian", seed=7)
SURFACE_WORDS = "--shape 64x48 --size 1mm,0.6mm --rq 0.4um --length 50um --model gaussian --seed 7"
STEEL = dict(radius="10mm", young="208GPa", poisson=0.3, load="20N")
STEEL_WORDS = "--radius 10mm --young 208GPa --poisson 0.3 --load 20N"


def shell(command):
    """What a command prints, its status and what it says."""
    run = subprocess.run(["bash", "-c", command], capture_output=True)
    return run.stdout, run.returncode, run.stderr.decode()


def other_reader(raw):
    """Values and attributes of a NetCDF file, as scipy reads them."""
    import io
    with scipy.io.netcdf_file(io.BytesIO(raw), mmap=False) as file:
        variables = {n: (v[:].copy(), v.dimensions, dict(v._attributes)) for n, v in file.variables.items()}
        return variables, dict(file._attributes)


def main():
    unittest.main(warnings="error")


class TestCase(unittest.TestCase):
    tools_may_warn = False  # otherwise a warning that a test does not expect is a fault

    def setUp(self):
        if self.tools_may_warn:
            warnings.filterwarnings("ignore", category=UserWarning, message="asperity-")
        self.descriptors = len(os.listdir("/proc/self/fd"))

    def tearDown(self):
        """Nothing is left: no open file, no process."""
        self.assertEqual(len(os.listdir("/proc/self/fd")), self.descriptors, "files are left open")
        children = pathlib.Path("/proc/self/task").glob("*/children")
        self.assertEqual("".join(c.read_text() for c in children), "", "processes are left")

    def assert_same_bits(self, dataset, raw):
        """The dataset of a file's bytes: values to the last bit, attributes, dimensions."""
        variables, attributes = other_reader(raw)
        self.assertEqual(set(variables), set(dataset.variables))
        for name, (values, dimensions, own) in variables.items():
            fill = own.pop("_FillValue", None)
            values = values.astype(values.dtype.newbyteorder("="))
            if fill is not None:
                values[values == fill] = numpy.nan
            self.assertEqual(dataset[name].dims, dimensions, name)
            self.assertEqual(dataset[name].values.dtype, values.dtype, name)
            self.assertEqual(dataset[name].values.tobytes(), values.tobytes(), name)
            self.assert_same_attributes(dataset[name].attrs, own)
        self.assert_same_attributes(dataset.attrs, attributes)

    def assert_same_attributes(self, mine, other):
        self.assertEqual(list(mine), list(other))
        for name, value in other.items():
            value = value.decode() if isinstance(value, bytes) else value
            numpy.testing.assert_array_equal(mine[name], value, name)
