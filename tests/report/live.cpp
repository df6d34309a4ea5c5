// The data that the page's script reads, and the script in a browser.
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "dataset/layout.hpp"
#include "formats/gzip.hpp"
#include "support.hpp"
#include "tools/files.hpp"
#include "tools/report/fields.hpp"
#include "tools/report/html.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

std::string bytes_of(std::string_view digits) {
  std::string out;
  for (std::size_t at = 0; at + 4 <= digits.size(); at += 4) {
    unsigned group = 0;
    for (const char c : digits.substr(at, 4))
      group = group << 6 | static_cast<unsigned>(c == '+'   ? 62
                                                 : c == '/' ? 63
                                                 : c == '=' ? 0
                                                 : c <= '9' ? c - '0' + 52
                                                 : c <= 'Z' ? c - 'A'
                                                            : c - 'a' + 26);
    for (const int shift : {16, 8, 0}) out += static_cast<char>(group >> shift & 255U);
  }
  out.resize(out.size() - static_cast<std::size_t>(std::ranges::count(digits, '=')));
  return out;
}

std::string raw_of(const std::string& page, std::size_t begin, std::size_t bytes) {
  const auto digits = page.find('>', begin) + 1;
  return inflated(bytes_of(page.substr(digits, page.find('<', digits) - digits)), bytes, Wrapper::zlib);
}

// The first field of a page in the unit that it is shown in, and its step, as page.js reads them.
struct Read {
  Field values;
  double step;
};
Read first_field(const std::string& page, Shape shape) {
  const auto begin = page.find("class=\"field\"");
  REQUIRE(begin != page.npos);
  auto attribute = [&](const std::string& name) {
    return std::stod(page.substr(page.find(" data-" + name + "=\"", begin) + name.size() + 8));
  };
  const auto n = static_cast<std::size_t>(shape.nx * shape.ny);
  const std::string raw = raw_of(page, begin, 2 * n);
  Read out{Field(shape.nx, shape.ny), attribute("step")};
  unsigned sum = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const unsigned high = static_cast<unsigned char>(raw[k]), low = static_cast<unsigned char>(raw[n + k]);
    sum = ((k % static_cast<std::size_t>(shape.ny) == 0 ? 0 : sum) + (high << 8 | low)) & 0xFFFFU;
    out.values.data()[k] = sum == 0xFFFFU ? NAN : attribute("low") + out.step * sum;
  }
  return out;
}

double number_in(std::string text) {
  if (const auto minus = text.find("\u2212"); minus != text.npos) text.replace(minus, 3, "-");
  return std::stod(text.substr(text.find(' ') + 1));
}

}  // namespace

TEST_CASE("a field of the page is that of the dataset to half its step, and missing where that is",
          "[report][exact]") {
  Dataset data;
  set_grid(data, {{30, 20}, 1e-6, 1e-6});
  set_field(data, "heights", 1e-6 * random_field({30, 20}, 1), {"m", "height"});
  std::get<std::vector<double>>(data.find("heights")->values)[7] = std::nan("");
  const Field z = 1e9 * field_of(data, "heights", Missing::not_a_number);  // shown in nm
  const Read read = first_field(report::viewer(data, {"heights"}), {30, 20});
  CHECK(std::isnan(read.values(0, 7)));
  const Field error = (read.values - z).abs();
  CHECK(error.isFinite().count() == 599);
  CHECK(error.isFinite().select(error, 0).maxCoeff() <= 0.5 * read.step * (1 + 1e-9));
}

// asperity-stress --above leaves out the stress of most cells; undefined codes were streaks down to the end.
TEST_CASE("where a stress is missing the section below has none", "[report][exact]") {
  Dataset data;
  set_grid(data, {{3, 2}, 1e-6, 1e-6});
  set_field(data, "heights", random_field({3, 2}, 1), {"m", "height"});
  set_depths(data, {0, 1e-6, 2e-6});
  std::vector<double> stress;
  for (int k = 0; k < 18; ++k) stress.push_back(k % 4 == 1 ? NAN : 1e9 * k);
  data.put({"von_mises", {"z", "x", "y"}, stress, {}});
  data.find("von_mises")->attributes.set("units", "Pa");
  const std::string page = report::viewer(data, {"heights"});
  const std::string raw = raw_of(page, page.find("class=\"volume\""), 18);
  std::vector<unsigned> codes;
  for (std::size_t k = 0; k < 18; ++k)
    codes.push_back((static_cast<unsigned char>(raw[k]) + (k < 6 ? 0U : codes[k - 6])) & 0xFFU);
  for (std::size_t k = 0; k < 18; ++k) {
    CAPTURE(k, codes[k]);
    if (std::isnan(stress[k]))
      CHECK(codes[k] == 255);
    else
      CHECK(std::abs(codes[k] - 254 * stress[k] / 16e9) <= 0.5);
  }
}

