#include "dataset/unread.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <system_error>
#include <type_traits>
#include <unistd.h>
#include <utility>

#include "core/error.hpp"
#include "core/memory.hpp"
#include "dataset/classic_head.hpp"

namespace asperity {
namespace {

[[noreturn]] void refuse_cut_short() {
  throw DataError("dataset", "the file is cut short: it has become shorter while it was read");
}

class InMemory : public Source {
 public:
  explicit InMemory(std::string_view bytes) : bytes_(bytes) {}
  explicit InMemory(Bytes bytes) : owned_(std::move(bytes)), bytes_(owned_) {}
  void read(std::uint64_t at, std::span<char> to) const override {
    if (at > bytes_.size() || to.size() > bytes_.size() - at) refuse_cut_short();
    std::memcpy(to.data(), bytes_.data() + at, to.size());
  }

 private:
  Bytes owned_;
  std::string_view bytes_;
};

class OnDisk : public Source {
 public:
  explicit OnDisk(const std::string& path) : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (file_ < 0) throw std::system_error(errno, std::generic_category(), path);
  }
  ~OnDisk() override { ::close(file_); }
  OnDisk(const OnDisk&) = delete;
  OnDisk& operator=(const OnDisk&) = delete;
  void read(std::uint64_t at, std::span<char> to) const override {
    while (!to.empty()) {
      const ssize_t n = ::pread(file_, to.data(), to.size(), static_cast<off_t>(at));
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) throw std::system_error(errno, std::generic_category(), "reading the dataset");
      if (n == 0) refuse_cut_short();
      to = to.subspan(static_cast<std::size_t>(n));
      at += static_cast<std::uint64_t>(n);
    }
  }

 private:
  int file_;
};

constexpr std::size_t piece = std::size_t{1} << 18;  // bytes, which stay in the cache

// Read and swapped piece by piece, so that each is touched once.
template <class List>
void read_into(List& to, const Unread& from, std::size_t first) {
  using Element = typename List::value_type;
  for (std::size_t done = 0; done < to.size();) {
    const std::span<Element> part(to.data() + done, std::min(piece / sizeof(Element), to.size() - done));
    from.read((first + done) * sizeof(Element), {reinterpret_cast<char*>(part.data()), part.size_bytes()});
    swap_bytes(part);
    done += part.size();
  }
}

template <class List>
List room_for(std::size_t n) {
  if constexpr (std::is_same_v<List, std::string>)
    return List(n, '\0');
  else
    return large_list<typename List::value_type>(n);
}

}  // namespace

std::shared_ptr<const Source> source_of(std::string_view bytes) { return std::make_shared<InMemory>(bytes); }
std::shared_ptr<const Source> source_of(Bytes bytes) { return std::make_shared<InMemory>(std::move(bytes)); }
std::shared_ptr<const Source> source_on_disk(const std::string& path) {
  return std::make_shared<OnDisk>(path);
}

void Unread::read(std::uint64_t first, std::span<char> to) const {
  while (!to.empty()) {
    const std::uint64_t within = first % slab, here = std::min<std::uint64_t>(slab - within, to.size());
    source->read(begin + first / slab * stride + within, to.first(here));
    to = to.subspan(here);
    first += here;
  }
}

std::size_t count(const Variable& variable) {
  return variable.unread ? variable.unread->count : count(variable.values);
}

std::size_t element_size(const Values& values) {
  return std::visit([](const auto& list) { return sizeof(list[0]); }, values);
}

std::size_t size_in_memory(const Variable& variable) {
  return count(variable) * element_size(variable.values);
}

Values values_of(const Variable& variable, std::size_t first, std::size_t count) {
  const auto part = [&](const auto& all) {
    using List = std::decay_t<decltype(all)>;
    if (!variable.unread) {
      const auto at = all.begin() + static_cast<std::ptrdiff_t>(first);
      return Values(List(at, at + static_cast<std::ptrdiff_t>(count)));
    }
    auto out = room_for<List>(count);
    read_into(out, *variable.unread, first);
    return Values(std::move(out));
  };
  return std::visit(part, variable.values);
}

void in_pieces(const Variable& variable, const std::function<void(const Values&)>& take) {
  if (!variable.unread) return take(variable.values);
  const std::size_t all = count(variable), most = piece / element_size(variable.values);
  Values buffer = variable.values;
  const auto each = [&](auto& list) {
    for (std::size_t done = 0; done < all; done += list.size()) {
      list.resize(std::min(most, all - done));
      read_into(list, *variable.unread, done);
      take(buffer);
    }
  };
  std::visit(each, buffer);
}

void load(Variable& variable) {
  if (!variable.unread) return;
  variable.values = values_of(variable, 0, count(variable));
  variable.unread.reset();
}

void load(Dataset& dataset) {
  for (Variable& variable : dataset.variables) load(variable);
}

}  // namespace asperity
