// What a tool reads and writes.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/parallel.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "tools/cli/ordered_work.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/place.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

thread_local std::string Tool::reading_;

namespace {

// The file gets its name in order.
void put(const Dataset& dataset, const std::string& name) {
  const auto file = std::make_shared<OutputFile>(name);
  write_netcdf(dataset, [&](std::string_view bytes) { file->write(bytes); });
  in_order([file] { file->close(); });
}

}  // namespace

MemoryBound Tool::memory_bound(std::size_t held) const {
  constexpr std::size_t always_read = std::size_t{16}
                                      << 20;  // whatever --memory says: little beside the program's own
  return {std::max(memory_, always_read), held};
}

Dataset Tool::read() const { return read(input_); }

Dataset Tool::read(const std::string& name, std::size_t held) const {
  const std::string first = first_bytes(name);
  if (!looks_like_netcdf(first) || !format_.netcdf(first))
    return read(read_all(name, memory_bound(held)), name, held);
  return read_by(name, first, [&] { return open_netcdf(name, memory_bound(held)); });
}

Dataset Tool::read(const Bytes& bytes, const std::string& name, std::size_t held) const {
  return read_by(name, bytes, [&] { return format_.dataset(bytes, name, memory_bound(held)); });
}

Dataset Tool::read(Bytes&& bytes, const std::string& name, std::size_t held) const {
  if (!format_.netcdf(bytes)) return read(std::as_const(bytes), name, held);
  return read_by(name, bytes, [&] {
    const MemoryBound left = memory_bound(held + bytes.size());
    return open_netcdf(std::move(bytes), left);
  });
}

Dataset Tool::read_by(const std::string& name, std::string_view first_bytes,
                      const std::function<Dataset()>& decoded) const {
  const bool netcdf = format_.netcdf(first_bytes);
  reads(name, result_is_dataset_ && netcdf);
  if (netcdf)
    format_.found(first_bytes, name);  // refuses what is given for a map alone
  else
    detail(format_.reason(first_bytes, name));
  Dataset data = decoded();
  settle(data, name);
  return data;
}

void Tool::settle(Dataset& dataset, const std::string& name) const {
  const std::string of = name == "-" ? "" : name + ": ";
  for (const std::string& line : settle_lengths(dataset)) warn(of + line);
  for (const std::string& line : std::exchange(dataset.notes, {})) note(of + line);
}

void Tool::require_memory(double bytes, const std::string& option, const std::string& what,
                          const std::string& instead) const {
  if (!(bytes > static_cast<double>(memory_bound().bytes))) return;
  const auto megabytes = [](double size) {
    return std::to_string(std::llround(std::ceil(size / 1e6))) + "MB";
  };
  throw UsageError(option, what + " needs some " + megabytes(bytes) + ", more than the " +
                               megabytes(static_cast<double>(memory_bound().bytes)) +
                               " that --memory allows" + instead);
}

void Tool::writes(const std::string& option, const std::string& name) {
  Identity own = identity_of_output(place_of(name));
  if (own.empty() && name == "-") own = name;
  const auto [other, alone] = outputs_.try_emplace(own, Output{option, name});
  if (!alone && !own.empty())
    refuse(option, name, "is the file of --" + other->second.option + " too: give it another name");
  require_writable(name);
}

void Tool::reads(const std::string& name, bool passed_on) const {
  reading_ = name;
  in_order([name] { reading_ = name; });
  const Identity own = identity_of_input(name);
  const auto same = outputs_.find(own);
  if (own.empty() || same == outputs_.end()) return;
  const auto& [option, output] = same->second;
  const bool replaced = place_of(output).kind == Place::Kind::file;
  if (passed_on && replaced && option == "output") return;
  refuse(option, output, "is an input of this run: give the output another name");
}

void Tool::write(Dataset& dataset) { write(dataset, output_); }

void Tool::write(Dataset& dataset, const std::string& name, const std::vector<std::string>& lines) const {
  if (!speaks()) return;
  refuse_terminal(name);
  if (!writes_any_) check_dataset_name(name);
  sign(dataset, lines);
  const bool replaces = place_of(name).kind == Place::Kind::file;
  if (works_alone() && !replaces)  // what is written into a pipe is seen at once
    return in_order([name, dataset] { put(dataset, name); });
  put(dataset, name);
  write_report(dataset);
}

void Tool::sign(Dataset& dataset, const std::vector<std::string>& lines) const {
  dataset.attributes.set("Conventions", "CF-1.8");
  dataset.attributes.set("source", source());
  if (no_history_) return;
  std::string entry = timestamp() + ": " + command_line_;
  for (const std::string& line : lines) entry += "\n  " + line;
  add_history(dataset, entry);
}

void Tool::write_report(const Dataset& dataset) const {
  if (!report_.empty()) write_all(report_, report_of(dataset, name_.substr(name_.find('-') + 1) + "_"));
}

void Tool::write_text(const std::string& text) const {
  if (!speaks()) return;
  if (output_is_terminal())
    Progress::clear();
  else
    Progress::wipe();
  write_all(output_, text);
}

}  // namespace asperity::cli
