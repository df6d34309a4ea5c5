/// Datasets for ParaView: VTK's XML image data (.vti), or a rectilinear grid (.vtr) for uneven depths.
///
/// Points are the dataset's cell centres, in metres. A depth becomes the height -z, so that the body lies
/// below its surface and x, y, z are right-handed. Numbers are raw and little-endian, appended to the XML
/// behind lengths of 64 bits: doubles, or Int8 for masks and flags; missing ones are NaN. Each array carries
/// its unit as vtkDataArray::UNITS_LABEL.
///
/// A dataset with volumes (z, x, y) becomes a block whose point data they are; its fields (x, y) belong to no
/// layer of it and stand as field data, nx·ny numbers each, x fastest. A dataset without volumes is one layer
/// at z = 0, with the fields as its point data. Components of stress remain arrays of their own (stress_xx,
/// …).
///
/// Memory    the file's bytes once, and a layer.
///
/// VTK File Formats, https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
#pragma once

#include <string>

#include "dataset/dataset.hpp"

namespace asperity {

/// Throw DataError for a dataset without fields and volumes, of coordinates that do not ascend, or, for image
/// data, of depths that are not evenly spaced.
std::string encode_vti(const Dataset& dataset);
std::string encode_vtr(const Dataset& dataset);

}  // namespace asperity
