#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "tools/measure/height_tables.hpp"
#include "tools/plot/figure.hpp"
#include "tools/report/html.hpp"
#include "tools/report/parts.hpp"

namespace asperity::report {
namespace {

struct Wanted {
  std::string title;
  plot::Figure (*describe)(const plot::Cases&, const plot::Request&);
  const char* format;
  std::string variable, section = {};
};

bool is_field(const Dataset& data, const std::string& name) {
  const Variable* variable = data.find(name);
  return variable && variable->dimensions == std::vector<std::string>{"x", "y"};
}

// A section goes through the largest stress if the volume gives its position.
std::vector<Wanted> wanted(const Dataset& data, const std::string& variable) {
  std::vector<Wanted> out;
  const bool field = is_field(data, variable);
  if (field) {
    if (std::min(data.length("x"), data.length("y")) > 1)
      out.push_back({"Map of " + variable, plot::map, "png", variable});
    out.push_back({"Profiles of " + variable, plot::profile, "svg", variable});
    out.push_back({"Distribution of " + variable, plot::pdf, "svg", variable});
  }
  if (field && !cli::counted_cells(data, variable)) {  // of a part of the cells there is a distribution alone
    out.push_back({"Quantiles of " + variable, plot::qq, "svg", variable});
    out.push_back({"Material ratio of " + variable, plot::abbott, "svg", variable});
    out.push_back({"Spectra of " + variable, plot::psd, "svg", variable});
  }
  if (variable == "heights" && (field || data.has("acf_achieved")))
    out.push_back({"Autocorrelation", plot::acf, "svg", ""});
  if (is_field(data, "pressure")) out.push_back({"Contact pressure", plot::map, "png", "pressure"});
  if (is_field(data, "contact")) out.push_back({"State of contact", plot::contact, "png", ""});
  if (const Variable* stress = data.find("von_mises")) {
    const bool placed = stress->dimensions.size() == 3 && data.attributes.find("stress_max_y");
    const std::string largest = data.length("x") < 2 ? "x=max" : "y=max";
    out.push_back({"Von Mises stress", plot::section, "png", "von_mises", placed ? largest : ""});
    out.push_back({"Largest stress by depth", plot::maxima, "svg", "von_mises"});
  }
  return out;
}

std::string drawn(const plot::Cases& dataset, const Wanted& wanted) {
  plot::Request request;
  request.variable = wanted.variable;
  request.section = wanted.section;
  request.format = wanted.format;
  return plot::run_gnuplot(plot::script_of(wanted.describe(dataset, request), request)).bytes;
}

}  // namespace

std::string pictures(const plot::Cases& dataset, const std::string& variable) {
  std::string shown, omitted;
  for (const Wanted& w : wanted(dataset.at(0).data, variable)) {
    const std::string title = escaped(w.title), type = w.format == std::string("svg") ? "svg+xml" : w.format;
    try {
      shown += fmt::format(
          "<figure><img alt=\"{}\" src=\"data:image/{};base64,{}\"><figcaption>{}</figcaption></figure>\n",
          title, type, base64(drawn(dataset, w)), title);
    } catch (const DataError& error) {
      const std::string why = escaped(error.name + ": " + error.what());
      omitted += element("p", fmt::format("{} is not drawn: {}.", title, why), "soft");
    }
  }
  return element("div", shown, "pictures") + omitted;
}

}  // namespace asperity::report
