/// Datasets for ParaView: VTK's XML image data (.vti), or a rectilinear grid (.vtr) for uneven depths.
///
/// Points are the cell centres in metres. A depth becomes the height -z, so that the body lies below its
/// surface and x, y, z are right-handed. Numbers are raw and little-endian, appended to the XML after lengths
/// of 64 bits: doubles, or Int8 for masks and flags; missing points are NaN. Each array has its unit as
/// vtkDataArray::UNITS_LABEL.
///
/// In a dataset with volumes (z, x, y) these are the point data; fields (x, y) belong to no layer and become
/// field data, nx·ny numbers each, x fastest. A dataset without volumes becomes one layer at z = 0 with the
/// fields as point data. Stress components remain separate arrays (stress_xx, …).
///
/// Memory    the bytes of the file, and one layer.
///
/// VTK File Formats, https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
#pragma once

#include <string>

#include "dataset/dataset.hpp"

namespace asperity {

/// Throw DataError for a dataset without fields and volumes, with coordinates not in ascending order, or, for
/// image data, with unevenly spaced depths.
std::string encode_vti(const Dataset& dataset);
std::string encode_vtr(const Dataset& dataset);

}  // namespace asperity
