// The texts of an SVG as boxes, which stand apart and on the sheet.
#pragma once

#include <algorithm>
#include <cstdio>

#include "plot/pictures.hpp"
#include "tools/plot/tics.hpp"

namespace asperity::test {

struct Box {
  double left, right, low, high;
  std::string text;
};

// Letters are taken as half an em wide and 0.6 em high, less than they are in DejaVu Sans: what overlaps here
// cannot be read.
inline Box box_of(double x, double y, bool upright, const std::string& anchor, double em,
                  const std::string& text) {
  const double length = 0.5 * em * plot::letters(text), high = 0.6 * em;
  const double from = anchor == "middle" ? -0.5 * length : anchor == "end" ? -length : 0;
  if (upright) return {x - high, x, y - from - length, y - from, text};
  return {x + from, x + from + length, y - high, y, text};
}

inline std::vector<Box> boxes_of(const std::string& name) {
  const std::string svg = bytes_of(name), place = "<g transform=\"translate(";
  auto between = [&](std::size_t at, const std::string& open, const std::string& close) {
    const auto begin = svg.find(open, at) + open.size();
    return svg.substr(begin, svg.find(close, begin) - begin);
  };
  std::vector<Box> out;
  for (auto at = svg.find(place); at != svg.npos; at = svg.find(place, at + 1)) {
    double x = 0, y = 0;
    REQUIRE(std::sscanf(svg.c_str() + at + place.size(), "%lf,%lf", &x, &y) == 2);
    const bool upright = svg.substr(at, svg.find('>', at) - at).find("rotate(-90") != svg.npos;
    const std::string text = between(at, "<text>", "</text>");
    if (text.find_first_not_of(' ') != text.npos && text.find('<') == text.npos)
      out.push_back(box_of(x, y, upright, between(at, "text-anchor=\"", "\""),
                           std::atof(between(at, "font-size=\"", "\"").c_str()), text));
  }
  return out;
}

inline void check_apart(const std::string& name) {
  const std::vector<Box> boxes = boxes_of(name);
  CHECK(boxes.size() >= 5);
  for (std::size_t a = 0; a < boxes.size(); ++a)
    for (std::size_t b = a + 1; b < boxes.size(); ++b) {
      CAPTURE(boxes[a].text, boxes[b].text);
      CHECK((boxes[a].right < boxes[b].left || boxes[b].right < boxes[a].left ||
             boxes[a].high < boxes[b].low || boxes[b].high < boxes[a].low));
    }
}

// All of every text, and none beyond the sheet.
inline void check_inside(const std::string& name) {
  const std::string svg = bytes_of(name);
  double width = 0, height = 0;
  REQUIRE(std::sscanf(svg.c_str() + svg.find("viewBox="), "viewBox=\"0 0 %lf %lf", &width, &height) == 2);
  for (const Box& box : boxes_of(name)) {
    CAPTURE(box.text, box.left, box.right, box.low, box.high, width, height);
    CHECK((0 <= box.left && box.right <= width && 0 <= box.low && box.high <= height));
  }
}

}  // namespace asperity::test
