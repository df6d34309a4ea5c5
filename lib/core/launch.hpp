/// The ranks of this run: those that mpirun or srun has started, or the process alone.
///
/// MPI is loaded (core/module.hpp) and initialised under a launcher only: other runs pay nothing for it. Its
/// environment tells a launcher of Open MPI, of MPICH and its kin, or Slurm's with PMIx.
#pragma once

#include "core/ranks.hpp"

namespace asperity {

/// How many the launcher has started; 1 without one.
int ranks_started();
/// Of them, those on this machine.
int ranks_on_machine();

/// For good, from the first call on. The outputs of all but the first rank are closed: it speaks for all.
/// Throws DataError("mpirun") where MPI cannot be loaded, for the copies would write one file.
const Ranks& launched();

}  // namespace asperity
