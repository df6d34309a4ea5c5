#include "tools/stress/layer_rows.hpp"

namespace asperity::cli {

LayerRows::LayerRows(const StressSelection& selection, const StressSolver& solver)
    : selection_(selection), solver_(solver), layers_(size(solver.threads())) {
  for (std::size_t first = 0; const StressQuantity* q : selection.chosen()) {
    placed_.push_back({q, first});
    first += q->outputs.size();
    mises_ = mises_ || q->of_mises != 0;
    together_ = together_ || (q->needs == stress::all && (q->of_mises == 0 || !solver.by_component()));
  }
}

void LayerRows::compute(Index l, double z, StressSolver::Workspace& work, const Take& take,
                        const BehindRows& behind) {
  if (together_)
    at_once(z, work, take, behind);
  else
    one_by_one(z, work, layers_[size(l) % layers_.size()], take, behind);
}

void LayerRows::at_once(double z, StressSolver::Workspace& work, const Take& take,
                        const BehindRows& behind) const {
  auto row = [&](Index i, const StressRow& values) {
    for (const Placed& placed : placed_) hand_over(placed, values, i, take);
  };
  solver_.layer(z, selection_.needs(), work, row, behind);
}

void LayerRows::one_by_one(double z, StressSolver::Workspace& work, std::optional<MisesLayer>& mises,
                           const Take& take, const BehindRows& behind) const {
  const Extent own = solver_.rows();
  if (mises_ && !mises) mises.emplace(Shape{own.count, solver_.shape().ny});
  for (stress::Component c : stress::components) {
    const auto only = stress::Set().set(c);
    if ((selection_.needs() & only).none()) continue;
    auto take_row = [&](Index i, const StressRow& row) {
      for (const Placed& placed : placed_)
        if (placed.quantity->needs == only) hand_over(placed, row, i, take);
      if (mises) mises->add(c, i - own.first, row[c]);
      if (!mises || c != stress::yz) return;
      std::vector<double> values(row[c].size());
      for (const auto& [quantity, first] : placed_) {
        if (quantity->of_mises == 0) continue;
        mises->row(i - own.first, quantity->of_mises, values);
        take(first, i, values);
      }
    };
    solver_.layer(z, only, work, take_row, behind);
  }
}

void LayerRows::hand_over(const Placed& placed, const StressRow& row, Index i, const Take& take) const {
  const auto points = size(solver_.shape().ny);
  const std::size_t count = placed.quantity->outputs.size();
  std::vector<double> values(count * points);
  std::vector<std::span<double>> out;
  for (std::size_t k = 0; k < count; ++k) out.push_back(std::span(values).subspan(k * points, points));
  placed.quantity->compute(row, out);
  for (std::size_t k = 0; k < count; ++k) take(placed.first + k, i, out[k]);
}

}  // namespace asperity::cli
