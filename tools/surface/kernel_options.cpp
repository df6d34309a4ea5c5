#include "tools/surface/kernel_options.hpp"

#include <algorithm>

#include "acf/kernel.hpp"
#include "core/words.hpp"

namespace asperity::cli {
namespace {

bool given(const Tool& tool, const char* option) { return tool.given(std::string("--") + option); }

std::vector<std::string> words(auto enumeration) {
  const auto all = enum_words(enumeration);
  return {all.begin(), all.end()};
}

double metres(const char* option, const SampledLength& length, const Spacing& spacing, std::size_t axis) {
  if (!length.samples && !spacing)
    throw UsageError(option, "a length in metres needs --spacing, or --shape and --size");
  return length.metres(spacing ? (*spacing)[axis] : 1.0);
}

// A wave of less than two samples along an axis looks like a longer one.
void refuse_aliased(const EllipticTarget& t, const std::string& wavelength) {
  if (t.model != Model::exponential_cosine) return;
  const double samples = t.wavelength / std::max(std::abs(std::cos(t.angle)) * t.spacing_x,
                                                 std::abs(std::sin(t.angle)) * t.spacing_y);
  if (samples < 2 * (1 - 1e-12))
    throw UsageError("wavelength", wavelength + ": " + number(samples) +
                                       " samples; at least 2 are needed, or it looks like a longer wave");
}

constexpr const char* side_of_surface = "shorter side of the surface";

std::string shown(double length, bool in_samples, double spacing) {
  return in_samples ? number(length / spacing) + "px" : format_quantity(length, "m");
}

// `above` says what the upper bound is.
void refuse_beyond(const char* option, const SampledLength& wave, double spacing, const WaveBounds& bounds,
                   const char* above) {
  auto words = [&](double length) { return shown(length, wave.samples, spacing); };
  const double length = wave.metres(spacing);
  if (bounds.below(length))
    throw UsageError(option, words(length) + ": below two samples, " + words(bounds.least));
  if (bounds.above(length))
    throw UsageError(option, words(length) + ": above the " + above + ", " + words(bounds.most));
}

void refuse_levelled(const EllipticTarget& model, const SampledLength& rolloff,
                     const std::string& wavelength) {
  const double length = rolloff.metres(model.spacing_x);
  if (model.model == Model::exponential_cosine && length < model.wavelength * (1 - WaveBounds::rounded))
    throw UsageError("rolloff", shown(length, rolloff.samples, model.spacing_x) + ": below --wavelength, " +
                                    wavelength + ", the wave that it would level");
}

}  // namespace

void KernelOptions::declare(Tool& tool, bool draws) {
  declare_target(tool);
  heights.declare(tool);
  declare_solution(tool, draws);
}

void KernelOptions::declare_target(Tool& tool) {
  const std::string group = "Autocorrelation";
  tool.choice("--model", target, words(Model{}),
              "Model of the autocorrelation; elliptic where two lengths are given", group);
  tool.lengths(
      "--length", length,
      "Correlation lengths along the two axes: 17px,4px or 0.4mm. There the ACF, or its envelope, is at "
      "--length-level; px counts samples of x and of y",
      group);
  tool.number("--length-level", shape.level, "ACF value at --length; 0.3678794 for 1/e lengths", group);
  tool.text("--angle", angle, "ANGLE", "Direction of the first length, from +x towards +y: 30deg, 0.5rad",
            group);
  static_assert(std::size(shape_parameters) == 4, "each has an option here");
  tool.number(
      "--smoothness", shape.smoothness,
      "Smoothness of matern; 0.5 is the exponential, infinity the Gaussian. Below 1 it is the Hurst exponent",
      group);
  tool.number("--exponent", shape.exponent, "Exponent of stretched-exponential, exp(-r^EXPONENT); up to 2",
              group);
  tool.number("--hurst", shape.hurst,
              "Hurst exponent of self-affine, up to 1. Its spectrum is flat below the roll-off", group);
  tool.lengths("--rolloff", rolloff,
               "Wavelength above which the spectrum is flat: 0.25mm or 256px; two values along the axes of "
               "--angle. Of self-affine it replaces --length; of other models it needs --periodic",
               group);
  tool.text(
      "--cutoff", cutoff, "LENGTH",
      "Shortest wavelength of a --periodic surface: 16px or 15um; px counts samples of x. A profile has "
      "none: draw a surface and take a row. The autocorrelation is that of the model's spectrum without "
      "shorter waves, and --rq that of the rest",
      group);
  tool.text("--wavelength", wavelength, "LENGTH",
            "Wavelength of exponential-cosine along its first axis: 12px or 0.1mm", group);
  tool.text(
      "--acf", acf, "FILE",
      "Table of the autocorrelation in place of a model; a dataset from asperity-acf, or one with "
      "acf_target; or "
      "text: columns under the header '# lag_x [um] lag_y [um] acf', or a matrix R(p,q); - is standard input",
      group);
}

void KernelOptions::declare_solution(Tool& tool, bool draws) {
  const std::string group = "Solution";
  tool.counts(
      "--lags", request.lags, 1,
      "Number of prescribed lags in x and y. Default: as many as --acf-tolerance needs, or all of a table",
      group);
  tool.number("--acf-tolerance", request.acf_tolerance,
              "Largest error of the ACF over all lags, as a share of the variance; if no kernel has the "
              "prescribed lags, their largest change. Above it the exit status is 3, except that an error "
              "beyond the given --lags only causes a warning",
              group);
  tool.choice(
      "--formulation", formulation, words(Formulation{}),
      "Symmetry of the kernel; symmetric: even in x and y; oriented: even under point reflection only; both "
      "meet all lags. patir: a quadrant, wrong at the mirrored lags. Default: by the target",
      group);
  std::vector<std::string> methods = words(Method{});
  std::string filter;
  if (draws) {
    methods.push_back("filter");
    filter =
        ". filter: newton-krylov for Gaussian heights, and noise so skewed that its average has --skewness "
        "and "
        "--kurtosis, where such noise exists";
  }
  tool.choice("--method", method, methods,
              "Solver of the equations. spectral: the root of the spectrum, without equations" + filter,
              group);
  tool.choice("--infeasible", infeasible, words(InfeasiblePolicy{}),
              "What to do if no kernel of --lags, or no height distribution, allows the target. auto: use a "
              "wider kernel, or the nearest feasible target if it differs by at most 1e-2; nearest: the "
              "same, however large the difference; error: refuse the target",
              group);
  tool.number("--tolerance", request.tolerance,
              "Largest residual of the equations, as a share of the variance", group);
}

EllipticTarget KernelOptions::model(const Tool& tool, const Spacing& spacing) const {
  refuse_unused(tool);
  EllipticTarget out = shape;
  out.model = enum_named<Model>(target, "model");
  out.spacing_x = spacing ? (*spacing)[0] : 1;
  out.spacing_y = spacing ? (*spacing)[1] : 1;
  const bool corner = rolloff_is_length(tool);
  auto length_along = [&](std::size_t axis) {
    if (!corner) return metres("length", length[axis], spacing, axis);
    const double wave = metres("rolloff", rolloff[axis], spacing, axis);
    check_parameter(wave >= 1e-100 && wave <= 1e100, "rolloff",
                    number(wave) + ": must lie in 1e-100 ... 1e100");
    return length_for_rolloff(out, wave);
  };
  const std::array lengths{length_along(0), length_along(1)};
  out.length_x = lengths[0], out.length_y = lengths[1];
  out.angle = parse_angle("angle", angle);
  if (!wavelength.empty())
    out.wavelength = metres("wavelength", parse_length("wavelength", wavelength), spacing, 0);
  try {
    out.check();
  } catch (const ParameterError& e) {
    throw ParameterError(e.name == "length" ? length_option(tool) : e.name, e.what());
  }
  refuse_aliased(out, wavelength);
  return out;
}

void KernelOptions::refuse_unused(const Tool& tool) const {
  const bool corner = rolloff_is_length(tool);
  if (!tool.given("--length") && !corner)
    throw UsageError("length", target == "self-affine" ? "is required, or --rolloff"
                               : tool.given("--rolloff")
                                   ? "is required: --rolloff is the length of self-affine only"
                                   : "is required");
  for (const char* option : {"length", "length-level"})
    if (corner && given(tool, option))
      throw UsageError(option, "cannot be combined with --rolloff, which is the length of self-affine");
  for (const ShapeParameter& parameter : shape_parameters)
    if (const std::string owner(name_of(parameter.model)); given(tool, parameter.name) && target != owner)
      throw UsageError(parameter.name, "belongs to --model " + owner + ", not to " + target);
  if (target == "exponential-cosine" && wavelength.empty())
    throw UsageError("wavelength", "is required by --model exponential-cosine");
}

bool KernelOptions::rolloff_is_length(const Tool& tool) const {
  return tool.given("--rolloff") && target == "self-affine";
}

std::optional<BandLimited> KernelOptions::band(const Tool& tool, const EllipticTarget& model,
                                               Shape period) const {
  const bool levels = tool.given("--rolloff") && !rolloff_is_length(tool);
  if (cutoff.empty() && !levels) return std::nullopt;
  const std::string limit = cutoff.empty() ? "rolloff" : "cutoff";
  if (period == Shape{})
    throw UsageError(
        limit, (cutoff.empty() ? "needs --periodic, or --model self-affine" : cutoff + ": needs --periodic") +
                   "; otherwise the autocorrelation does not end, and a kernel must");
  refuse_beside(tool, limit);
  if (std::min(period.nx, period.ny) == 1)
    throw UsageError(limit, (cutoff.empty() ? "" : cutoff + ": ") + "needs a surface: the waves of " +
                                text(period) +
                                " points run along one axis; draw a surface and take a row of it "
                                "(asperity-filter --crop)");
  const Band band = model.has_spectrum() ? band_of(tool, model, period) : Band{};
  check_memory(periodic_kernel_cost(period), static_cast<double>(tool.memory()), period);
  return BandLimited(model, band, period);
}

Band KernelOptions::band_of(const Tool& tool, const EllipticTarget& model, Shape period) const {
  Band out;
  if (tool.given("--rolloff") && !rolloff_is_length(tool)) {
    out.rolloff_x = rolloff[0].metres(model.spacing_x), out.rolloff_y = rolloff[1].metres(model.spacing_y);
    const WaveBounds bounds = rolloff_bounds(model, period);
    refuse_beyond("rolloff", rolloff[0], model.spacing_x, bounds, side_of_surface);
    refuse_beyond("rolloff", rolloff[1], model.spacing_y, bounds, side_of_surface);
    refuse_levelled(model, rolloff[0], wavelength);
  }
  if (cutoff.empty()) return out;
  const SampledLength shortest_wave = parse_length("cutoff", cutoff);
  const WaveBounds bounds = cutoff_bounds(model, out, period);
  refuse_beyond("cutoff", shortest_wave, model.spacing_x, bounds,
                bounds.most < rolloff_bounds(model, period).most ? "roll-off" : side_of_surface);
  out.cutoff = shortest_wave.metres(model.spacing_x);
  return out;
}

void KernelOptions::refuse_beside(const Tool& tool, const std::string& limit) const {
  for (const char* option : {"lags", "formulation", "infeasible"})
    if (given(tool, option))
      throw UsageError(option, "cannot be combined with --" + limit + ", which leaves no equations to solve");
  if (given(tool, "method") && !filters())
    throw UsageError(
        "method", method + ": cannot be combined with --" + limit + ", which leaves no equations to solve");
  if (const std::string option = MarginalOptions::given(tool); !option.empty() && !filters())
    throw UsageError(option, "cannot be combined with --" + limit +
                                 ": the translation of heights makes waves beyond the band; "
                                 "asperity-generate --method filter makes none");
}

void KernelOptions::refuse_model(const Tool& tool) const {
  std::vector<const char*> options{"model", "length", "length-level", "angle", "rolloff", "cutoff"};
  for (const ShapeParameter& parameter : shape_parameters) options.push_back(parameter.name);
  for (const char* option : options)
    if (given(tool, option))
      throw UsageError(option, "cannot be combined with --acf, which gives the whole autocorrelation");
}

}  // namespace asperity::cli
