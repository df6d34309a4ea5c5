#include <limits>
#include <numbers>

#include "acf/radial.hpp"
#include "acf/target.hpp"
#include "reference/exponential_target.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::vector<Model> every_model{Model::exponential, Model::gaussian,
                                     Model::matern,      Model::stretched_exponential,
                                     Model::self_affine, Model::exponential_cosine};

EllipticTarget of(Model model) {
  EllipticTarget t;
  t.model = model;
  t.length_x = 17;
  t.length_y = 4;
  t.smoothness = 0.7;
  t.exponent = 1.3;
  t.wavelength = 6;
  return t;
}

// |R| on a lag of ellipse radius s ≤ 1.
bool within_one(const Target& target, double p, double q) { return std::abs(target(p, q)) <= 1; }

}  // namespace

TEST_CASE("a model is named as on the command line and an unknown name is refused", "[target][contract]") {
  for (Model model : every_model) CHECK(enum_named<Model>(name_of(model), "target") == model);
  CHECK(name_of(Model::stretched_exponential) == "stretched-exponential");
  CHECK_THROWS_MATCHES(enum_named<Model>("fractal", "target"), ParameterError,
                       Message("'fractal' is none of exponential|gaussian|matern|stretched-exponential|"
                               "self-affine|exponential-cosine"));
}

// The tabulated logarithm is off by at most 2e-11; the closed forms are round-off.
TEST_CASE("Matérn's correlation is exp(-r) for ν = 1/2, (1+r) exp(-r) for 3/2, (1+r+r²/3) exp(-r) for 5/2",
          "[target][exact]") {
  const MaternCorrelation half(0.5), three_halves(1.5), five_halves(2.5);
  for (double r = 1e-9; r < 700; r *= 1.37) {
    CAPTURE(r);
    CHECK(relative_error(half(r), std::exp(-r)) <= 2e-11);
    CHECK(relative_error(three_halves(r), (1 + r) * std::exp(-r)) <= 2e-11);
    CHECK(relative_error(five_halves(r), (1 + r + r * r / 3) * std::exp(-r)) <= 2e-11);
  }
}

// (2) of MaternCorrelation; the next term is r² / (4 (1-ν)).
TEST_CASE("Matérn's structure function begins as r to the 2ν with its constant", "[target][law]") {
  for (double nu : {0.01, 0.3, 0.5, 0.8}) {
    const MaternCorrelation rho(nu);
    for (double r : {1e-12, 1e-6, 1e-3}) {
      const double first = std::tgamma(1 - nu) / std::tgamma(1 + nu) * std::pow(r / 2, 2 * nu);
      CAPTURE(nu, r);
      CHECK(std::abs(1 - rho(r) - first) <= r * r / (2 * (1 - nu)) + first * first * 1e-9 + 2e-12);
    }
  }
}

// (3) of SelfAffineCorrelation; the next term is at most r²/(4 (1-H)). Either side takes two gammas of five units
// in the last place and a dozen roundings of numbers below one: 2 (2·5 + 12/2) ε = 32 ε.
TEST_CASE("the self-affine structure function begins as r to the 2H with its constant", "[target][law]") {
  for (double H : {0.01, 0.3, 0.5, 0.8}) {
    const SelfAffineCorrelation rho(H);
    for (double r : {1e-12, 1e-6, 1e-3}) {
      const double first = std::tgamma(1 - H) / ((1 + H) * std::tgamma(1 + H)) * std::pow(r / 2, 2 * H);
      CAPTURE(H, r);
      CHECK(std::abs(1 - rho(r) - first) <= r * r / (4 * (1 - H)) + 32 * epsilon);
    }
  }
}

// The ranges of r are computed by unlike means; ρ' < 1 and the gap is 2e-12 wide.
TEST_CASE("the three ranges of the self-affine correlation meet within 1e-11", "[target][exact]") {
  for (double H : {0.01, 0.2, 0.5, 0.75, 0.76, 0.99, 0.9901, 1.0}) {
    const SelfAffineCorrelation rho(H);
    CAPTURE(H);
    for (double r : {2.0, 128.0}) CHECK(std::abs(rho(r * (1 - 1e-12)) - rho(r)) <= 1e-11);
  }
}

// The poles of two terms cancel at H = 1; ρ is smooth in H there, with |dρ/dH| < 1.
TEST_CASE("the self-affine correlation has no jump at H = 1", "[target][exact]") {
  const SelfAffineCorrelation one(1), nearly(1 - 1e-13), series(0.99 + 1e-12), gamma(0.99 - 1e-12);
  for (double r : {1e-3, 0.1, 0.7, 1.9}) {
    CHECK(std::abs(one(r) - nearly(r)) <= 1e-12);
    CHECK(std::abs(series(r) - gamma(r)) <= 1e-11);
  }
}

