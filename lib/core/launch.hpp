/// The ranks of this run: those that mpirun or srun has started, or the process alone.
///
/// MPI is loaded (core/module.hpp) and initialised under a launcher only: other runs pay nothing for it. The
/// environment shows a launcher: Open MPI's, one of the MPICH family, or Slurm's with PMIx.
#pragma once

#include "core/ranks.hpp"

namespace asperity {

/// Number of ranks that the launcher has started; 1 without a launcher.
int ranks_started();
/// Number of these ranks on this machine.
int ranks_on_machine();

/// Initialises MPI once; closes stdout and stderr of ranks above 0. Throws DataError("mpirun") where MPI
/// cannot be loaded, because all copies would write the same file.
const Ranks& launched();

}  // namespace asperity

extern "C" {
/// Initialises MPI: all ranks of the launcher. Only core/mpi.cpp, which is the module, calls MPI.
const asperity::Ranks* asperity_start_mpi();
}
