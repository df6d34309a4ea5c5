// Histograms of heights on the steps of an instrument.
#include <cmath>

#include "plot/pictures.hpp"
#include "tools/plot/figure.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Centre, density and width of the boxes.
std::vector<std::array<double, 3>> boxes_of(const Field& heights) {
  Dataset data;
  set_grid(data, {{heights.rows(), heights.cols()}, 1e-6, 1e-6});
  set_field(data, "heights", heights, {"m", "height"});
  plot::Request request;
  request.format = "svg";
  const plot::Figure figure = plot::pdf({{data, "one"}}, request);
  std::vector<std::array<double, 3>> out;
  for (const plot::Layer& l : figure.panels[0].layers)
    if (l.command.find("with boxes") != l.command.npos)
      for (std::size_t k = 0; k < l.numbers.size(); k += 3)
        out.push_back({l.numbers[k], l.numbers[k + 1], l.numbers[k + 2]});
  return out;
}

}  // namespace

// Between 13 levels stood 30 empty bins, and where a bin held now two, now three levels, waves of 50 %.
TEST_CASE("bins of heights on steps hold whole steps, as many each", "[plot][law]") {
  const Field z = random_field({96, 96}, 1);
  for (const double levels : {1.0, 3.0, 10.0, 40.0, 1000.0})
    for (const double offset : {0.0, 0.37, -12345.6}) {
      const double step = 1e-6 / levels;
      const Field heights = step * ((levels * z).round() + offset);
      const auto boxes = boxes_of(heights);
      CAPTURE(levels, offset, boxes.size());
      REQUIRE(boxes.size() >= 3);
      const double width = boxes[0][2],
                   in_steps = width * (heights.abs().maxCoeff() < 1e-3 ? 1e-6 : 1e-3) / step;
      CHECK(std::abs(in_steps - std::round(in_steps)) <= 1e-4 * in_steps);
      for (const auto& [centre, density, w] : boxes) CHECK(w == Approx(width).epsilon(1e-9));
      for (std::size_t k = 1; k + 1 < boxes.size();
           ++k)  // one hill: no bin is lower than half of both beside
        if (boxes[k - 1][1] > 0.1 * boxes[boxes.size() / 2][1] &&
            boxes[k + 1][1] > 0.1 * boxes[boxes.size() / 2][1])
          CHECK(boxes[k][1] >= 0.5 * std::min(boxes[k - 1][1], boxes[k + 1][1]));
    }
}

TEST_CASE("few heights that are no steps are told, and others keep Scott's bins", "[plot][contract]") {
  const Field wave = Field::NullaryExpr(64, 64, [](Index i, Index) {
    return 1e-6 * std::sin(2 * std::acos(-1.0) * static_cast<double>(i) / 32);
  });
  Dataset data;
  set_grid(data, {{64, 64}, 1e-6, 1e-6});
  set_field(data, "heights", wave, {"m", "height"});
  write_dataset(data, "wave.nc");
  const Outcome run = shell("asperity-plot wave.nc --kind pdf -o wave.svg");
  CHECK((run.exit == 0 && lines(run.error) == 1));
  CHECK_THAT(run.error, ContainsSubstring("different values, in uneven steps"));
  CHECK(test::plot("--kind pdf -o a.svg").error.empty());
}

// Beyond a top that a bin without heights set, whose interval reaches far, and that the Gaussian went through.
TEST_CASE("the density axis ends above the histogram and the Gaussian, not at the end of any interval",
          "[plot][law]") {
  Field bowl = Field::NullaryExpr(96, 96, [](Index i, Index j) {
    return 1e-6 * static_cast<double>((i * 96 + j) % 2 == 0 ? i : -i) / 96;
  });
  for (const Field& z : {Field(1e-6 * random_field({96, 96}, 3)), bowl}) {
    Dataset data;
    set_grid(data, {{96, 96}, 1e-6, 1e-6});
    set_field(data, "heights", z, {"m", "height"});
    plot::Request request;
    request.format = "svg";
    const plot::Figure figure = plot::pdf({{data, "one"}}, request);
    double highest = 0;
    for (const plot::Layer& l : figure.panels[0].layers)
      if (l.command.find("boxxyerror") == l.command.npos) {
        const std::size_t columns = l.command.find("boxes") != l.command.npos ? 3 : 2;
        for (std::size_t k = 1; k < l.numbers.size(); k += columns) highest = std::max(highest, l.numbers[k]);
      }
    CHECK(figure.panels[0].y->range.high >= highest);
    CHECK(figure.panels[0].y->range.high <= 2.2 * highest);
  }
}
