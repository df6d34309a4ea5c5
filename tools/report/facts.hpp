/// What a dataset's global attributes say of how it was made: the parameters in effect, what came out, and what the
/// solvers achieved, in words and readable units.
#pragma once

#include <string>
#include <vector>

#include "dataset/catalogue.hpp"
#include "dataset/dataset.hpp"

namespace asperity::report {

struct Fact {
  Role role;
  std::string stage;      ///< the prefix: kernel, generate, contact, stress
  std::string attribute;  ///< its name
  std::string label, text;
};

/// In the order in which the tools run, of each tool that in which a reader asks.
std::vector<Fact> facts_of(const Dataset& data);
/// The global attributes that are none of these, but for the history and source.
std::vector<Fact> other_attributes(const Dataset& data);

/// What a reader must know before believing a number: solvers that did not converge, a target changed.
std::vector<std::string> warnings_of(const Dataset& data);

/// A number, or several of them.
std::string text_of(const Values& values);

}  // namespace asperity::report
