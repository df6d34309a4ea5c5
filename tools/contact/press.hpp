/// A contact from its scene, and what is said about it.
#pragma once

#include <functional>
#include <map>
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
  /// Calls use(influence) with one that nobody else uses meanwhile.
  template <class Use>
  auto with_one(const Use& use) {
    const Lease lease(*this);
    return use(*lease.one);
  }

 private:
  struct Lease {
    explicit Lease(Influences& of) : stock(of), one(of.taken()) {}
    ~Lease() { stock.put_back(std::move(one)); }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;

    Influences& stock;
    std::unique_ptr<Influence> one;
  };
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

/// Doubts of a sweep: each kind in full at its first load, then a count and the last load.
class SweepDoubts {
 public:
  void add(const Tool& tool, const std::vector<Doubt>& doubts, const std::string& load);
  void tell(const Tool& tool) const;

 private:
  struct Seen {
    int loads = 0;
    std::string last;
  };
  std::map<std::string_view, Seen> seen_ = {};
};

/// Why a contact, or a stiffness that was asked for, has not converged; "" of one that has.
std::string unconverged(const ContactOptions& options, const Contact& contact);

}  // namespace asperity::cli
