#include "tools/surface/spectrum_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "acf/band_limited.hpp"
#include "acf/kernel.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "dataset/units.hpp"
#include "tools/cli/plain_text.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/cli/stream.hpp"
#include "transform/plan.hpp"

namespace asperity::cli {
namespace {

[[noreturn]] void refuse_spectrum(const std::string& message) { throw DataError("psd", message); }

// ---- columns ----

struct SpectrumColumns {
  HeadedColumn wave, density;
  SpectrumRows rows;
  bool rings = false;                        // of asperity-psd
  std::vector<std::string> directions = {};  // of profiles along several
  double lay() const;
};

struct SpectrumPlaces {
  std::size_t wave, density;
};

std::optional<SpectrumPlaces> places_in(const std::vector<HeadedColumn>& columns) {
  auto any_of = [&](std::initializer_list<const char*> names) -> std::optional<std::size_t> {
    for (const char* name : names)
      if (const auto found = place(columns, name)) return found;
    return std::nullopt;
  };
  const auto wave = any_of({"wave_number", "wavenumber", "q", "frequency", "spatial_frequency", "f"}),
             density = any_of({"psd", "PSD", "C"});
  if (!wave || !density) return std::nullopt;
  return SpectrumPlaces{*wave, *density};
}

// Rows before the header are those of another table, or its title.
SpectrumColumns columns_in_text(std::string_view bytes) {
  SpectrumColumns out;
  std::vector<HeadedColumn> columns;
  std::optional<SpectrumPlaces> at;
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);  // of UTF-8
  for (std::size_t line = 1; !bytes.empty(); ++line) {
    std::string_view text = bytes.substr(0, bytes.find('\n'));
    bytes.remove_prefix(std::min(text.size() + 1, bytes.size()));
    const bool comment = text.starts_with('#');
    if (!at) {
      columns = columns_of(text.substr(comment ? 1 : 0));
      at = places_in(columns);
      continue;
    }
    const std::vector<std::string_view> words = words_of(text);
    if (comment || words.empty()) continue;
    if (words.size() != columns.size())
      refuse_spectrum("line " + std::to_string(line) + " has " +
                      counted(static_cast<std::int64_t>(words.size()), "word") + ", its header " +
                      counted(static_cast<std::int64_t>(columns.size()), "name"));
    out.rows.q.push_back(number_of(words[at->wave], line, "psd"));
    out.rows.density.push_back(number_of(words[at->density], line, "psd"));
    if (const auto direction = place(columns, "direction")) out.directions.emplace_back(words[*direction]);
  }
  if (!at)
    refuse_spectrum(
        "no line names the columns wave_number, or frequency, and psd with their units, such as "
        "'# wave_number [rad/m] psd [m4]'");
  out.wave = columns[at->wave], out.density = columns[at->density];
  out.rings = place(columns, "count").has_value();
  return out;
}

SpectrumColumns columns_in_json(std::string_view bytes) try {
  const auto table = nlohmann::json::parse(bytes);
  std::vector<HeadedColumn> columns;
  for (const auto& [name, column] : table.items()) {
    const bool has_unit = column.is_object() && column.contains("unit") && column["unit"].is_string();
    columns.push_back({name, has_unit ? column["unit"].get<std::string>() : ""});
  }
  const auto at = places_in(columns);
  if (!at) refuse_spectrum("its object has no wave_number, or frequency, and psd");
  auto values = [&](const HeadedColumn& column) {
    return table.at(column.name).at("values").get<std::vector<double>>();
  };
  SpectrumColumns out{columns[at->wave], columns[at->density], {}};
  out.rows = {values(out.wave), values(out.density)};
  out.rings = place(columns, "count").has_value();
  if (place(columns, "direction"))
    out.directions = table.at("direction").at("values").get<std::vector<std::string>>();
  if (out.rows.q.size() != out.rows.density.size())
    refuse_spectrum(out.wave.name + " and " + out.density.name + " have not as many values");
  return out;
} catch (const nlohmann::json::exception&) {
  refuse_spectrum("is no JSON object of columns with a unit and values, all numbers");
}

// ---- units ----

bool mentions(std::string_view unit, std::string_view word) {
  return unit.find(word) != std::string_view::npos;
}

// To rad/m. UDUNITS has a cycle as 2π radians.
double wave_factor(const HeadedColumn& wave) try {
  const bool cycles = wave.name != "q" && !mentions(wave.name, "wave");
  if (wave.unit.empty()) refuse_spectrum("its column " + wave.name + " has no unit, such as [rad/um]");
  const double factor = unit_factor(wave.unit, "rad m-1");
  if (mentions(wave.unit, "rad") || mentions(wave.unit, "cycle")) return factor;
  if (!cycles && wave.name != "q")
    refuse_spectrum(wave.name + " [" + wave.unit +
                    "] may count radians or cycles: give it the unit rad/m or cycles/m, or name it q "
                    "(2 pi / wavelength) or frequency");
  return factor * (cycles ? 2 * std::numbers::pi : 1);
} catch (const std::invalid_argument& e) {
  refuse_spectrum(wave.name + ": " + e.what());
}

struct DensityUnit {
  double factor;
  bool of_profiles;
};

DensityUnit density_unit(const HeadedColumn& density) {
  const bool per_angle = mentions(density.unit, "rad") || mentions(density.unit, "cycle");
  for (const char* unit : {"m4", "m3"}) try {
      if (!per_angle) return {unit_factor(density.unit, unit), unit[1] == '3'};
    } catch (const std::invalid_argument&) {
      continue;
    }
  refuse_spectrum(density.name + " has the unit [" + density.unit +
                  "]: m4 or the like is needed, of an isotropic surface, or m3 of profiles");
}

// ---- rows ----

// Of both directions, in one order; the mean where they share a wave number.
SpectrumRows merged(const SpectrumRows& rows) {
  std::map<double, std::pair<double, double>> means;  // and how many
  for (std::size_t i = 0; i < rows.q.size(); ++i) {
    auto& [mean, count] = means[rows.q[i]];
    mean += (rows.density[i] - mean) / ++count;
  }
  SpectrumRows out;
  for (const auto& [q, mean] : means) out.q.push_back(q), out.density.push_back(mean.first);
  return out;
}

SpectrumRows without_zero(const SpectrumRows& rows) {
  SpectrumRows out;
  for (std::size_t i = 0; i < rows.q.size(); ++i)
    if (rows.q[i] != 0) out.q.push_back(rows.q[i]), out.density.push_back(rows.density[i]);
  return out;
}

// Each direction has rows from 0 on at even steps, the first of which is its step.
double SpectrumColumns::lay() const {
  std::map<std::string, std::pair<double, double>> sums;  // of q² C1, and the step
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (rows.q[i] == 0) continue;
    auto& [slope, step] = sums[directions[i]];
    slope += rows.q[i] * rows.q[i] * rows.density[i];
    if (step == 0) step = rows.q[i];
  }
  if (sums.size() != 2) return 1;
  const auto [first, second] = std::pair(sums.begin()->second, sums.rbegin()->second);
  const double ratio = first.first * first.second / (second.first * second.second);
  return std::max(ratio, 1 / ratio);
}

