/// An operator that counts what is asked of it.
#pragma once

#include "contact/elastic_operator.hpp"

namespace asperity {

class CountedOperator final : public ElasticOperator {
 public:
  explicit CountedOperator(ElasticOperator& counted) : counted_(counted) {}

  Shape shape() const override { return counted_.shape(); }
  void apply(const Field& p, Field& u) override { ++convolutions, counted_.apply(p, u); }
  void precondition(const Field& r, Field& z) override { ++preconditionings, counted_.precondition(r, z); }
  double self_influence() const override { return counted_.self_influence(); }
  std::unique_ptr<ElasticOperator> coarsened() const override { return counted_.coarsened(); }

  int convolutions = 0, preconditionings = 0;

 private:
  ElasticOperator& counted_;
};

}  // namespace asperity
