/// A field in large pages, for large results: not initialised.
#pragma once

#include "core/field.hpp"
#include "core/large_pages.hpp"

namespace asperity {

inline Field large_field(Shape shape) {
  Field out(shape.nx, shape.ny);
  prefer_large_pages(out.data(), size(out.size()) * sizeof(double));
  return out;
}

}  // namespace asperity
