/// Warnings that come again for one surface after another: in full for the first, counted for the others. The
/// same warning about the same surface, which is read twice, counts once.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace asperity::cli {

class Repeated {
 public:
  /// The line to say now, "s_1.nc: text"; none if one of other numbers has been said.
  std::optional<std::string> first(const std::string& surface, const std::string& text);
  /// A line for each kind that came again: "3 more surfaces, up to s_9.nc: text of the last"; begins anew.
  std::vector<std::string> rest();

 private:
  struct Kind {
    std::string words;  ///< without numbers
    int more = 0;
    std::string surface = {}, text = {};  ///< of the last
  };
  std::vector<Kind> kinds_;
  std::set<std::string> told_ = {};
};

}  // namespace asperity::cli