// The first ring, or wave number of a profile, as far as it reaches: half a step from 0.
SpectrumRows from_half(SpectrumRows rows, double step) {
  rows.q.insert(rows.q.begin(), step / 2), rows.density.insert(rows.density.begin(), rows.density.front());
  return rows;
}

SpectrumRows whole_rings(SpectrumRows rows) {
  const double steps = static_cast<double>(rows.q.size()) - 1;
  return steps < 1 ? rows : from_half(rows, (rows.q.back() - rows.q.front()) / steps);
}

SpectrumTable spectrum_of_columns(SpectrumColumns columns) {
  const double to_wave = wave_factor(columns.wave);
  const auto [to_density, of_profiles] = density_unit(columns.density);
  SpectrumRows& rows = columns.rows;
  for (double& q : rows.q) q *= to_wave;
  for (double& density : rows.density) density *= to_density;
  if (!of_profiles) return {RadialSpectrum(columns.rings ? whole_rings(rows) : rows)};
  SpectrumRows profiles = without_zero(rows);
  if (!columns.directions.empty()) {
    profiles = merged(profiles);
    if (!profiles.q.empty()) profiles = from_half(profiles, profiles.q.front());
  }
  ProfileSpectrum found = spectrum_of_profiles(profiles);
  return {std::move(found.spectrum), false, found.change, found.beyond, columns.lay()};
}

// ---- datasets ----

std::vector<double> wave_numbers(const Dataset& data, const std::string& name) {
  const Variable& axis = data.at(name);
  std::vector<double> out = numbers(axis.values);
  if (out.size() < 2)
    refuse_spectrum("the dataset is of one profile: name its table, asperity-psd --result profiles");
  for (double& q : out) q *= factor_to("rad m-1", axis);
  return out;
}

// Over one wave number, as arrays of a program come.
SpectrumTable spectrum_of_row(const Dataset& data) {
  const Variable &psd = data.at("psd"), &wave = data.at(psd.dimensions[0]);
  return spectrum_of_columns(
      {{wave.name, unit_of(wave)}, {psd.name, unit_of(psd)}, {numbers(wave.values), numbers(psd.values)}});
}

