// What the tests of pictures draw, and how they read what was drawn.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

namespace asperity::test {

// Every variable that a figure draws, on 24 × 20 cells of 25 µm.
inline const std::string& scene() {
  static const std::string name = [] {
    const Grid grid{{24, 20}, 25e-6, 25e-6};
    Dataset data;
    set_grid(data, grid);
    set_field(data, "heights", 0.4e-6 * random_field(grid.shape, 1), {"m", "height"});
    set_field(data, "pressure", 2e9 * random_field(grid.shape, 2).abs(), {"Pa", "pressure"});
    std::vector<std::int8_t> states;
    for (int k = 0; k < 480; ++k) states.push_back(static_cast<std::int8_t>(k % 3));
    set_flags(data, "contact", states, "contact state", "open elastic limit");
    set_depths(data, {0, 1e-5, 3e-5, 8e-5});
    std::vector<double> stress;
    for (int k = 0; k < 4 * 480; ++k) stress.push_back(1e6 * k);
    set_volume(data, "von_mises", stress, {"Pa", "von Mises stress"});
    data.attributes.set("contact_hertz_pressure", 2e9);
    write_dataset(data, "scene.nc");
    return std::string("scene.nc");
  }();
  return name;
}

inline std::string bytes_of(const std::string& name) {
  std::ifstream in(scratch(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The words of an SVG, a line each.
inline std::string words_of(const std::string& name) {
  const std::string svg = bytes_of(name), open = "<text>", close = "</text>";
  std::string out;
  for (auto at = svg.find(open); at != svg.npos; at = svg.find(open, at)) {
    at += open.size();
    out += svg.substr(at, svg.find(close, at) - at) + '\n';
  }
  return out;
}

inline Outcome plot(const std::string& arguments) {
  return shell("asperity-plot " + scene() + " " + arguments);
}

}  // namespace asperity::test
