/// Ranks by MPI; no other code calls it. For core/launch.cpp.
#pragma once

#include "core/ranks.hpp"

extern "C" {
/// Initialises MPI. Of all ranks of the launcher.
const asperity::Ranks* asperity_start_mpi();
}
