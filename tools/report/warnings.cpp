#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "contact/energy.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "tools/report/html.hpp"
#include "tools/report/parts.hpp"

namespace asperity::report {
namespace {

constexpr std::string_view warnings_of = "_warnings";  // after the name of the tool, a line for each

struct Warnings {
  std::string items = {};
  std::size_t number = 0;

  void add(std::string_view tool, std::string_view text) {
    items += fmt::format("<li><b>asperity-{}</b>: {}</li>\n", escaped(tool), escaped(text));
    ++number;
  }
};

// ---- what attributes tell where the words of the tool are missing ----

void warn_of_solvers(Warnings& out, const Attributes& a) {
  const auto number = [&](const char* name) { return readable(a.number(name, NAN), "1"); };
  const auto unsaid = [&](const char* stage, const char* word) {
    return a.text(std::string(stage).append(warnings_of)).find(word) == std::string::npos;
  };
  if (a.number("kernel_converged", 1) == 0 && unsaid("kernel", "converge"))
    out.add("kernel",
            fmt::format("the kernel did not converge ({}): residual {}, tolerance {}. Surfaces generated "
                        "from it do not have the requested autocorrelation",
                        a.text("kernel_reason"), number("kernel_residual"), number("kernel_tolerance")));
  if (a.text("kernel_answer") == "nearest" && a.number("kernel_change", 0) > 1e-6 &&
      unsaid("kernel", "change"))
    out.add("kernel",
            fmt::format("no kernel of this size has the requested autocorrelation; it was changed by up to "
                        "{} of the variance, and what converged is the kernel of the changed one",
                        number("kernel_change")));
  if (a.number("contact_converged", 1) == 0 && unsaid("contact", "converge"))
    out.add("contact",
            fmt::format("the contact did not converge: residual {}, tolerance {}. Pressure, area and all "
                        "quantities computed from them are not a solution",
                        number("contact_residual"), number("contact_tolerance")));
  if (a.number("contact_stiffness_converged", 1) == 0 && unsaid("contact", "stiffness"))
    out.add("contact",
            fmt::format("the stiffness did not converge: residual {}", number("contact_stiffness_residual")));
}

double largest_von_mises(const Dataset& data) {
  const Variable* stress = data.find("von_mises");
  const Values* range = stress ? stress->attributes.find("actual_range") : nullptr;
  const double kept =
      range && count(*range) == 2 && stress->attributes.text("units") == "Pa" ? numbers(*range)[1] : NAN;
  return data.attributes.number("stress_max_von_mises", kept);
}

void warn_of_stress(Warnings& out, const Dataset& data) {
  const Attributes& a = data.attributes;
  if (a.find("stress_warnings")) return;
  const double largest = largest_von_mises(data), yield = a.number("contact_limit_pressure", NAN) / hardness;
  if (largest > yield)
    out.add("stress",
            fmt::format("von Mises stress reaches {}, above the yield stress of {}, a third of the limit "
                        "pressure: this is the elastic stress below that pressure, without plastic flow",
                        readable(largest, "Pa"), readable(yield, "Pa")));
  if (!data.has("z")) return;
  const std::vector<double> depths = depths_of(data);
  const double accurate = a.number("stress_accurate_depth", 0);
  if (const auto shallow = std::ranges::count_if(depths, [&](double z) { return z < accurate; }))
    out.add(
        "stress",
        fmt::format("{} of {} lie less than {} deep: near an edge of the contact their stress is inaccurate",
                    shallow, counted(std::ssize(depths), "layer"), readable(accurate, "m")));
}

}  // namespace

std::string warnings(const Dataset& data, const std::vector<std::string>& own) {
  Warnings out;
  for (const Attribute& a : data.attributes)
    if (a.name.ends_with(warnings_of)) {
      std::istringstream lines(data.attributes.text(a.name));
      for (std::string line; std::getline(lines, line);)
        if (!line.empty()) out.add(a.name.substr(0, a.name.size() - warnings_of.size()), line);
    }
  warn_of_solvers(out, data.attributes);
  warn_of_stress(out, data);
  for (const std::string& line : own) out.add("report", line);
  if (out.number == 0) return "";
  return fmt::format(
      "<section class=\"warnings\" aria-labelledby=\"warnings\"><h2 id=\"warnings\">{}</h2>\n"
      "<ul>{}</ul></section>\n",
      counted(static_cast<Index>(out.number), "warning"), out.items);
}

}  // namespace asperity::report