// The means over rings as wide as the larger step, short of the wave of two points.
SpectrumTable spectrum_of_dataset(const Dataset& data) {
  if (!data.has("psd")) refuse_spectrum("the dataset has none; asperity-psd adds it");
  if (data.at("psd").dimensions.size() == 1) return spectrum_of_row(data);
  const Field psd = table_of(data, "psd", "m4");
  const std::vector<std::string>& axes = data.at("psd").dimensions;
  const std::vector<double> x = wave_numbers(data, axes[0]), y = wave_numbers(data, axes[1]);
  const double step = std::max(x[1] - x[0], y[1] - y[0]), most = std::min(x.back(), y.back());
  const double rings = std::floor(most / step - 0.5);
  std::vector<std::array<double, 3>> sums(static_cast<std::size_t>(std::max(rings, 0.0)));
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < y.size(); ++j) {
      const double q = std::hypot(x[i], y[j]), ring = std::floor(q / step + 0.5), weight = i > 0 ? 2 : 1;
      if (!(ring >= 1 && ring <= rings)) continue;
      auto& [count, wave, power] = sums[static_cast<std::size_t>(ring) - 1];
      count += weight, wave += weight * q;
      power += weight * psd(static_cast<Index>(i), static_cast<Index>(j));
    }
  SpectrumRows rows;
  for (const auto& [count, wave, power] : sums)
    rows.q.push_back(wave / count), rows.density.push_back(power / count);
  return {RadialSpectrum(whole_rings(std::move(rows))), true};
}

}  // namespace

SpectrumTable read_spectrum_table(const std::string& name, const MemoryBound& memory) {
  const Bytes bytes = read_all(name, memory);
  if (looks_like_netcdf(bytes)) return spectrum_of_dataset(decode_netcdf(bytes, memory.beside(bytes.size())));
  const std::string_view text = bytes;
  return spectrum_of_columns(text.starts_with('{') ? columns_in_json(text) : columns_in_text(text));
}

// ---- on a surface ----

namespace {

constexpr double much = 0.05, little = 5e-4;  // shares of the variance
constexpr double strong_lay = 2;              // of mean square slopes

std::string share(double of, const char* what) {
  return of < little ? "" : fmt::format("; {:.2g} % of the variance {}", 100 * of, what);
}

// What of the spectrum is told of surfaces with this side and these samples.
void tell_of_spectrum(const Tool& tool, const std::string& name, const SpectrumTable& table,
                      const std::array<double, 2>& spacing, Shape surface, bool periodic, double rms) {
  const RadialSpectrum& c = table.spectrum;
  const double lowest = periodic ? 0.5 : 1,  // the lowest wave of a period stands for those up to half of it
      longest = std::max(spacing[0] * static_cast<double>(surface.nx),
                         spacing[1] * static_cast<double>(surface.ny)),
               all = c.mean_square(c.first(), c.last()),
               below = c.mean_square(c.first(), lowest * 2 * std::numbers::pi / longest) / all,
               beyond =
                   c.mean_square_beyond(std::numbers::pi / spacing[0], std::numbers::pi / spacing[1]) / all;
  auto length = [](double value) { return format_quantity(std::stod(number(value)), "m"); };
  auto wave = [&](double q) { return length(2 * std::numbers::pi / q); };
  std::string text = "--psd " + name + ": waves of " + wave(c.last()) + " to " + wave(c.first()) +
                     ", none beyond; own rms height " + length(rms);
  const bool warns = table.lay > strong_lay || std::max({beyond + below, table.change, table.beyond}) > much;
  if (table.lay > strong_lay)
    text += fmt::format(
        "; the profiles of x and y differ, by {:.2g} in the mean square slope: the surface is "
        "isotropic",
        table.lay);
  if (table.over_rings) text += "; the mean over all directions";
  text += share(table.change, "changed, where these profiles are not those of an isotropic surface") +
          share(table.beyond, "left out beyond their last row, by their fall there") +
          share(beyond, "not shown, in waves below two samples") +
          share(below, "in waves longer than the surface");
  warns ? tool.warn(text) : tool.note(text);
}

}  // namespace

AcfTable acf_of_spectrum(const Tool& tool, const std::string& name, const Spacing& spacing, Shape surface,
                         bool periodic) {
  if (!spacing || surface == Shape{})
    throw UsageError("psd", "needs --shape, and --size or --spacing: its waves are in metres");
  if (name == "-" && stdin_is_terminal()) throw UsageError("psd", "no input: pipe a table in or name a file");
  if (std::min(surface.nx, surface.ny) == 1)
    throw UsageError("psd", "needs a surface, not the profile " + text(surface) +
                                ": draw one and take a row of it (asperity-filter --crop)");
  tool.reads(name);
  const SpectrumTable table = read_spectrum_table(name, tool.memory_bound());
  const Shape torus = periodic ? surface : Shape{fast_length(2 * surface.nx), fast_length(2 * surface.ny)};
  check_memory(periodic_kernel_cost(torus), static_cast<double>(tool.memory()), torus);
  const BandLimited waves(table.spectrum, *spacing, torus);
  AcfTable out;
  out.rms = std::sqrt(waves.mean_square());
  out.half_plane = waves.correlation() * waves.mean_square();
  out.spacing = spacing;
  out.period = torus;
  if (!periodic) out.corner = surface;
  out.option = "psd";
  tell_of_spectrum(tool, name, table, *spacing, surface, periodic, out.rms);
  return out;
}

}  // namespace asperity::cli
