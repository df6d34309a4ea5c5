#include "tools/cli/unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

namespace asperity::cli {
namespace {

// The power n of "m2" or "m-1"; 0 for any other unit.
int power_of_length(std::string_view unit) {
  constexpr std::array powers{-4, -3, -2, -1, 2, 3, 4};
  const auto* found = std::ranges::find_if(powers, [&](int n) { return unit == "m" + std::to_string(n); });
  return found == powers.end() ? 0 : *found;
}

// The largest length whose power brings the number to 0.01 or more, or below 1000 of a negative power.
struct Length {
  double factor;
  const char* name;
};
Length length_for(double magnitude, int n) {
  constexpr Length lengths[] = {{1, "m"}, {1e-3, "mm"}, {1e-6, "µm"}, {1e-9, "nm"}};
  if (!(magnitude > 0)) return lengths[0];
  const auto* fit = std::ranges::find_if(lengths, [&](const Length& length) {
    const double number = magnitude / std::pow(length.factor, n);
    return n > 0 ? number >= 0.01 : number < 1000;
  });
  return fit == std::end(lengths) ? *std::prev(fit) : *fit;
}

}  // namespace

std::string Unit::label(std::string_view quantity) const {
  return name.empty() ? std::string(quantity) : fmt::format("{} [{}]", quantity, name);
}

std::string superscript(int n) {
  constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = n < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(n))) out += digits[static_cast<std::size_t>(c - '0')];
  return out;
}

Unit prefixed(double magnitude, const std::string& si_unit) {
  if (si_unit.empty() || si_unit == "1") return {};
  if (si_unit != "m" && si_unit != "Pa" && si_unit != "N") return {1, si_unit};
  constexpr struct {
    double factor;
    const char* symbol;
  } prefixes[] = {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}};
  if (!(magnitude > 0)) return {1, si_unit};
  const double limit = magnitude * (1 + 1e-9);
  const auto* fit = std::ranges::find_if(prefixes, [&](const auto& p) { return limit >= p.factor; });
  if (fit == std::end(prefixes)) --fit;
  return {fit->factor, fit->symbol + si_unit};
}

Unit unit_for(double magnitude, const std::string& si_unit) {
  if (si_unit == "rad") return {std::numbers::pi / 180, "°"};
  if (si_unit == "rad m-1") {
    const Length length = length_for(magnitude, -1);
    return {1 / length.factor, std::string("rad/") + length.name};
  }
  if (si_unit == "s") {
    const Unit newtons = prefixed(std::min(magnitude, 1.0), "N");
    return {newtons.factor, newtons.name.substr(0, newtons.name.size() - 1) + "s"};
  }
  if (const int power = power_of_length(si_unit)) {
    const Length length = length_for(magnitude, power);
    return {std::pow(length.factor, power), length.name + superscript(power)};
  }
  // A prefix of the first factor is one of the whole, unless that factor has a power.
  const std::size_t first = std::min(si_unit.find_first_of(" /"), si_unit.size());
  if (first == si_unit.size()) return prefixed(magnitude, si_unit);
  const std::string factor = si_unit.substr(0, first);
  if (factor == "1") return {1, si_unit};
  const Unit out = prefixed(magnitude, factor);
  return {out.factor, out.name + si_unit.substr(first)};
}

}  // namespace asperity::cli