// (4): the next term is 2 (1+H) / r of the first, in J₁.
TEST_CASE("the ripple of the self-affine correlation is 4 H J0(r)/r² at large lags", "[target][law]") {
  for (double H : {0.1, 0.8, 1.0}) {
    const SelfAffineCorrelation rho(H);
    for (double r : {100.0, 1e3, 1e5}) {
      const double ripple = 4 * H * ::j0(r) / (r * r);
      const double next = 8 * H * (1 + H) * std::pow(r, -3.5);
      CHECK(std::abs(rho(r) - ripple) <= next);
    }
  }
}

// Closed models: rounding of a few operations in an exponent below 5; tables: 1e-11 and the root's 1e-15.
TEST_CASE("every model falls to its level at its lengths along the turned axes", "[target][exact]") {
  for (Model model : every_model)
    for (double level : {0.01, 0.1, 0.9}) {
      EllipticTarget t = of(model);
      t.level = level;
      t.angle = 0.4;
      t.spacing_x = 0.5;
      t.spacing_y = 2;
      t.wavelength = t.length_x;  // the cosine is 1 at the length
      const Target R = t.target();
      const double c = std::cos(t.angle), s = std::sin(t.angle);
      CAPTURE(name_of(model), level);
      CHECK(R(0, 0) == 1);
      CHECK(std::abs(R(17 * c / 0.5, 17 * s / 2) - level) <= 1e-11);
      CHECK(std::abs(R(-4 * s / 0.5, 4 * c / 2) - level) <= 1e-11);
    }
}

TEST_CASE("β = 1 is the exponential, β = 2 the Gaussian, ν = 1/2 the exponential", "[target][exact]") {
  EllipticTarget stretched = of(Model::stretched_exponential), matern = of(Model::matern);
  const Target exponential = of(Model::exponential).target(), gaussian = of(Model::gaussian).target();
  matern.smoothness = 0.5;
  for (double beta : {1.0, 2.0}) {
    stretched.exponent = beta;
    const Target R = stretched.target(), half = matern.target();
    for (double p : {0.0, 1.0, 30.0})
      for (double q : {-9.0, 2.0}) {
        CHECK(R(p, q) == (beta == 1 ? exponential : gaussian)(p, q));
        CHECK(std::abs(half(p, q) - exponential(p, q)) <= 1e-11);
        CHECK(std::abs(exponential(p, q) - ExponentialTarget{17, 4}(p, q)) <= 20 * epsilon);
      }
  }
}

// Sampled between β = 1 and 2 the stretched exponential is computed by a power: level^(s^β) at s = 2.
TEST_CASE("the stretched exponential is level to the power 2 to the β at twice the length",
          "[target][exact]") {
  EllipticTarget t = of(Model::stretched_exponential);
  for (double beta : {0.01, 0.7, 1.3}) {
    t.exponent = beta;
    CHECK(relative_error(t.target()(34, 0), std::pow(0.1, std::pow(2, beta))) <= 50 * epsilon);
  }
}

TEST_CASE("the lay of exponential-cosine changes sign a quarter wavelength along the first axis only",
          "[target][exact]") {
  EllipticTarget t = of(Model::exponential_cosine);
  t.wavelength = 8;
  const Target R = t.target();
  CHECK(std::abs(R(2, 0)) <= 4 * epsilon);
  CHECK(relative_error(R(4, 0), -std::pow(0.1, 4.0 / 17)) <= 20 * epsilon);
  CHECK(relative_error(R(0, 2), std::pow(0.1, 0.5)) <= 20 * epsilon);
}

TEST_CASE("every target is even under point reflection to the last bit", "[target][exact]") {
  for (Model model : every_model)
    for (double angle : {0.0, 0.4, 2.0}) {
      EllipticTarget t = of(model);
      t.angle = angle;
      const Target R = t.target();
      for (double p : {0.0, 1.0, 13.0})
        for (double q : {-7.0, 0.0, 3.0}) CHECK(R(p, q) == R(-p, -q));
    }
}

TEST_CASE("quarter turns keep R(p,q) = R(p,-q) to the last bit and odd ones exchange the lengths",
          "[target][exact]") {
  for (Model model : every_model)
    for (int quarters : {-3, -2, -1, 0, 1, 2, 3, 4}) {
      EllipticTarget turned = of(model), straight = of(model);
      turned.angle = quarters * std::numbers::pi / 2;
      straight.spacing_x = turned.spacing_y = 0.7;
      if (quarters % 2 == 0) std::swap(straight.spacing_x, straight.spacing_y);
      const Target R = turned.target(), S = straight.target();
      CAPTURE(name_of(model), quarters);
      CHECK_FALSE(R.oriented);
      for (double p : {1.0, 5.0})
        for (double q : {1.0, 3.0}) {
          CHECK(R(p, q) == R(p, -q));
          CHECK(R(p, q) == (quarters % 2 == 0 ? S(p, q) : S(q, p)));
        }
    }
}

