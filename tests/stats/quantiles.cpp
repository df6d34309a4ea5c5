#include "stats/sample/quantiles.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

int calls = 0;

// GSL's own handler would end the process.
struct Counted {
  gsl_error_handler_t* former = gsl_set_error_handler([](const char*, const char*, int, int) { ++calls; });
  Counted() { calls = 0; }
  ~Counted() { gsl_set_error_handler(former); }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
};

constexpr double inf = std::numeric_limits<double>::infinity(),
                 no_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

// The χ² and t quantiles of degrees that are no number ended the program of whoever used the library: a flat
// surface has 0/0.
TEST_CASE("no argument of a quantile reaches GSL's error handler", "[quantiles][contract]") {
  const Counted handler;
  const double degrees[] = {no_number, -inf, -1,  0,   1e-300, 1e-7, 1e-5,  0.005,
                            0.02,      1,    1e3, 1e5, 1e8,    1e12, 1e300, inf},
               tails[] = {no_number, -1, 0, 1e-300, 1e-12, 0.025, 0.5, 0.975, 1, 2, inf};
  for (const double d : degrees)
    for (const double t : tails) {
      CAPTURE(d, t);
      const bool chi = t >= 0 && t <= 1 && d >= 1e-6, student = t > 0 && t < 1 && d >= 0.01;
      if (!chi) CHECK(std::isnan(chi_squared_share(t, d)));
      if (chi && d < 1e300) CHECK(!std::isnan(chi_squared_share(t, d)));
      if (!student || d >= 1) CHECK(std::isnan(student_quantile(t, d)) == !student);
      CHECK(std::isnan(student_tails(t, d).below) == !(d >= 0.01 && !std::isnan(t)));
      CHECK(std::isnan(student_tails(-t, d).above) == !(d >= 0.01 && !std::isnan(t)));
    }
  CHECK(calls == 0);
}

TEST_CASE("within their bounds quantiles are those of GSL, and the normal ones at the end",
          "[quantiles][exact]") {
  for (const double d : {0.5, 3.0, 41.0, 9e3}) {
    CHECK(chi_squared_share(0.025, d) == gsl_cdf_chisq_Qinv(0.025, d) / d);
    CHECK(student_quantile(0.025, d) == gsl_cdf_tdist_Qinv(0.025, d));
    CHECK(student_tails(1.5, d).above == gsl_cdf_tdist_Q(1.5, d));
  }
  // t of ν degrees is x + (x³ + x)/4ν, 1.2e-9 beside the normal x = 1.96 of ν = 2e9.
  const double x = gsl_cdf_ugaussian_Qinv(0.025);
  CHECK(std::abs(student_quantile(0.025, 2e9) - x) <= 0);
  CHECK(std::abs(gsl_cdf_tdist_Qinv(0.025, 0.99e9) - x) <= 2.5e-9);
}
