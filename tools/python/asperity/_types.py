"""The types of NetCDF's classic formats CDF-2 and CDF-5, which flow through the tools' pipes.

R. Rew, G. Davis, NetCDF: an interface for scientific data access, IEEE CG&A 10 (1990) 76-82.
"""
import numpy as np

DTYPES = {1: "i1", 2: "S1", 3: ">i2", 4: ">i4", 5: ">f4", 6: ">f8",
          7: "u1", 8: ">u2", 9: ">u4", 10: ">i8", 11: ">u8"}
OF_CDF5 = range(7, 12)  # the older format has only those before
NUMBERS = {np.dtype(name).newbyteorder("="): number for number, name in DTYPES.items()}


def number_of(array):
    """The number of an array's type, or None."""
    return NUMBERS.get(array.dtype.newbyteorder("="))