// 1024 = 2 · 512, so that all blocks are alike; the mean of their means is that of the points.
TEST_CASE("a field too large for the page is shown by means over blocks, and states by their middle",
          "[report][exact]") {
  Dataset data;
  set_grid(data, {{1024, 8}, 1e-6, 1e-6});
  const Field z = 1e-6 * random_field({1024, 8}, 2);
  set_field(data, "heights", z, {"m", "height"});
  std::vector<std::int8_t> states(1024 * 8);
  for (std::size_t k = 0; k < states.size(); ++k) states[k] = static_cast<std::int8_t>(k % 3);
  set_flags(data, "contact", states, "state", "open elastic limit");
  const Dataset blocks = report::in_blocks(data, {"heights", "contact"}, 512);
  const Field means = field_of(blocks, "heights"), middle = field_of(blocks, "contact");
  REQUIRE((means.rows() == 512 && means.cols() == 8));
  CHECK(means(3, 1) == Approx(z.block(6, 1, 2, 1).mean()).epsilon(1e-14));
  CHECK(grid_of(blocks).size_x() == Approx(1024e-6).epsilon(1e-14));
  CHECK(middle(3, 1) == states[7 * 8 + 1]);
  CHECK_THAT(report::viewer(data, {"heights"}),
             ContainsSubstring("1024 × 8 points are shown as 512 × 8 means over blocks") &&
                 ContainsSubstring("data-nx=\"512\" data-ny=\"8\""));
}

TEST_CASE(
    "in a browser the page reads fields and curves under the pointer, follows keys, and fits a phone and "
    "paper",
    "[report][contract][slow]") {
  REQUIRE(
      shell("asperity-generate --shape 64x64 --size 1mm --rq 0.4um --length 6px,4px --seed 7 -o s.nc").exit ==
      0);
  require(
      "asperity-contact s.nc --load 100N --radius 20mm --young 210GPa --poisson 0.3 -q "
      "| asperity-stress --depths 1um:0.3mm:8 --maximum -q -o st.nc; asperity-report st.nc -q -o live.html");
  const Outcome run = require("/usr/bin/python3 " BROWSER " live.html");
  if (skipped(run)) return;
  const auto seen = nlohmann::json::parse(run.out);
  const Field z = 1e6 * field_of(read_dataset("s.nc"), "heights");
  const std::vector<double> stress = numbers(read_dataset("st.nc").at("von_mises").values);
  const double deepest = 1e-9 * stress[7 * 64 * 64],  // of the first column [GPa]
      half_step = 1e-9 * std::ranges::max(stress) / 254 / 2;
  for (const char* width : {"wide", "narrow"}) {
    const auto& page = seen[width];
    CAPTURE(width, page.value("error", ""));
    REQUIRE_FALSE(page.contains("error"));
    CHECK(page["width"][1] <= page["width"][0]);
    constexpr double printed = 1e-4;  // places of the height
    CHECK(std::abs(number_in(page["corner"]) - z(63, 63)) <= printed);
    CHECK_THAT(page["corner"].get<std::string>(), ContainsSubstring("at x = 492.2 µm, y = 492.2 µm"));
    CHECK_THAT(page["slid"][0].get<std::string>(), ContainsSubstring("y = \u2212492.2 µm"));
    CHECK_THAT(page["slid"][2].get<std::string>(), ContainsSubstring("along x at y = \u2212492.2 µm"));
    const std::string below = page["below"];
    CHECK_THAT(below, ContainsSubstring(" GPa at x = \u2212492.2 µm, depth 300.0 µm"));
    CHECK(std::abs(number_in(below.substr(below.find("stress"))) - deepest) <= half_step + 0.5e-3);
    CHECK_THAT(page["second"].get<std::string>(), ContainsSubstring("pressure "));
    CHECK_THAT(page["curve"].get<std::string>(),
               ContainsSubstring("along x: lag 0.0 µm, autocorrelation ρ 1.000"));
    CHECK_THAT(page["table"].get<std::string>(),
               ContainsSubstring("quantity\tvalue\tstandard error\tlow_95\thigh_95\tunit\nmean\t"));
    CHECK(page["still"] == "none");
  }
  CHECK(seen["narrow"]["width"][0] == 320);
  CHECK((seen["pages"] > 1 && seen["pages"] <= 6));
}
