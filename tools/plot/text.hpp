/// Lengths of texts, and texts made to fit.
///
/// Widths are those of DejaVu Sans, at most: figures and most letters are 0.64 em wide, f, i, l and blanks
/// 0.42 em, capitals 0.78 em, signs such as − and × 0.84 em, M, W and their like 1 em; letters of East Asia
/// take 1.1 em.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace asperity::plot {

inline constexpr double letter_width = 0.64;  // [em]

/// Characters of a UTF-8 text, and the length that they take at most [em].
double letters(std::string_view text);
double length_of(std::string_view text);

/// A line of at most this length [em]: of a longer text an ellipsis replaces the middle, for names differ at
/// their ends, and labels end with their unit.
std::string shortened(const std::string& text, double most);
/// Lines of at most this length, broken at blanks, after a comma in their second half if there is one; the
/// last of `lines` takes what is left, shortened.
std::vector<std::string> broken(const std::string& text, double most, std::size_t lines);

}  // namespace asperity::plot
