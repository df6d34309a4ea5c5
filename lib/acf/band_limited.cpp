#include "acf/band_limited.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "core/words.hpp"

namespace asperity {
namespace {

constexpr double turn = 2 * std::numbers::pi;

// The model's spectrum at a wave number, by (3).
class Density {
 public:
  Density(const EllipticTarget& model, const Band& band)
      : model_(model),
        band_(band),
        radius_(model.level_radius()),
        cosine_(std::cos(model.angle)),
        sine_(std::sin(model.angle)) {}

  double operator()(double qx, double qy) const {
    const double along = cosine_ * qx + sine_ * qy, across = cosine_ * qy - sine_ * qx;
    const double e = band_.levels() ? std::min(1.0, ellipse(along, across)) : 1;
    return unlevelled(along / e, across / e);
  }

 private:
  double ellipse(double along, double across) const {
    return std::hypot(along * band_.rolloff_x, across * band_.rolloff_y) / turn;
  }

  double unlevelled(double along, double across) const {
    if (model_.model != Model::exponential_cosine) return principal(along, across);
    const double shift = turn / model_.wavelength;
    return principal(along - shift, across) + principal(along + shift, across);
  }

  double principal(double along, double across) const {
    const double a = along * model_.length_x / radius_, b = across * model_.length_y / radius_;
    return model_.spectrum(a * a + b * b);
  }

  const EllipticTarget& model_;
  const Band& band_;
  double radius_, cosine_, sine_;
};

// The waves, up to two, between -n/2 and n/2 that have the same n samples as wave `index` ≥ 0.
struct Aliases {
  std::array<Index, 2> wave{};
  std::size_t count = 0;
  Aliases(Index index, Index n) {
    if (2 * index <= n) wave[count++] = index;
    if (2 * (n - index) <= n && index > 0) wave[count++] = index - n;
  }
  std::span<const Index> waves() const { return {wave.data(), count}; }
};

struct Sides {
  double x, y;
  Sides(double spacing_x, double spacing_y, Shape period)
      : x(static_cast<double>(period.nx) * spacing_x), y(static_cast<double>(period.ny) * spacing_y) {}
};

void check_wave(const char* name, double wave, const WaveBounds& bounds) {
  check_parameter(!bounds.below(wave) && !bounds.above(wave), name,
                  number(wave) + " does not lie in " + number(bounds.least) + " ... " + number(bounds.most));
}

void check_band(const EllipticTarget& model, const Band& band, Shape period) {
  model.check();
  if (!model.has_spectrum())
    throw ParameterError("model", std::string(name_of(model.model)) +
                                      ": has no spectrum in closed form to limit; choose another model, "
                                      "such as matern");
  if (band.levels())
    for (const double wave : {band.rolloff_x, band.rolloff_y})
      check_wave("rolloff", wave, rolloff_bounds(model, period));
  if (band.levels() && model.model == Model::exponential_cosine)
    check_parameter(band.rolloff_x >= model.wavelength * (1 - WaveBounds::rounded), "rolloff",
                    number(band.rolloff_x) + ": below `wavelength`, " + number(model.wavelength) +
                        ", the wave that it would level");
  if (band.cuts()) check_wave("cutoff", band.cutoff, cutoff_bounds(model, band, period));
}

}  // namespace

double rolloff_of(const EllipticTarget& model, double length) { return turn * length / model.level_radius(); }
double length_for_rolloff(const EllipticTarget& model, double rolloff) {
  return rolloff * model.level_radius() / turn;
}

WaveBounds rolloff_bounds(const EllipticTarget& model, Shape period) {
  const Sides side(model.spacing_x, model.spacing_y, period);
  return {2 * std::max(model.spacing_x, model.spacing_y), std::min(side.x, side.y)};
}

WaveBounds cutoff_bounds(const EllipticTarget& model, const Band& band, Shape period) {
  WaveBounds out = rolloff_bounds(model, period);
  out.most = std::min({out.most, band.rolloff_x, band.rolloff_y});
  if (model.model == Model::self_affine)
    out.most = std::min(out.most, rolloff_of(model, std::min(model.length_x, model.length_y)));
  return out;
}

template <class Density>
void BandLimited::set_powers(const Density& density, double side_x, double side_y, double most) {
  double sum = 0;
  for (Index a = 0; a < period_.nx; ++a)
    for (Index b = 0; 2 * b <= period_.ny; ++b) {
      const Aliases along_x(a, period_.nx), along_y(b, period_.ny);
      double power = 0, slope = 0;
      for (Index j : along_x.waves())
        for (Index k : along_y.waves()) {
          const double qx = turn * static_cast<double>(j) / side_x,
                       qy = turn * static_cast<double>(k) / side_y;
          const double squared = qx * qx + qy * qy;
          if (squared == 0 || squared > most) continue;
          const double c = density(qx, qy);
          power += c, slope += c * squared;
        }
      const double times = b > 0 && 2 * b < period_.ny ? 2 : 1;  // in the whole spectrum
      power_[size(a * (period_.ny / 2 + 1) + b)] = power;
      sum += times * power, slope_ += times * slope;
    }
  mean_square_ = sum / (side_x * side_y);
  if (!(sum > 1e-280)) return;
  for (Complex& p : power_) p /= sum;
  slope_ /= sum;
}

BandLimited::BandLimited(const EllipticTarget& model, const Band& band, Shape period)
    : period_(period), band_(band), power_(size(period.nx * (period.ny / 2 + 1))) {
  check_band(model, band, period);
  const Sides side(model.spacing_x, model.spacing_y, period);
  set_powers(Density(model, band), side.x, side.y,
             band.cuts() ? std::pow(turn / band.cutoff * (1 + WaveBounds::rounded), 2) : Band::none);
  check_parameter(mean_square_ * side.x * side.y > 1e-280, "length",
                  "the model has no power at the waves of the band; choose others");
}

BandLimited::BandLimited(const RadialSpectrum& spectrum, std::array<double, 2> spacing, Shape period)
    : period_(period), power_(size(period.nx * (period.ny / 2 + 1))) {
  const Sides side(spacing[0], spacing[1], period);
  set_powers([&](double qx, double qy) { return spectrum(std::hypot(qx, qy)); }, side.x, side.y, Band::none);
  if (!(mean_square_ > 0))
    throw DataError("psd", "no wave of the surface is between its ends, " + number(spectrum.first()) +
                               " and " + number(spectrum.last()) +
                               " rad/m; choose another size or more samples");
}

}  // namespace asperity
