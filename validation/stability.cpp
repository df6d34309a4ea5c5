/// Stiff and extreme cases of every stage, and what becomes of each.
///
///     stability [STAGE]         kernel, surface, marginal, statistics, contact or stress; all unless given
///
/// stage, case   what is computed
/// hard          what makes it hard
/// outcome       the answer's own words: how it converged or what it changed; or the message that it is refused with
/// measure       what the figure is
/// figure        that an answer is judged by
/// bound         that it must not exceed
/// holds         whether it does not, and what has no answer is refused
///
/// No case may end in another way: not in a crash, not in a number that is none, not in silence.
#include "stability.hpp"

#include <string>

using namespace asperity;

int main(int argc, char** argv) {
  const std::string asked = argc > 1 ? argv[1] : "";
  fmt::print("# stage\tcase\thard\toutcome\tmeasure\tfigure\tbound\tholds\n");
  auto stage = [&](const char* name, void (*print)()) {
    if (asked.empty() || asked == name) print();
  };
  stage("kernel", kernel_stability);
  stage("surface", surface_stability);
  stage("marginal", marginal_stability);
  stage("statistics", statistics_stability);
  stage("contact", contact_stability);
  stage("stress", stress_stability);
  return 0;
}
