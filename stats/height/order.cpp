#include "stats/height/order.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

namespace asperity {
namespace {

constexpr int digit = 16;
constexpr std::uint64_t sign = std::uint64_t{1} << 63, digits = std::uint64_t{1} << digit;

// Increasing with the height: negative numbers have all their bits turned over.
std::uint64_t key_of(double height) {
  const auto bits = std::bit_cast<std::uint64_t>(height);
  return bits & sign ? ~bits : bits | sign;
}

double height_of(std::uint64_t key) { return std::bit_cast<double>(key & sign ? key & ~sign : ~key); }

// The bits above the digit that is counted.
std::uint64_t beginning(std::uint64_t key, int shift) {
  return shift + digit < 64 ? key >> (shift + digit) : 0;
}

}  // namespace

HeightBins::HeightBins(const Moments& moments, Index count)
    : mean_(moments.mean), sa_(moments.sa), bins_(static_cast<std::size_t>(count)) {}

// Each operation is monotone when rounded, so that no height lands in a bin beyond a higher one's.
std::size_t HeightBins::bin_of(double height) const {
  const double x = (height - mean_) / sa_, t = std::copysign(1 - 1 / (1 + std::abs(x)), x);
  const auto index = static_cast<std::size_t>(0.5 * (1 + t) * static_cast<double>(bins_.size()));
  return std::min(index, bins_.size() - 1);
}

void HeightBins::add(const Field& strip) {
  for (const double height : strip.reshaped<Eigen::RowMajor>()) {
    if (std::isnan(height)) continue;
    HeightBin& bin = bins_[bin_of(height)];
    bin.lowest = bin.count > 0 ? std::min(bin.lowest, height) : height;
    bin.highest = bin.count > 0 ? std::max(bin.highest, height) : height;
    ++bin.count;
  }
}

std::vector<HeightBin> HeightBins::ascending() const {
  std::vector<HeightBin> out;
  std::ranges::copy_if(bins_, std::back_inserter(out), [](const HeightBin& bin) { return bin.count > 0; });
  return out;
}

RankSelection::RankSelection(const std::vector<std::uint64_t>& ranks) {
  for (const std::uint64_t rank : ranks) targets_.push_back({rank});
  for (Target& target : targets_) target.counts.assign(digits, 0);
}

void RankSelection::add(const Field& z) {
  for (const double height : z.reshaped<Eigen::RowMajor>()) {
    if (std::isnan(height)) continue;
    const std::uint64_t key = key_of(height);
    for (Target& target : targets_)
      if (beginning(key, shift_) == beginning(target.key, shift_))
        ++target.counts[key >> shift_ & (digits - 1)];
  }
}

void RankSelection::end_pass() {
  for (Target& target : targets_) {
    std::uint64_t next = 0;
    for (; target.rank >= target.counts[next]; ++next) target.rank -= target.counts[next];
    target.key |= next << shift_;
    target.counts.assign(digits, 0);
  }
  shift_ -= digit;
}

double RankSelection::height(std::size_t i) const { return height_of(targets_.at(i).key); }

}  // namespace asperity
