#include "core/parallel.hpp"

namespace asperity {
namespace {

thread_local bool alone = false;

}  // namespace

bool works_alone() { return alone; }
void work_alone() { alone = true; }

}  // namespace asperity
