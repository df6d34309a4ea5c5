// Writes SUR and PRO, as lib/formats/sur.cpp describes them.
#include <algorithm>
#include <cmath>
#include <limits>

#include "formats/raster.hpp"
#include "formats/refuse.hpp"
#include "formats/sur_head.hpp"

namespace asperity {
namespace {

using namespace sur;

// Whole numbers of a step that is a float, from a height of zero that is one.
struct Steps {
  Field numbers;
  float step = 1, zero = 0;
};

float single(double value, bool positive) {
  using Limits = std::numeric_limits<float>;
  if (!(std::abs(value) <= Limits::max()) || (positive && value < Limits::min()))
    refuse("{} does not fit into the single precision of SUR", shortest(value));
  return static_cast<float>(value);
}

Steps sur_steps(const Field& values) {
  const double half = std::ldexp(1.0, 30);
  if (values.isNaN().all()) return {Field::Zero(values.rows(), values.cols())};
  const double low = values.minCoeff<Eigen::PropagateNumbers>(),
               high = values.maxCoeff<Eigen::PropagateNumbers>();
  Steps out;
  out.zero = single(low + (high - low) / 2, false);
  const double reach = std::max(high - out.zero, out.zero - low);
  constexpr float least_step = std::numeric_limits<float>::min(), largest = std::numeric_limits<float>::max();
  if (reach > 0) out.step = std::max(std::nextafter(single(reach / half, false), largest), least_step);
  const double zero = out.zero;  // of what is missing, too: within the range
  out.numbers = ((values.isNaN().select(zero, values) - zero) / out.step).round();
  return out;
}

template <class T>
void put(std::string& head, Place place, T number, std::size_t index = 0) {
  std::ranges::copy(bytes_of(number, order),
                    head.begin() + static_cast<std::ptrdiff_t>(place + index * sizeof number));
}

void put_text(std::string& head, Place place, std::string_view text, std::size_t size,
              std::size_t index = 0) {
  text = text.substr(0, size);
  head.replace(place + index * size, text.size(), text);
}

// As many whole characters as there is place for.
std::string shortened(std::string text, std::size_t size) {
  if (text.size() > size) text.resize(size);
  while (!is_utf8(text)) text.pop_back();
  return text;
}

std::string sur_head(const Map& map) {
  std::string out(head_size, '\0');
  const Shape shape = shape_of(map.values);
  put_text(out, Place{0}, plain, plain.size());
  put(out, objects, std::int16_t{1});
  put(out, version, std::int16_t{1});
  put(out, object_type, static_cast<std::int16_t>(shape.ny > 1 ? 2 : 1));
  put_text(out, object_name, std::string(name_size, ' '), name_size);
  put_text(out, object_name, shortened(one_line(map.title), name_size), name_size);
  put(out, absolute, std::int16_t{1});
  put(out, bits, std::int16_t{32});
  put(out, points_per_line, static_cast<std::int32_t>(shape.nx));
  put(out, lines, static_cast<std::int32_t>(shape.ny));
  put(out, points, static_cast<std::int32_t>(shape.cells()));
  const std::string height = map.units.empty() || map.units == "m" ? "\xb5m" : map.units;
  const std::string names[] = {"X", "Y", "Z"}, units[] = {"mm", "mm", height};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put_text(out, axis_names, names[axis], unit_size, axis);
    put_text(out, step_units, units[axis], unit_size, axis);
    put_text(out, axis_units, units[axis], unit_size, axis);
    put(out, unit_ratios, 1.f, axis);
    if (axis < 2) put(out, steps, single(1e3 * map.spacing[axis], true), axis);
  }
  return out;
}

}  // namespace

std::string encode_sur(const Map& map, Order) {
  check_size(map, "SUR");
  if (map.units.size() >= unit_size)
    refuse("SUR holds units of 15 characters, not '{}'", one_line(map.units, 24));
  if (map.values.size() > std::numeric_limits<std::int32_t>::max())
    refuse("SUR holds at most 2^31 - 1 points, the map has {} x {}", map.values.rows(), map.values.cols());
  const bool lengths = map.units.empty() || map.units == "m";
  Steps steps_in = sur_steps(lengths ? Field(1e6 * map.values) : map.values);
  std::string out = sur_head(map);
  const double low = steps_in.numbers.minCoeff(), high = steps_in.numbers.maxCoeff();
  put(out, least, static_cast<std::int32_t>(low));
  put(out, greatest, static_cast<std::int32_t>(high));
  put(out, steps, steps_in.step, 2);
  put(out, zero_height, steps_in.zero);
  if (map.values.hasNaN()) {
    put(out, special, std::int16_t{1});
    steps_in.numbers = map.values.isNaN().select(low - 2, steps_in.numbers);
  }
  return out + bytes_of(steps_in.numbers, {.type = NumberType::int32});
}

}  // namespace asperity
