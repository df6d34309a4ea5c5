#include "core/launch.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "core/error.hpp"
#ifdef ASPERITY_MPI
#include "core/module.hpp"
#endif

namespace asperity {
namespace {

int number_in(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? 0 : std::atoi(text);
}

int largest_of(std::initializer_list<const char*> variables) {
  int out = 1;
  for (const char* variable : variables) out = std::max(out, number_in(variable));
  return out;
}

[[noreturn]] void refuse(const std::string& why) {
  throw DataError(
      "mpirun", std::to_string(ranks_started()) + " copies were started, which would write one file; " + why);
}

const Ranks& start() {
  if (ranks_started() == 1) return alone();
#ifdef ASPERITY_MPI
  const Ranks* (*start_mpi)() = nullptr;
  try {
    start_mpi = ASPERITY_FROM_MODULE("asperity_mpi", asperity_start_mpi);
  } catch (const std::runtime_error&) {  // no such module
    refuse("MPI is not there: install asperity-mpi, or run the tool by itself");
  }
  const Ranks& ranks = *start_mpi();
  if (ranks.count() == ranks_started()) return ranks;
  refuse("the launcher is of another MPI than asperity-mpi: use Open MPI's");
#else
  refuse("this build is without MPI: run the tool by itself");
#endif
}

}  // namespace

int ranks_started() {
  const bool by_slurm = std::getenv("PMIX_RANK") != nullptr;
  return std::max(largest_of({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}),
                  by_slurm ? largest_of({"SLURM_STEP_NUM_TASKS"}) : 1);
}

int ranks_on_machine() {
  return largest_of({"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS", "SLURM_NTASKS_PER_NODE"});
}

const Ranks& launched() {
  static const Ranks& ranks = start();
  return ranks;
}

}  // namespace asperity
