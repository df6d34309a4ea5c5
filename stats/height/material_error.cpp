#include "stats/height/material_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity {
namespace {

constexpr double core_width = 0.4;

// Heights at which classes end, ascending, but for the last one.
std::vector<double> class_edges(const MaterialRatioCurve& curve, const CoreParameters& core,
                                const std::array<double, 2>& ratios, double points) {
  constexpr int equal = 512;
  std::vector<double> out{core.upper, core.lower, curve.height(ratios[0]), curve.height(ratios[1])};
  for (const double p : sxp_ratios) out.push_back(curve.height(p));
  for (int k = 1; k < equal; ++k) out.push_back(curve.height(static_cast<double>(k) / equal));
  for (double share = 0.5 / equal; share * points > 1; share /= 2)
    for (const double p : {share, 1 - share}) out.push_back(curve.height(p));
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

// Functions of the height, a value for each class.
class HeightInfluence {
 public:
  using Values = Eigen::ArrayXd;

  HeightInfluence(const Field& z, const Grid& grid, const FieldExtent& extent,
                  const MaterialRatioCurve& curve, std::vector<double> edges)
      : curve_(curve),
        edges_(std::move(edges)),
        of_shares_(grid, extent, std::ssize(edges_) + 1),
        height_(std::ssize(edges_) + 1),
        below_(height_.size()) {
    of_shares_.add(z, [this](double height) { return class_of(height); });
    double sum = 0;
    for (Index b = 0; b < height_.size(); ++b) {
      const double share = of_shares_.share(b);
      height_(b) = share > 0 ? of_shares_.mean_of(b) : edges_[size(std::min(b, std::ssize(edges_) - 1))];
      below_(b) = sum += share;
    }
  }

  const Values& height() const { return height_; }
  Values above(double level) const { return (height_ - level).max(0); }
  Values beneath(double level) const { return (level - height_).max(0); }
  double mean(const Values& f) const {
    double out = 0;
    for (Index b = 0; b < f.size(); ++b) out += of_shares_.share(b) * f(b);
    return out;
  }
  Values centred(const Values& f) const { return f - mean(f); }
  WaveError error(const Values& influence) const {
    ShareErrors::Function f(of_shares_);
    for (Index b = 0; b < influence.size(); ++b) f.add(b, influence(b));
    return f.error();
  }
  // 1 above a class edge.
  Values higher(double edge) const {
    const Index last = class_of(edge);
    return Values::NullaryExpr(height_.size(), [last](Index b) { return b > last ? 1.0 : 0.0; });
  }
  // (2).
  double density(double p) const {
    const double delta = std::max({std::min({0.05, p / 2, (1 - p) / 2}), 3 / of_shares_.points()}),
                 high = std::max(p - delta, 0.0), low = std::min(p + delta, 1.0);
    const double here = curve_.height(p), beside = delta / 4;
    if (curve_.height(std::max(p - beside, 0.0)) == here || curve_.height(std::min(p + beside, 1.0)) == here)
      return std::numeric_limits<double>::quiet_NaN();  // a step
    return (low - high) / (curve_.height(high) - curve_.height(low));
  }
  // (1).
  Values of_height(double p) const { return centred(higher(curve_.height(p))) / density(p); }
  // (3), of weights j(p).
  template <class Weight>
  Values of_line(Weight j) const {
    Values out(height_.size());
    out(0) = 0;
    for (Index b = 0; b + 1 < out.size(); ++b)
      out(b + 1) = out(b) + j(1 - below_(b)) * (height_(b + 1) - height_(b));
    return centred(out);
  }

 private:
  Index class_of(double height) const { return std::ranges::lower_bound(edges_, height) - edges_.begin(); }

  const MaterialRatioCurve& curve_;
  std::vector<double> edges_;
  ShareErrors of_shares_;
  Values height_, below_;  // below_: the share up to the end of the class
};

using Values = HeightInfluence::Values;

WaveError of_fall(const HeightInfluence& of, const std::array<double, 2>& ratios) {
  return of.error(of.of_height(ratios[0]) - of.of_height(ratios[1]));
}

// Whether starts whose fall is within three errors of the least are apart: those between fall by five errors
// more, which is no noise of a few heights.
bool has_rivals(const HeightInfluence& of, const MaterialRatioCurve& curve, double begin) {
  constexpr int starts = 300;
  constexpr double room = 1 - core_width, near_least = 3, beyond = 5;
  auto end_of = [](double p) { return std::min(p + core_width, 1.0); };
  auto fall = [&](double p) { return curve.height(p) - curve.height(end_of(p)); };
  const double error = of_fall(of, {begin, end_of(begin)}).error;
  int stretches = 0;
  bool within = false;
  for (int k = 0; k <= starts; ++k) {
    const bool now = fall(room * k / starts) <= fall(begin) + (within ? beyond : near_least) * error;
    stretches += now && !within;
    within = now;
  }
  return stretches != 1;  // none by an error that is not known
}

void add_core(MaterialErrors& out, const HeightInfluence& of, const CoreParameters& core) {
  const double middle = core.begin + core_width / 2, r1 = core.smr1, r2 = core.smr2;
  auto tilt = [&](double p) {
    return std::abs(p - middle) <= core_width / 2 ? 12 * (p - middle) / std::pow(core_width, 3) : 0;
  };
  auto level = [&](double p) {
    return (std::abs(p - middle) <= core_width / 2 ? 1 / core_width : 0) - middle * tilt(p);
  };
  const Values of_slope = of.of_line(tilt), of_upper = of.of_line(level), of_lower = of_upper + of_slope;
  out.sk = of.error(of_slope), out.upper = of.error(of_upper), out.lower = of.error(of_lower);
  if (r1 > 0) {
    const Values of_ratio = of.centred(of.higher(core.upper)) - of.density(r1) * of_upper,
                 peaks = of.above(core.upper), of_area = of.centred(peaks) - r1 * of_upper;
    out.smr1 = of.error(of_ratio), out.sak1 = of.error(of_area);
    out.spk = of.error(2 * of_area / r1 - 2 * of.mean(peaks) * of_ratio / (r1 * r1));
  }
  if (r2 < 1) {
    const Values of_ratio = of.centred(of.higher(core.lower)) - of.density(r2) * of_lower,
                 dales = of.beneath(core.lower), of_area = of.centred(dales) + (1 - r2) * of_lower;
    const double base = 1 - r2;
    out.smr2 = of.error(of_ratio), out.sak2 = of.error(of_area);
    out.svk = of.error(2 * of_area / base + 2 * of.mean(dales) * of_ratio / (base * base));
  }
}

void add_volumes(MaterialErrors& out, const HeightInfluence& of, const MaterialRatioCurve& curve,
                 const std::array<double, 2>& ratios) {
  auto material = [&](double p) -> Values {
    return of.centred(of.above(curve.height(p))) - p * of.of_height(p);
  };
  auto voids = [&](double p) -> Values {
    return of.centred(of.beneath(curve.height(p))) + (1 - p) * of.of_height(p);
  };
  const auto [p, q] = ratios;
  const Values vmp = material(p), vvv = voids(q);
  out.vmp = of.error(vmp);
  out.vmc = of.error(material(q) - vmp);
  out.vvc = of.error(voids(p) - vvv);
  out.vvv = of.error(vvv);
}

}  // namespace

MaterialErrors material_errors(const Field& z, const Grid& grid, const FieldExtent& extent,
                               const MaterialRatioCurve& curve, const std::array<double, 2>& ratios) {
  const CoreParameters core = curve.core();
  const double points = static_cast<double>((!z.isNaN()).count());
  const HeightInfluence of(z, grid, extent, curve, class_edges(curve, core, ratios, points));
  MaterialErrors out{.core_may_be_elsewhere = has_rivals(of, curve, core.begin)};
  add_core(out, of, core);
  add_volumes(out, of, curve, ratios);
  out.sdc = of_fall(of, ratios), out.sxp = of_fall(of, sxp_ratios);
  return out;
}

}  // namespace asperity
