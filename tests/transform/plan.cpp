#include "transform/plan.hpp"

#include <numbers>

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

Complex root(Index jk, Index n) {
  return std::polar(1.0, -two_pi * static_cast<double>(jk % n) / static_cast<double>(n));
}

// Numbers of order one: a transform of n points errs by ε log2(n) √n or so, in the largest by less than ε n.
double bound(Index n) { return epsilon * 4 * static_cast<double>(n); }

}  // namespace

TEST_CASE("a real transform is the defining sum, and its inverse undoes it n times", "[transform][exact]") {
  for (Index n : {1, 2, 3, 8, 15, 30}) {
    const RealTransform2D transform({1, n});
    const Field random = random_field({1, n}, 1);
    AlignedVector<double> x(random.data(), random.data() + n), back(x.size());
    AlignedVector<Complex> spectrum(static_cast<std::size_t>(n / 2 + 1));
    transform.forward(x.data(), spectrum.data());
    for (Index k = 0; k <= n / 2; ++k) {
      Complex sum{};
      for (Index j = 0; j < n; ++j) sum += random(0, j) * root(j * k, n);
      CHECK(std::abs(spectrum[static_cast<std::size_t>(k)] - sum) <= bound(n));
    }
    transform.inverse(spectrum.data(), back.data());
    for (std::size_t j = 0; j < x.size(); ++j)
      CHECK(std::abs(back[j] - static_cast<double>(n) * x[j]) <= bound(n));
  }
}

TEST_CASE("columns are transformed each by itself", "[transform][exact]") {
  const Index n = 12, width = 8;
  const ColumnTransform transform(n, width);
  const Field re = random_field({n, width}, 2), im = random_field({n, width}, 3);
  AlignedVector<Complex> data(static_cast<std::size_t>(transform.size())), out(data);
  auto at = [&](auto& v, Index j, Index q) -> Complex& {
    return v[static_cast<std::size_t>(q * transform.stride() + j)];
  };
  for (Index j = 0; j < n; ++j)
    for (Index q = 0; q < width; ++q) at(data, j, q) = {re(j, q), im(j, q)};
  transform.forward(data.data(), out.data());
  for (Index k = 0; k < n; ++k)
    for (Index q = 0; q < width; ++q) {
      Complex sum{};
      for (Index j = 0; j < n; ++j) sum += Complex(re(j, q), im(j, q)) * root(j * k, n);
      CHECK(std::abs(at(out, k, q) - sum) <= bound(n));
    }
  transform.inverse(out.data(), data.data());
  CHECK(std::abs(at(data, 5, 3) - static_cast<double>(n) * Complex(re(5, 3), im(5, 3))) <= bound(n * n));
}

TEST_CASE("a wave in two dimensions is one line of its spectrum", "[transform][exact]") {
  const Shape shape{12, 10};
  const RealTransform2D transform(shape);
  Field wave(shape.nx, shape.ny);
  for (Index i = 0; i < shape.nx; ++i)
    for (Index j = 0; j < shape.ny; ++j)
      wave(i, j) = std::cos(two_pi * (5.0 * static_cast<double>(i) / 12 + 3.0 * static_cast<double>(j) / 10));
  AlignedVector<double> in(wave.data(), wave.data() + wave.size());
  AlignedVector<Complex> out(static_cast<std::size_t>(transform.spectrum_size()));
  transform.forward(in.data(), out.data());
  for (Index k = 0; k < shape.nx; ++k)
    for (Index l = 0; l < transform.spectrum_columns(); ++l) {
      const double expected = k == 5 && l == 3 ? 60 : 0;
      CHECK(std::abs(out[static_cast<std::size_t>(k * transform.spectrum_columns() + l)] - expected) <=
            bound(120));
    }
}
