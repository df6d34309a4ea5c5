"""Reads body.vti, body.vtr, surface.vti and datasets of a folder by VTK's own readers; vti.cpp has written them."""
import math
import sys

try:
    from vtkmodules.vtkCommonCore import vtkDataArray
    from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLRectilinearGridReader
    from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader
except ImportError:
    print("SKIPPED: there is no python3-vtk9")
    sys.exit(0)

folder = sys.argv[1]
NX, NY, DX, DY = 5, 3, 2e-6, 3e-6


def read(reader, name):
    reader.SetFileName(f"{folder}/{name}")
    reader.Update()
    return reader.GetOutput()


def near(a, b, unit):
    return abs(a - b) <= 1e-12 * unit


def stress(k, i, j):
    return 100.0 * k + 10 * i + j


def check_body(grid, depths):
    """Volumes in the order of VTK's points, the deepest layer first; the fields beside them."""
    assert list(grid.GetDimensions()) == [NX, NY, len(depths)], grid.GetDimensions()
    values = grid.GetPointData().GetArray("von_mises")
    assert values.GetNumberOfTuples() == NX * NY * len(depths)
    assert values.GetInformation().Get(vtkDataArray.UNITS_LABEL()) == "Pa"
    for k, depth in enumerate(depths):
        for i in range(NX):
            for j in range(NY):
                point = i + NX * (j + NY * (len(depths) - 1 - k))
                x, y, z = grid.GetPoint(point)
                assert near(x, (i - 2) * DX, DX) and near(y, (j - 1) * DY, DY) and near(z, -depth, DX), (x, y, z)
                assert values.GetValue(point) == stress(k, i, j)
    heights = grid.GetFieldData().GetArray("heights")
    assert heights.GetNumberOfTuples() == NX * NY and near(heights.GetValue(1), 1e-5, 1e-5)


check_body(read(vtkXMLImageDataReader(), "body.vti"), [0.5e-6, 1.5e-6, 2.5e-6, 3.5e-6])
check_body(read(vtkXMLRectilinearGridReader(), "body.vtr"), [0, 1e-6, 4e-6])

surface = read(vtkXMLImageDataReader(), "surface.vti")
assert list(surface.GetDimensions()) == [NX, NY, 1]
for i in range(NX):
    for j in range(NY):
        assert near(surface.GetPointData().GetArray("heights").GetValue(i + NX * j), 1e-6 * (10 * i + j), 1e-6)
        assert surface.GetPointData().GetArray("contact").GetValue(i + NX * j) == (1 if (i, j) == (0, 1) else 0)

# The CF reader shows variables of the same dimensions at a time, asked for by their names. NetCDF's last dimension is its
# first axis: of (z, x, y) that is y, so that x and y are exchanged to the eye. Depth, positive down, is drawn downwards
# from where the first depth lies upwards: at its place if that is 0.
for name, first in (("body.nc", 0.5e-6), ("from-zero.nc", 0.0)):
    reader = vtkNetCDFCFReader()
    reader.SphericalCoordinatesOff()
    reader.SetFileName(f"{folder}/{name}")
    reader.UpdateMetaData()
    reader.SetDimensions("(z, x, y)")
    body = read(reader, name)
    assert list(body.GetDimensions()) == [NY, NX, 4], body.GetDimensions()
    values = body.GetPointData().GetArray("von_mises")
    assert values.GetNumberOfTuples() == NX * NY * 4
    assert reader.QueryArrayUnits("von_mises") == "Pa"
    for k in range(4):
        for i in range(NX):
            for j in range(NY):
                point = j + NY * (i + NX * k)
                y, x, z = body.GetPoint(point)
                assert near(x, (i - 2) * DX, DX) and near(y, (j - 1) * DY, DY), (x, y)
                assert near(z, first - k * 1e-6, 1e-6), z
                assert values.GetValue(point) == stress(k, i, j)

# In the order of viewers all three axes are in their places, whatever the first depth is; but for the choice of variables
# all is as the reader has it by default.
for name, depths in (("viewers.nc", [0.5e-6, 1.5e-6, 2.5e-6, 3.5e-6]), ("viewers-uneven.nc", [0, 1e-6, 4e-6])):
    reader = vtkNetCDFCFReader()
    reader.SetFileName(f"{folder}/{name}")
    reader.UpdateMetaData()
    for variables in ("(z, y, x)", "(y, x)"):
        reader.SetDimensions(variables)
        body = read(reader, name)
        layers = [-depth for depth in reversed(depths)] if variables == "(z, y, x)" else [0.0]
        assert list(body.GetDimensions()) == [NX, NY, len(layers)], body.GetDimensions()
        values = body.GetPointData().GetArray("von_mises" if len(layers) > 1 else "heights")
        assert reader.QueryArrayUnits(values.GetName()) == ("Pa" if len(layers) > 1 else "m")
        for point in range(values.GetNumberOfTuples()):
            i, j, k = point % NX, point // NX % NY, point // (NX * NY)
            x, y, z = body.GetPoint(point)
            assert near(x, (i - 2) * DX, DX) and near(y, (j - 1) * DY, DY) and near(z, layers[k], DX), (x, y, z)
            expected = stress(len(layers) - 1 - k, i, j) if len(layers) > 1 else 1e-6 * (10 * i + j)
            assert near(values.GetValue(point), expected, expected), (point, expected)
