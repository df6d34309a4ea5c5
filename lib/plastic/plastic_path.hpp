/// How plastic/plastic_contact.hpp goes along its path: what it knows, and its steps.
#pragma once

#include <span>

#include "plastic/plastic_contact.hpp"

namespace asperity {

class PlasticContact::Path {
 public:
  Path(const Grid& grid, Field gap, const Bodies& bodies, ElasticOperator& influence,
       ContactParameters contact_parameters, PlasticParameters parameters);

  void go_to(const PlasticTarget& target, int increments);
  std::optional<Index> flowing(std::size_t body) const {
    if (!materials_[body].hardening.flows()) return std::nullopt;
    return body == 1 && materials_[0].hardening.flows() && !alike() ? 1 : 0;
  }
  Field displacement(std::size_t body);

  Contact contact;
  PlasticBox box;
  std::vector<std::unique_ptr<FlowingBody>> flowing_bodies;
  int evaluations = 0;
  double convolutions = 0, residual = 0;
  bool at_side = false;
  std::string reason;

 private:
  bool alike() const { return materials_[0] == materials_[1]; }
  void choose_box(const PlasticTarget& target);
  void check_borne(const PlasticTarget& target, double yield) const;
  BoxSides reached() const;
  bool flows_at_side() const;
  ContactParameters parameters_of(const PlasticTarget& target) const;
  Contact untouched(const Field& gap, std::optional<double> approach = {}) const;
  void solve(const PlasticTarget& target, const Field& displaced);
  PlasticTarget between(const PlasticTarget& target, double begin, double part) const;
  void load_elastically(const PlasticTarget& target);
  double yield_share();
  void increment(const PlasticTarget& target, bool goes_on);
  bool flow(const PlasticTarget& target, bool goes_on);
  void extend(std::vector<double>& unknowns);
  void evaluate(const PlasticTarget& target, std::span<const double> unknowns, std::span<double> out);
  std::vector<double> scale() const;
  /// use(body, its share of the unknowns), in order.
  template <class Unknowns, class Use>
  void each_share(Unknowns unknowns, Use use) {
    std::size_t first = 0;
    for (auto& body : flowing_bodies) {
      const std::size_t count = size(body->unknowns());
      use(*body, unknowns.subspan(first, count));
      first += count;
    }
  }

  const Grid grid_;
  const Field gap_;
  ElasticOperator& influence_;
  ContactParameters contact_parameters_;
  PlasticParameters parameters_;
  std::array<PlasticMaterial, 2> materials_;
  std::vector<double> changed_;  ///< D' of the last evaluation
  double largest_ = 0;           ///< von Mises over flow stress where it is no unknown, likewise
  double last_residual_ = 1;
  bool flowed_ = false;
  std::array<Field, 2> displaced_;  ///< of the flowing bodies, on the whole grid, or empty
};

}  // namespace asperity
