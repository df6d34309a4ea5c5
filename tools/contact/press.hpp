/// A contact from its scene, and what is said about it.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "contact/doubts.hpp"
#include "contact/elastic_operator.hpp"
#include "tools/contact/resolution.hpp"
#include "tools/contact/scene.hpp"

namespace asperity::cli {

/// Influence coefficients and plans, made once for all surfaces of one grid. No contact depends on those
/// before it.
class Influence {
 public:
  explicit Influence(const ContactOptions& options) : options_(options) {}
  ElasticOperator& on(const Grid& grid);
  /// Spent on them since the last call.
  double further_seconds();

 private:
  const ContactOptions& options_;
  Grid grid_ = {};
  std::unique_ptr<ElasticOperator> made_ = {};
  double told_ = 0;
};

/// As many of them as there are contacts at once.
class Influences {
 public:
  explicit Influences(const ContactOptions& options) : options_(options) {}
  /// What use(influence) returns, with one that nobody else uses meanwhile; one that fails is not used again.
  template <class Use>
  auto with_one(const Use& use) {
    std::unique_ptr<Influence> one = taken();
    auto out = use(*one);
    put_back(std::move(one));
    return out;
  }

 private:
  std::unique_ptr<Influence> taken();
  void put_back(std::unique_ptr<Influence> one);

  const ContactOptions& options_;
  std::mutex mutex_ = {};
  std::vector<std::unique_ptr<Influence>> free_ = {};
};

struct Pressed {
  Contact contact;
  GridFigures figures;
  std::vector<Doubt> doubts;
};

/// Solves the scene and records the result in its dataset.
Pressed press(const ContactOptions& options, ContactScene& scene, Influence& influence);

/// Why a contact, or a stiffness that was asked for, has not converged; "" of one that has.
std::string unconverged(const ContactOptions& options, const Contact& contact);

}  // namespace asperity::cli
