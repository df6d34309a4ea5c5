#include "tools/report/pictures.hpp"

#include "core/error.hpp"
#include "tools/plot/gnuplot.hpp"
#include "tools/plot/kinds.hpp"

namespace asperity::report {
namespace {

using Describe = plot::Figure (*)(const plot::Cases&, const plot::Request&);
enum class Format { png, svg };

struct Wanted {
  std::string title;
  Describe describe;
  Format format;
  std::string variable, section = {};
};

bool is_field(const Dataset& data, const std::string& name) {
  const Variable* variable = data.find(name);
  return variable && variable->dimensions == std::vector<std::string>{"x", "y"};
}

void want_surface(std::vector<Wanted>& out, const Dataset& data, const std::string& variable) {
  if (is_field(data, variable)) {
    out.push_back({"Map of " + variable, plot::map, Format::png, variable});
    out.push_back({"Profiles of " + variable, plot::profile, Format::svg, variable});
    out.push_back({"Distribution of " + variable, plot::pdf, Format::svg, variable});
  }
  const bool correlated =
      variable == "heights" ? is_field(data, variable) || data.has("acf_achieved") : false;
  if (correlated) out.push_back({"Autocorrelation", plot::acf, Format::svg, ""});
}

// Through the largest stress where the dataset says where it is, and holds more than one section.
void want_stress(std::vector<Wanted>& out, const Dataset& data) {
  const Variable* stress = data.find("von_mises");
  if (!stress) return;
  const bool placed = stress->dimensions.size() == 3 && data.attributes.find("stress_max_y");
  const std::string along = data.length("x") < 2 ? "x=max" : "y=max";
  out.push_back({"Von Mises stress", plot::section, Format::png, "von_mises", placed ? along : ""});
}

std::vector<Wanted> wanted(const Dataset& data, const std::string& variable) {
  std::vector<Wanted> out;
  want_surface(out, data, variable);
  if (is_field(data, "pressure")) out.push_back({"Contact pressure", plot::map, Format::png, "pressure"});
  if (is_field(data, "contact")) out.push_back({"State of contact", plot::contact, Format::png, ""});
  want_stress(out, data);
  return out;
}

Picture picture_of(const plot::Cases& dataset, const Wanted& wanted) {
  plot::Request request;
  request.variable = wanted.variable;
  request.section = wanted.section;
  const bool png = wanted.format == Format::png;
  request.format = png ? "png" : "svg";
  try {
    return {wanted.title, png ? "image/png" : "image/svg+xml",
            plot::run_gnuplot(plot::script_of(wanted.describe(dataset, request), request)).bytes, ""};
  } catch (const DataError& error) {
    return {wanted.title, "", "", error.name + ": " + error.what()};
  }
}

}  // namespace

std::vector<Picture> pictures_of(const plot::Cases& dataset, const std::string& variable) {
  std::vector<Picture> out;
  for (const Wanted& w : wanted(dataset.at(0).data, variable)) out.push_back(picture_of(dataset, w));
  return out;
}

}  // namespace asperity::report
