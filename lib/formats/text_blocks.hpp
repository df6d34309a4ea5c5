/// TextBlocks of lines of numbers in a text, which would be several maps in one file.
///
/// Lines are parted by an empty line, or by a comment like the head of a block: its words are, but for
/// numbers and digits, those of a comment above all numbers; or there are three words at most and the first
/// is block, channel, data, frame, image, layer or map. If no two lines stand together, all are lines of one
/// map.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace asperity {

class TextBlocks {
 public:
  void empty_line() { below_ = "an empty line"; }
  /// `above`: no line of numbers has come so far; likewise `first`.
  void comment(std::string_view line, bool above);
  void numbers(std::size_t line, bool first);

  /// The line of numbers where the second block begins; 0 if there is one block.
  std::size_t second() const { return several_ ? second_ : 0; }
  /// What stands above that line, in words.
  const std::string& parted_by() const { return parted_by_; }

 private:
  std::set<std::string> heads_{};  // words of the comments above all numbers
  std::string below_{}, parted_by_{};
  std::size_t second_ = 0;
  bool several_ = false;  // two lines of numbers stand together
};

}  // namespace asperity
