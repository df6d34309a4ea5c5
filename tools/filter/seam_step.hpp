/// --make-periodic of asperity-filter: "x", "both,tilt", "y,taper=0.1mm".
#pragma once

#include "tools/filter/step.hpp"

namespace asperity::cli {

extern const std::string seam_text;

Act make_periodic(const std::string& value);

}  // namespace asperity::cli
