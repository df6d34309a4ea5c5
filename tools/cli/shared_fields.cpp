#include "tools/cli/shared_fields.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "dataset/netcdf.hpp"
#include "dataset/unread.hpp"

namespace asperity::cli {

class SharedFields::Served : public std::enable_shared_from_this<Served> {
 public:
  explicit Served(const Slabs& of) : slabs(of) {}

  const Slabs slabs;
  std::vector<Field> fields = {};

  std::shared_ptr<const Unread> last_field() {
    const auto number = std::ssize(fields) - 1;
    const auto count = size(slabs.rows() * fields.back().cols());
    return std::make_shared<const Unread>(
        Unread{std::make_shared<Rows>(shared_from_this(), number), 0, count * sizeof(double), 0, count});
  }

  // On the first rank.
  void stop() const { ask({.field = -1}); }
  // On the others, until it says so.
  void serve() const {
    for (Request request = heard(); request.field >= 0; request = heard()) answer(request);
  }

 private:
  // Values of a field, by their numbers. Field -1: that was all.
  struct Request {
    Index field = 0, begin = 0, end = 0;
  };
  class Rows : public Source {
   public:
    Rows(std::shared_ptr<const Served> of, Index field) : of_(std::move(of)), field_(field) {}
    void read(std::uint64_t at, std::span<char> to) const override {
      constexpr std::size_t bytes = sizeof(double);
      const auto begin = static_cast<Index>(at / bytes);
      const Request request{field_, begin, begin + static_cast<Index>(to.size() / bytes)};
      of_->ask(request);
      std::ranges::copy(of_->answer(request), to.begin());
    }

   private:
    std::shared_ptr<const Served> of_;
    Index field_;
  };

  // The first rank asks, the others hear it.
  void ask(const Request& request) const { gathered(slabs.ranks(), std::vector{request}); }
  Request heard() const { return gathered(slabs.ranks(), std::vector<Request>{}).front(); }

  // The first rank gets the values, as bytes of the file, from those that have their rows.
  std::string answer(const Request& request) const {
    const Field& own = fields[size(request.field)];
    Extent rows;
    if (slabs.ranks().rank() == 0) {
      const Index columns = own.cols(), first = request.begin / columns;
      rows = {first, (request.end + columns - 1) / columns - first};
    }
    const Field whole = rows_of(own, slabs, rows);
    if (whole.size() == 0) return {};
    return encode_values(
        {whole.data() + (request.begin - rows.first * own.cols()), size(request.end - request.begin)});
  }
};

SharedFields::SharedFields(const Slabs& slabs) : served_(std::make_shared<Served>(slabs)) {}

const Slabs& SharedFields::slabs() const { return served_->slabs; }

void SharedFields::set(Dataset& data, std::string_view name, Field own, Meaning meaning) {
  if (!slabs().shared()) return set_field(data, name, own, meaning);
  const Ranks& ranks = slabs().ranks();
  auto most = [&](const auto& values) {  // of no rows less than of any
    return largest(ranks, values.size() > 0 ? values.template maxCoeff<Eigen::PropagateNaN>() : -INFINITY);
  };
  const double low = -most(-own), high = most(own);
  defer_values(data, name, {"x", "y"}, {low, high}, meaning);
  served_->fields.push_back(std::move(own));
  data.find(name)->unread = served_->last_field();
}

void SharedFields::first_writes(const std::function<void()>& write) const {
  if (!slabs().shared()) {
    if (slabs().ranks().rank() == 0) write();
    return;
  }
  if (slabs().ranks().rank() > 0) return served_->serve();
  struct Stop {
    const Served& others;
    ~Stop() { others.stop(); }
  } at_end{*served_};
  write();
}

}  // namespace asperity::cli