TEST_CASE("a target is oriented where its angle and its lengths make R(p,-q) differ from R(p,q)",
          "[target][contract]") {
  for (Model model : every_model) {
    EllipticTarget t = of(model);
    t.angle = 0.4;
    CHECK(t.target().oriented);
    CHECK(std::abs(t.target()(3, 2) - t.target()(3, -2)) > 0.01);
    t.length_y = t.length_x;
    t.spacing_y = 0.3;  // lengths in samples differ, the physical ones do not
    const Target R = t.target();
    CHECK(R.oriented == (model == Model::exponential_cosine));
    if (!R.oriented) CHECK(R(3, 2) == R(3, -2));
  }
}

TEST_CASE("the farthest parameters leave every value within [-1, 1]", "[target][contract]") {
  for (Model model : every_model)
    for (double length : {1e-100, 1e-6, 1.0, 1e6, 1e100})
      for (double ratio : {0.01, 1.0, 100.0})
        for (int extreme : {0, 1}) {
          EllipticTarget t = of(model);
          t.length_x = length == 1e100 ? length : length * std::max(1.0, ratio);
          t.length_y = length == 1e100 ? length : t.length_x / ratio;
          t.angle = 0.4;
          t.smoothness = extreme ? 100 : 0.01;
          t.exponent = extreme ? 2 : 1e-3;
          t.hurst = extreme ? 1 : 0.01;
          t.wavelength = extreme ? 1e100 : 1e-100;
          const Target R = t.target();
          CAPTURE(name_of(model), length, ratio, extreme);
          CHECK(R(0, 0) == 1);
          for (double p : {1e-9, 1.0, 1e4, 1e8}) {
            CHECK(within_one(R, p, 0));
            CHECK(within_one(R, 1, -p));
          }
          for (double u : {1e-300, 1e-3, 0.999}) {
            const Shape box = R.reach(u);
            CHECK((box.nx >= 1 && box.ny >= 1 && box.nx <= Index{1} << 30 && box.ny <= Index{1} << 30));
          }
        }
}

TEST_CASE("each parameter of a model is refused by its name, and only where the model has it",
          "[target][contract]") {
  const double none = std::nan("");
  auto refused = [](Model model, double EllipticTarget::*member, double value) {
    EllipticTarget t = of(model);
    t.*member = value;
    try {
      t.target();
    } catch (const ParameterError& e) {
      return e.name;
    }
    return std::string();
  };
  for (Model model : every_model) {
    for (double bad : {0.0, -1.0, none, std::numeric_limits<double>::infinity()}) {
      CHECK(refused(model, &EllipticTarget::length_x, bad) == "length");
      CHECK(refused(model, &EllipticTarget::length_y, bad) == "length");
      CHECK(refused(model, &EllipticTarget::spacing_x, bad) == "spacing");
      CHECK(refused(model, &EllipticTarget::spacing_y, bad) == "spacing");
    }
    for (double bad : {0.0, 1.0, -0.5, none})
      CHECK(refused(model, &EllipticTarget::level, bad) == "length-level");
    CHECK(refused(model, &EllipticTarget::angle, none) == "angle");
    for (double bad : {-1.0, none, 1e101}) {
      auto name = [&](Model owner, const char* text) { return model == owner ? text : ""; };
      CHECK(refused(model, &EllipticTarget::smoothness, bad) == name(Model::matern, "smoothness"));
      CHECK(refused(model, &EllipticTarget::exponent, bad) == name(Model::stretched_exponential, "exponent"));
      CHECK(refused(model, &EllipticTarget::hurst, bad) == name(Model::self_affine, "hurst"));
      CHECK(refused(model, &EllipticTarget::wavelength, bad) ==
            name(Model::exponential_cosine, "wavelength"));
    }
  }
  for (double good : {0.01, 1.0}) CHECK(refused(Model::self_affine, &EllipticTarget::hurst, good).empty());
  CHECK(refused(Model::self_affine, &EllipticTarget::hurst, 0.009) == "hurst");
  CHECK(refused(Model::matern, &EllipticTarget::smoothness, 100.1) == "smoothness");
  CHECK(refused(Model::stretched_exponential, &EllipticTarget::exponent, 2.01) == "exponent");
}

// 1 - ρ = 1e-9 lies at (1e-9)^50 of the roll-off for H = ν = 0.01.
TEST_CASE("a level that the model passes at no lag above zero is refused", "[target][contract]") {
  for (Model model : {Model::matern, Model::self_affine}) {
    EllipticTarget t = of(model);
    t.smoothness = t.hurst = 0.01;
    t.level = 1 - 1e-9;
    try {
      t.target();
      FAIL("accepted");
    } catch (const ParameterError& e) {
      CHECK(e.name == "length-level");
    }
  }
}
