#include "tools/surface/kernel_options.hpp"

#include <algorithm>
#include <cmath>

#include "acf/kernel.hpp"
#include "acf/table.hpp"
#include "core/words.hpp"
#include "tools/surface/periodic_kernel.hpp"
#include "transform/plan.hpp"

namespace asperity::cli {
namespace {

std::vector<std::string> words(auto enumeration) {
  const auto all = enum_words(enumeration);
  return {all.begin(), all.end()};
}

}  // namespace

void KernelOptions::declare(Tool& tool, bool draws) {
  declare_target(tool);
  declare_tables(tool);
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
}

void KernelOptions::declare_tables(Tool& tool) {
  const std::string group = "Autocorrelation";
  tool.text(
      "--acf", acf, "FILE",
      "Table of the autocorrelation in place of a model; a dataset from asperity-acf, or one with "
      "acf_target; or "
      "text: columns under the header '# lag_x [um] lag_y [um] acf', or a matrix R(p,q); - is standard input",
      group);
  tool.text(
      "--psd", psd, "FILE",
      "Table of the power spectral density in place of a model; a table or a dataset of asperity-psd, or "
      "text: columns under the header '# wave_number [rad/um] psd [um4]', in um3 of profiles of an isotropic "
      "surface; both two-sided. frequency [1/um] counts cycles. Power laws between rows, nothing beyond; "
      "without --rq its own height. - is standard input",
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
              "prescribed lags, their largest change; 0.01 of a map's (--like, asperity-acf --taper). Above "
              "it the exit status is 3, except that an error "
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
        "and --kurtosis, where such noise exists";
  }
  tool.choice("--method", method, methods,
              "Solver of the equations. spectral: the root of the spectrum, without equations" + filter,
              group);
  tool.choice(
      "--infeasible", infeasible, words(InfeasiblePolicy{}),
      "What to do if no kernel of --lags, or no height distribution, allows the target. auto: use a "
      "wider kernel, or the nearest feasible target if it differs by at most 1e-2, or by more where the "
      "target is a map's (--like, asperity-acf --taper) and its heights are not Gaussian; nearest: the same, "
      "however large the difference; error: refuse the target",
      group);
  tool.number("--tolerance", request.tolerance,
              "Largest residual of the equations, as a share of the variance", group);
}

bool KernelOptions::rolloff_is_length(const Tool& tool) const {
  return tool.given("--rolloff") && target == "self-affine";
}

namespace {

// ---- a model ----

bool given(const Tool& tool, const char* option) { return tool.given(std::string("--") + option); }

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

void refuse_unused(const Tool& tool, const KernelOptions& o) {
  const bool corner = o.rolloff_is_length(tool);
  if (!tool.given("--length") && !corner)
    throw UsageError("length", o.target == "self-affine" ? "is required, or --rolloff"
                               : tool.given("--rolloff")
                                   ? "is required: --rolloff is the length of self-affine only"
                                   : "is required");
  for (const char* option : {"length", "length-level"})
    if (corner && given(tool, option))
      throw UsageError(option, "cannot be combined with --rolloff, which is the length of self-affine");
  for (const ShapeParameter& parameter : shape_parameters)
    if (const std::string owner(name_of(parameter.model)); given(tool, parameter.name) && o.target != owner)
      throw UsageError(parameter.name, "belongs to --model " + owner + ", not to " + o.target);
  if (o.target == "exponential-cosine" && o.wavelength.empty())
    throw UsageError("wavelength", "is required by --model exponential-cosine");
}

// The model of --model, its lengths in metres, or in samples where no spacing is known.
EllipticTarget model_of(const Tool& tool, const KernelOptions& o, const Spacing& spacing) {
  refuse_unused(tool, o);
  EllipticTarget out = o.shape;
  out.model = enum_named<Model>(o.target, "model");
  out.spacing_x = spacing ? (*spacing)[0] : 1;
  out.spacing_y = spacing ? (*spacing)[1] : 1;
  const bool corner = o.rolloff_is_length(tool);
  auto length_along = [&](std::size_t axis) {
    if (!corner) return metres("length", o.length[axis], spacing, axis);
    const double wave = metres("rolloff", o.rolloff[axis], spacing, axis);
    check_parameter(wave >= 1e-100 && wave <= 1e100, "rolloff",
                    number(wave) + ": must lie in 1e-100 ... 1e100");
    return length_for_rolloff(out, wave);
  };
  const std::array lengths{length_along(0), length_along(1)};
  out.length_x = lengths[0], out.length_y = lengths[1];
  out.angle = parse_angle("angle", o.angle);
  if (!o.wavelength.empty())
    out.wavelength = metres("wavelength", parse_length("wavelength", o.wavelength), spacing, 0);
  try {
    out.check();
  } catch (const ParameterError& e) {
    throw ParameterError(e.name == "length" ? o.length_option(tool) : e.name, e.what());
  }
  refuse_aliased(out, o.wavelength);
  return out;
}

// Options of equations, and of what makes waves beyond a band, --cutoff or --rolloff.
void refuse_equations(const Tool& tool, const KernelOptions& o, const std::string& limit) {
  refuse_solver(tool, o, limit);
  if (given(tool, "infeasible"))
    throw UsageError("infeasible",
                     "cannot be combined with --" + limit + ", which leaves no equations to solve");
  if (const std::string option = MarginalOptions::given(tool); !option.empty() && !o.filters())
    throw UsageError(option, "cannot be combined with --" + limit +
                                 ": the translation of heights makes waves beyond the band; "
                                 "asperity-generate --method filter makes none");
}

Band band_of(const Tool& tool, const KernelOptions& o, const EllipticTarget& model, Shape period) {
  Band out;
  if (tool.given("--rolloff") && !o.rolloff_is_length(tool)) {
    out.rolloff_x = o.rolloff[0].metres(model.spacing_x);
    out.rolloff_y = o.rolloff[1].metres(model.spacing_y);
    const WaveBounds bounds = rolloff_bounds(model, period);
    refuse_beyond("rolloff", o.rolloff[0], model.spacing_x, bounds, side_of_surface);
    refuse_beyond("rolloff", o.rolloff[1], model.spacing_y, bounds, side_of_surface);
    refuse_levelled(model, o.rolloff[0], o.wavelength);
  }
  if (o.cutoff.empty()) return out;
  const SampledLength shortest_wave = parse_length("cutoff", o.cutoff);
  const WaveBounds bounds = cutoff_bounds(model, out, period);
  refuse_beyond("cutoff", shortest_wave, model.spacing_x, bounds,
                bounds.most < rolloff_bounds(model, period).most ? "roll-off" : side_of_surface);
  out.cutoff = shortest_wave.metres(model.spacing_x);
  return out;
}

// The surfaces of a period with the spectrum of the model, but for --cutoff and --rolloff; nothing without
// either, or where --rolloff is the length of the model.
std::optional<BandLimited> limited(const Tool& tool, const KernelOptions& o, const EllipticTarget& model,
                                   Shape period) {
  const bool levels = tool.given("--rolloff") && !o.rolloff_is_length(tool);
  if (o.cutoff.empty() && !levels) return std::nullopt;
  const std::string limit = o.cutoff.empty() ? "rolloff" : "cutoff";
  const std::string shown = o.cutoff.empty() ? "" : o.cutoff + ": ";
  if (period == Shape{})
    throw UsageError(
        limit, (o.cutoff.empty() ? "needs --periodic, or --model self-affine" : shown + "needs --periodic") +
                   "; otherwise the autocorrelation does not end, and a kernel must");
  refuse_equations(tool, o, limit);
  if (std::min(period.nx, period.ny) == 1)
    throw UsageError(limit, shown + "needs a surface: the waves of " + text(period) +
                                " points run along one axis; draw a surface and take a row of it "
                                "(asperity-filter --crop)");
  const Band band = model.has_spectrum() ? band_of(tool, o, model, period) : Band{};
  check_memory(periodic_kernel_cost(period), static_cast<double>(tool.memory()), period);
  return BandLimited(model, band, period);
}

void take_model(KernelProblem& out, const Tool& tool, const KernelOptions& options, Shape periodic) {
  out.model = model_of(tool, options, out.spacing);
  out.extent = options.length_option(tool);
  out.request.target = out.model->target();
  out.band = limited(tool, options, *out.model, periodic);
  if (out.band) out.period = out.torus = periodic;
}

// ---- a table ----

void take_table(KernelProblem& out, const Tool& tool, AcfTable table, Shape periodic) {
  out.extent = table.option;
  require_spacing(tool.given("--spacing") ? "spacing" : "size", "gives samples", out.spacing,
                  tool.given("--like") ? "the map has" : "the table has", table.spacing, 1e-6);
  if (table.left_out)
    tool.warn("the lags of the table beyond " +
              text({table.half_plane.rows(), table.half_plane.cols() / 2 + 1}) +
              " hold no numbers and are ignored");
  if (!out.spacing) out.spacing = table.spacing;
  if (!out.has_height && std::isfinite(table.rms)) {
    out.request.rms = table.rms;
    out.has_height = true;
  }
  if (out.free()) {
    out.period = table.period_on(periodic);
    out.corner = table.corner;
    out.positive_definite = table.positive_definite;
  }
  constexpr double known_to = 1e-2;  // of the variance: what one map tells of its autocorrelation, at best
  if (out.positive_definite && !given(tool, "acf-tolerance")) out.request.acf_tolerance = known_to;
  out.request.target = target_of_table(std::move(table.half_plane));
  out.measured = std::move(table.heights);
  out.data = std::move(table.dataset);
  out.before = Inventory(out.data);
  drop_surface(out.data, "kernel");
  tool.settle(out.data);
}

// Zero at all lags but 0 along an axis with one point.
Target target_on(const Target& target, Shape surface) {
  const bool x = surface.nx == 1, y = surface.ny == 1;
  if (target.table) {
    const Field& table = *target.table;
    const Index columns = y ? 1 : table.cols();
    return target_of_table(table.block(0, (table.cols() - columns) / 2, x ? 1 : table.rows(), columns));
  }
  auto narrow = [x, y](Shape lags) { return Shape{x ? 1 : lags.nx, y ? 1 : lags.ny}; };
  Target out([=, row = target.row](double p, double q) {
    double r = 0;
    if ((!x || p == 0) && (!y || q == 0)) row(p, q, {&r, 1});
    return r;
  });
  if (target.reach) out.reach = [=, reach = target.reach](double t) { return narrow(reach(t)); };
  return out;
}

}  // namespace

void KernelProblem::wrap(const Tool& tool, Shape surface) {
  constexpr double left_out = 1e-2;  // of the tolerance
  const bool profile = std::min(surface.nx, surface.ny) == 1;
  if (!profile || band || period || !free() || !request.target.reach) return;
  request.target =
      target_of_table(periodic_correlation(tool, request.target, surface, left_out * request.acf_tolerance));
  period = torus = surface;
}

void KernelProblem::lay_out(const Tool& tool, Shape surface, bool periodic) {
  if (periodic && period != surface) period.reset();
  narrow(surface);
  torus = period;
  if (!positive_definite || torus || surface == Shape{}) return;
  if (periodic) {
    request.target = target_of_table(periodic_correlation(tool, *request.target.table, surface));
    period = torus = surface;
    return;
  }
  const Shape lags = *request.target.known;
  torus = Shape{fast_length(surface.nx + lags.nx - 1), fast_length(surface.ny + lags.ny - 1)};
  corner = surface;
}

Shape KernelProblem::lags_kept() const {
  const Shape all = *request.target.known;
  if (!corner || keeps_kernel) return all;
  return {std::min<Index>(all.nx, 2), std::min<Index>(all.ny, 2)};
}

void KernelProblem::narrow(Shape surface) {
  if (surface.nx != 1 && surface.ny != 1) return;
  request.target = target_on(request.target, surface);
  if (surface.nx == 1) request.lags.nx = std::min<Index>(request.lags.nx, 1);
  if (surface.ny == 1) request.lags.ny = std::min<Index>(request.lags.ny, 1);
}

KernelProblem kernel_problem(const Tool& tool, const KernelOptions& options, std::optional<AcfTable> table,
                             const Spacing& spacing, Shape periodic) {
  KernelProblem out;
  out.spacing = spacing;
  options.height.check(tool);
  out.has_height = !std::isnan(options.height.rms);
  KernelRequest& request = out.request;
  request = options.request;
  if (out.has_height) request.rms = options.height.rms;
  request.method = options.filters() ? Method::newton_krylov : enum_named<Method>(options.method, "method");
  request.infeasible = enum_named<InfeasiblePolicy>(options.infeasible, "infeasible");
  request.memory = static_cast<double>(tool.memory());
  out.threads = tool.thread_count();
  if (!options.formulation.empty())
    request.formulation = enum_named<Formulation>(options.formulation, "formulation");
  if (table)
    take_table(out, tool, std::move(*table), periodic);
  else
    take_model(out, tool, options, periodic);
  if (out.band) request.method = Method::spectral;
  if (!options.filters()) out.marginal = options.heights.wanted(tool, out.measured, request.infeasible);
  if (out.marginal && out.positive_definite && request.infeasible == InfeasiblePolicy::automatic)
    request.infeasible = InfeasiblePolicy::nearest;
  request.check();
  return out;
}

}  // namespace asperity::cli
