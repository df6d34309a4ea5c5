#include "core/ranks.hpp"

#include <cmath>
#include <new>
#include <numeric>
#include <stdexcept>

#include "core/error.hpp"

namespace asperity {

namespace {

constexpr Index own_cells = 1 << 18;  // up to which each of several ranks does all

}  // namespace

void Ranks::exchange(const Pieces& to, const Room& from) const {
  std::ranges::copy(to.front(), from.front().begin());
}

void Ranks::end(int, const std::string&) const {}

const Ranks& alone() {
  static const Ranks only;
  return only;
}

Slabs shared_rows(Shape shape, const Ranks& ranks) {
  const bool worth = shape.cells() > own_cells && shape.nx >= Slabs::run * ranks.count();
  return worth ? Slabs(shape.nx, ranks) : Slabs(shape.nx);
}

double largest(const Ranks& ranks, double own) {
  double out = own;
  for (const double other : gathered(ranks, std::vector{own}))
    out = std::isnan(out) ? out : other > out || std::isnan(other) ? other : out;
  return out;
}

namespace {

// Kind, name and words of an error, for other ranks.
std::string packed_error(char kind, const std::string& name, const char* words) {
  return kind + name + '\0' + words + '\0';
}

std::string error_of(const std::function<void()>& work) try {
  work();
  return "";
} catch (const ParameterError& e) {
  return packed_error('p', e.name, e.what());
} catch (const DataError& e) {
  return packed_error('d', e.name, e.what());
} catch (const std::bad_alloc&) {
  return packed_error('r', "", "out of memory");
} catch (const std::exception& e) {
  return packed_error('r', "", e.what());
}

}  // namespace

void agree(const Ranks& ranks, const std::function<void()>& work) {
  if (ranks.count() == 1) return work();
  const std::string own = error_of(work);
  const std::vector<char> all = gathered(ranks, std::vector<char>(own.begin(), own.end()));
  if (all.empty()) return;
  const std::string name = all.data() + 1, words = all.data() + 1 + name.size() + 1;
  if (all[0] == 'p') throw ParameterError(name, words);
  if (all[0] == 'd') throw DataError(name, words);
  throw std::runtime_error(words);
}

Field rows_of(const ConstRows& own, const Slabs& slabs, const std::vector<Index>& wanted) {
  Field out(std::ssize(wanted), own.cols());
  if (!slabs.shared()) {
    for (Index k = 0; k < out.rows(); ++k) out.row(k) = own.row(wanted[size(k)]);
    return out;
  }
  const Ranks& ranks = slabs.ranks();
  const auto all = static_cast<std::size_t>(ranks.count());
  std::vector<std::vector<Index>> asked(all), places(all);
  for (Index k = 0; k < out.rows(); ++k)
    for (std::size_t r = 0; r < all; ++r)
      if (const Extent theirs = slabs.of(static_cast<int>(r));
          wanted[size(k)] >= theirs.first && wanted[size(k)] < theirs.end()) {
        asked[r].push_back(wanted[size(k)]);
        places[r].push_back(k);
      }
  std::vector<std::vector<Index>> counts;
  for (const auto& rows : asked) counts.push_back({std::ssize(rows)});
  const auto lengths = exchanged(ranks, counts, [](int) { return Index{1}; });
  const auto to_send =
      exchanged(ranks, asked, [&](int r) { return lengths[static_cast<std::size_t>(r)].front(); });
  std::vector<std::vector<double>> rows(all);
  for (std::size_t r = 0; r < all; ++r) {
    rows[r].reserve(to_send[r].size() * size(own.cols()));
    for (const Index i : to_send[r]) {
      const double* row = own.data() + (i - slabs.own().first) * own.outerStride();
      rows[r].insert(rows[r].end(), row, row + own.cols());
    }
  }
  const auto found = exchanged(
      ranks, rows, [&](int r) { return std::ssize(asked[static_cast<std::size_t>(r)]) * own.cols(); });
  for (std::size_t r = 0; r < all; ++r)
    for (Index k = 0; k < std::ssize(places[r]); ++k)
      out.row(places[r][size(k)]) = Eigen::Map<const Eigen::Array<double, 1, Eigen::Dynamic>>(
          found[r].data() + k * own.cols(), own.cols());
  return out;
}

Field rows_of(const ConstRows& own, const Slabs& slabs, Extent wanted) {
  std::vector<Index> rows(size(wanted.count));
  std::iota(rows.begin(), rows.end(), wanted.first);
  return rows_of(own, slabs, rows);
}

Field transposed(const ConstRows& own, const Slabs& slabs) {
  const Ranks& ranks = slabs.ranks();
  const Slabs columns(own.cols(), ranks);
  std::vector<std::vector<double>> to(static_cast<std::size_t>(ranks.count()));
  for (int r = 0; r < ranks.count(); ++r) {
    const Field theirs = own.middleCols(columns.of(r).first, columns.of(r).count).transpose();
    to[static_cast<std::size_t>(r)].assign(theirs.data(), theirs.data() + theirs.size());
  }
  const Index here = columns.own().count;
  const auto parts = exchanged(ranks, to, [&](int r) { return here * slabs.of(r).count; });
  Field out(here, slabs.rows());
  for (int r = 0; r < ranks.count(); ++r) {
    const Extent rows = slabs.of(r);
    out.middleCols(rows.first, rows.count) =
        Eigen::Map<const Field>(parts[static_cast<std::size_t>(r)].data(), here, rows.count);
  }
  return out;
}

}  // namespace asperity
