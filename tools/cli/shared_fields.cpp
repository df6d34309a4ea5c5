#include "tools/cli/shared_fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
  // On the others, until they are told to stop.
  void serve() const {
    for (Request request = heard(); request.field >= 0; request = heard()) answer(request, {});
  }

 private:
  struct Request {
    Index field = 0, begin = 0, end = 0;  // values
  };
  class Rows : public Source {
   public:
    Rows(std::shared_ptr<const Served> of, Index field) : of_(std::move(of)), field_(field) {}
    void read(std::uint64_t at, std::span<char> to) const override {
      constexpr std::size_t bytes = sizeof(double);
      const auto begin = static_cast<Index>(at / bytes);
      const Request request{field_, begin, begin + static_cast<Index>(to.size() / bytes)};
      of_->ask(request);
      of_->answer(request, to);
    }

   private:
    std::shared_ptr<const Served> of_;
    Index field_;
  };

  const Ranks& ranks() const { return slabs.ranks(); }
  std::size_t all() const { return static_cast<std::size_t>(ranks().count()); }

  void ask(const Request& request) const {
    Request self;
    Ranks::Room from(all());
    from.front() = std::as_writable_bytes(std::span(&self, 1));
    ranks().exchange(Ranks::Pieces(all(), std::as_bytes(std::span(&request, 1))), from);
  }
  Request heard() const {
    Request out;
    Ranks::Room from(all());
    from.front() = std::as_writable_bytes(std::span(&out, 1));
    ranks().exchange(Ranks::Pieces(all()), from);
    return out;
  }

  // The values of the request that a rank has.
  Request part_of(const Request& request, int rank, Index columns) const {
    const Extent rows = slabs.of(rank);
    const Index begin = std::clamp(rows.first * columns, request.begin, request.end);
    return {request.field, begin, std::max(begin, std::min(rows.end() * columns, request.end))};
  }
  // Everybody's values to the first rank.
  void answer(const Request& request, std::span<char> to) const {
    const Field& own = fields[size(request.field)];
    const Request mine = part_of(request, ranks().rank(), own.cols());
    const double* values = own.data() + (mine.begin - slabs.own().first * own.cols());
    const std::string bytes = encode_values({values, size(mine.end - mine.begin)});
    Ranks::Pieces pieces(all());
    pieces.front() = std::as_bytes(std::span(bytes));
    Ranks::Room room(all());
    if (ranks().rank() == 0)
      for (int r = 0; r < ranks().count(); ++r) {
        const Request theirs = part_of(request, r, own.cols());
        room[static_cast<std::size_t>(r)] =
            std::as_writable_bytes(to.subspan(size(theirs.begin - request.begin) * sizeof(double),
                                              size(theirs.end - theirs.begin) * sizeof(double)));
      }
    ranks().exchange(pieces, room);
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
