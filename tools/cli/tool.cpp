#include "cli/tool.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <memory>
#include <random>
#include <system_error>

#include <gsl/gsl_version.h>
#include <nlohmann/json.hpp>

#include "acf/newton_krylov.hpp"
#include "cli/stream.hpp"
#include "cli/table.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "grid/parallel.hpp"
#include "transform/plan.hpp"

namespace asperity::cli {
namespace {

constexpr const char* common = "Common";

std::string libraries() {
  return sundials_version() + ", GSL " GSL_VERSION ", " + transform_version() + ", " + netcdf_version();
}

std::string source() { return "Asperity " ASPERITY_VERSION " (" + libraries() + ")"; }

// An argument as a shell would need it.
std::string quoted(const std::string& argument) {
  const bool plain = !argument.empty() && argument.find_first_not_of(
                                              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                              "0123456789-_=+./,:@%") == std::string::npos;
  if (plain) return argument;
  std::string out = "'";
  for (char c : argument) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

// The time of the run, or the one that a reproducible build asks for.
std::string timestamp() {
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t now =
      epoch ? static_cast<std::time_t>(std::strtoll(epoch, nullptr, 10)) : std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32] = {};
  return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

std::string environment_name(const std::string& option) {
  std::string out = "ASPERITY_";
  for (char c : option)
    out += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

// Whether the arguments name the option, as "--size 3mm", "--size=3mm", "-o x" or "-ox".
bool names(const std::vector<std::string>& arguments, const CLI::Option& option) {
  return std::ranges::any_of(arguments, [&](const std::string& a) {
    auto is_long = [&](const std::string& n) { return a == "--" + n || a.starts_with("--" + n + "="); };
    auto is_short = [&](const std::string& n) { return a.starts_with("-" + n); };
    return std::ranges::any_of(option.get_lnames(), is_long) ||
           std::ranges::any_of(option.get_snames(), is_short);
  });
}

using Json = nlohmann::ordered_json;

// One number or a list, whole numbers as such; JSON has no word for what is not finite.
Json json_of(const Values& values) {
  if (const auto* text = std::get_if<std::string>(&values)) return *text;
  return std::visit(
      [](const auto& list) {
        Json out = Json::array();
        for (auto v : list) out.push_back(std::isfinite(static_cast<double>(v)) ? Json(v) : Json(nullptr));
        return out.size() == 1 ? out[0] : out;
      },
      values);
}

// CLI11 would also print which options exclude or need each other; the texts say it better.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    std::string out;
    if (option->get_type_size() != 0 && !option->get_type_name().empty())
      out += " " + option->get_type_name();
    if (!option->get_default_str().empty()) out += "=" + option->get_default_str();
    return out + (option->get_required() ? " (required)" : "");
  }
};

std::string without_hyphens(const std::string& name) { return name.substr(name.find_first_not_of('-')); }

}  // namespace

Tool::Tool(std::string name, std::string description)
    : app_(std::move(description), name), name_(std::move(name)) {
  auto formatter = std::make_shared<HelpFormatter>();
  formatter->column_width(34);
  app_.formatter(formatter);
  app_.set_help_flag();
  app_.allow_config_extras(CLI::config_extras_mode::error);
}

// ---- options ----

CLI::Option* Tool::flag(const std::string& name, bool& value, const std::string& text,
                        const std::string& group) {
  return app_.add_flag(name, value, text)->group(group);
}

CLI::Option* Tool::parsed(const std::string& name, const std::string& kind, const std::string& text,
                          const std::string& group, const std::string& shown,
                          std::function<void(const std::string&)> parse) {
  CLI::Option* option = app_.add_option_function<std::string>(name, std::move(parse), text);
  option->group(group)->type_name(kind);
  if (!shown.empty()) option->default_str(shown);
  return option;
}

CLI::Option* Tool::integer(const std::string& name, int& value, int least, const std::string& text,
                           const std::string& group) {
  const std::string key = without_hyphens(name);
  return parsed(
      name, "N", text, group, std::to_string(value), [key, least, &value](const std::string& given) {
        const auto [rest, error] = std::from_chars(given.data(), given.data() + given.size(), value);
        if (error != std::errc() || rest != given.data() + given.size())
          throw ParameterError(key, "'" + given + "' is no whole number");
        if (value < least) throw ParameterError(key, given + " is below " + std::to_string(least));
      });
}

CLI::Option* Tool::number(const std::string& name, double& value, const std::string& text,
                          const std::string& group) {
  const std::string key = without_hyphens(name);
  return parsed(name, "NUMBER", text, group, std::isnan(value) ? "" : shortest(value),
                [key, &value](const std::string& given) {
                  if (given.find(',') != given.npos)
                    throw ParameterError(key, "'" + given + "' is more than one number");
                  value = parse_numbers(key, given)[0];
                });
}

CLI::Option* Tool::numbers_pair(const std::string& name, std::array<double, 2>& values,
                                const std::string& text, const std::string& group) {
  const std::string key = without_hyphens(name);
  const bool known = !std::isnan(values[0]);
  return parsed(name, "A[,B]", text, group, known ? shortest(values[0]) + "," + shortest(values[1]) : "",
                [key, &values](const std::string& given) { values = parse_numbers(key, given); });
}

CLI::Option* Tool::text(const std::string& name, std::string& value, const std::string& what,
                        const std::string& text, const std::string& group) {
  return parsed(name, what, text, group, value, [&value](const std::string& given) { value = given; });
}

CLI::Option* Tool::choice(const std::string& name, std::string& value, const std::vector<std::string>& among,
                          const std::string& text, const std::string& group) {
  const std::string key = without_hyphens(name);
  std::string list;
  for (const std::string& word : among) list += (list.empty() ? "" : "|") + word;
  return parsed(name, list, text, group, value, [key, list, among, &value](const std::string& given) {
    if (std::ranges::find(among, given) == among.end())
      throw ParameterError(key, "'" + given + "' is none of " + list);
    value = given;
  });
}

CLI::Option* Tool::quantity(const std::string& name, double& value, const std::string& unit,
                            const std::string& text, const std::string& group) {
  const std::string key = without_hyphens(name);
  return parsed(name, "QUANTITY", text, group, std::isnan(value) ? "" : format_quantity(value, unit),
                [key, unit, &value](const std::string& given) { value = parse_quantity(key, given, unit); });
}

CLI::Option* Tool::quantities(const std::string& name, std::array<double, 2>& values, const std::string& unit,
                              const std::string& text, const std::string& group) {
  const std::string key = without_hyphens(name);
  const bool known = !std::isnan(values[0]);
  return parsed(
      name, "A[,B]", text, group,
      known ? format_quantity(values[0], unit) + "," + format_quantity(values[1], unit) : "",
      [key, unit, &values](const std::string& given) { values = parse_quantities(key, given, unit); });
}

CLI::Option* Tool::lengths(const std::string& name, std::array<SampledLength, 2>& values,
                           const std::string& text, const std::string& group) {
  const std::string key = without_hyphens(name);
  return parsed(name, "A[,B]", text, group, "",
                [key, &values](const std::string& given) { values = parse_lengths(key, given); });
}

CLI::Option* Tool::counts(const std::string& name, Shape& value, Index least, const std::string& text,
                          const std::string& group) {
  const std::string key = without_hyphens(name);
  const std::string shown = value.nx > 0 ? std::to_string(value.nx) + "x" + std::to_string(value.ny) : "";
  return parsed(name, "AxB", text, group, shown,
                [key, least, &value](const std::string& given) { value = parse_counts(key, given, least); });
}

void Tool::input() {
  takes_input_ = true;
  app_.add_option("INPUT", input_, "Dataset to read; - is standard input")
      ->type_name("FILE")
      ->capture_default_str();
}

// The options that all or several tools have stand last in --help, in one order.
void Tool::add_common() {
  if (writes_dataset_ || writes_table_)
    text("-o,--output", output_, "FILE", "Where the result goes; - is standard output", common);
  if (writes_table_) flag("--json", json_, "Print one JSON object instead of a table", common);
  if (reports_) text("--report", report_, "FILE.json", "Write what was achieved as one JSON object", common);
  if (seeded_) add_seed();
  if (threaded_) integer("--threads", threads_, 0, "Threads to use; 0 is all that there are", common);
  if (writes_dataset_)
    flag("--no-history", no_history_, "Leave the command out of the dataset's history", common);
  app_.set_config("--config", "", "Read options from a TOML file")->group(common)->type_name("FILE.toml");
  flag("-q,--quiet", quiet_, "Say nothing but warnings and errors", common);
  flag("-v,--verbose", verbose_, "Say more on standard error", common);
  app_.set_version_flag("--version", name_ + " " ASPERITY_VERSION " (" + libraries() + ")",
                        "Print the versions of the tool and its libraries and exit")
      ->group(common);
  app_.set_help_flag("-h,--help", "Print this help and exit")->group(common);
}

void Tool::add_seed() {
  parsed(
      "--seed", "N", "Seed of the random numbers, 0 to 2^53; absent: from entropy. Always recorded", common,
      "", [this](const std::string& given) {
        std::uint64_t value = 0;
        const auto [rest, error] = std::from_chars(given.data(), given.data() + given.size(), value);
        if (error != std::errc() || rest != given.data() + given.size() || value > (std::uint64_t{1} << 53))
          throw ParameterError("seed",
                               "'" + given + "' is no whole number from 0 to 2^53 = 9007199254740992");
        seed_ = value;
      });
}

int Tool::thread_count() const { return resolve_threads(threads_); }

std::uint64_t Tool::seed_value() {
  if (!seed_) {
    std::random_device entropy;
    seed_ = (static_cast<std::uint64_t>(entropy()) << 21) ^ entropy();
  }
  return *seed_;
}

// ---- running ----

std::string Tool::footer() const {
  std::string out = "\n";
  if (!example_.empty()) out += "Example:\n  " + example_ + "\n\n";
  if (!accuracy_.empty()) out += "Accuracy:\n  " + accuracy_ + "\n\n";
  return out +
         "Quantities carry their unit (3mm, 0.4um, 208GPa, 5000N); px counts samples. Any option may also be "
         "given\n"
         "as an environment variable ASPERITY_OPTION or in the --config file; the command line comes first.\n"
         "Exit status: 0 done, 1 input or output failed, 2 wrong usage, 3 not converged, 4 bad input data.";
}

void Tool::add_environment(std::vector<std::string>& arguments) const {
  std::vector<std::string> extra;
  for (const CLI::Option* option : app_.get_options()) {
    if (option->get_lnames().empty() || names(arguments, *option)) continue;
    const std::string& key = option->get_lnames().front();
    if (key == "help" || key == "version" || key == "config") continue;
    if (const char* value = std::getenv(environment_name(key).c_str()))
      extra.push_back("--" + key + "=" + value);
  }
  arguments.insert(arguments.begin(), extra.begin(), extra.end());
}

void Tool::parse(int argc, char** argv) {
  add_common();
  app_.footer(footer());
  std::vector<std::string> arguments(argv + 1, argv + argc);
  command_line_ = name_;
  for (const std::string& a : arguments) command_line_ += " " + quoted(a);
  add_environment(arguments);
  std::ranges::reverse(arguments);
  app_.parse(std::move(arguments));
}

int Tool::fail(Exit code, const std::string& message) const {
  std::string line = name_ + ": " + message;
  std::ranges::replace(line, '\n', ' ');
  std::cerr << line << '\n';
  return code;
}

int Tool::answer(int argc, char** argv, const std::function<int()>& body) try {
  parse(argc, argv);
  if (writes_dataset_ && !writes_table_ && output_is_terminal())
    return fail(usage_error,
                "--output: a dataset is binary and standard output is a terminal; pipe it on or name a file");
  if (takes_input_ && input_ == "-" && stdin_is_terminal())
    return fail(usage_error, "no input: pipe a dataset in or name a file (" + name_ + " --help tells more)");
  return body();
} catch (const CLI::CallForHelp&) {
  write_all("-", app_.help());
  return done;
} catch (const CLI::CallForVersion& version) {
  write_all("-", std::string(version.what()) + "\n");
  return done;
}

int Tool::run(int argc, char** argv, const std::function<int()>& body) try {
  return answer(argc, argv, body);
} catch (const CLI::ConfigError& e) {
  const std::string what = e.what(), prefix = "INI was not able to parse ";
  return fail(
      usage_error,
      "--config: " + (what.starts_with(prefix) ? "there is no option " + what.substr(prefix.size()) : what));
} catch (const CLI::Error& e) {
  return fail(usage_error, e.what());
} catch (const ParameterError& e) {
  return fail(usage_error, "--" + e.name + ": " + e.what());
} catch (const DataError& e) {
  return fail(bad_data, e.name + ": " + e.what());
} catch (const std::bad_alloc&) {
  return fail(runtime_error, "out of memory");
} catch (const std::system_error& e) {
  return fail(runtime_error, e.what());
} catch (const std::exception& e) {
  return fail(runtime_error, e.what());
}

// ---- input and output ----

Dataset Tool::read() const { return read(input_); }

Dataset Tool::read(const std::string& name) { return decode_netcdf(read_all(name)); }

void Tool::write_report(const Dataset& dataset) const {
  const std::string prefix = name_.substr(name_.find('-') + 1) + "_";
  Json object = Json::object();
  for (const Attribute& attribute : dataset.attributes)
    if (attribute.name.starts_with(prefix)) object[attribute.name] = json_of(attribute.values);
  write_all(report_, object.dump(2) + "\n");
}

void Tool::write(Dataset& dataset) { write(dataset, output_); }

void Tool::write(Dataset& dataset, const std::string& name) {
  if (name == "-" && stdout_is_terminal())
    throw UsageError("output", "a dataset is binary and does not go to a terminal");
  dataset.attributes.set("Conventions", "CF-1.8");
  dataset.attributes.set("source", source());
  if (!no_history_) add_history(dataset, timestamp() + ": " + command_line_);
  write_all(name, encode_netcdf(dataset));
  if (!report_.empty()) write_report(dataset);
}

void Tool::write_text(const std::string& text) const { write_all(output_, text); }

bool Tool::output_is_terminal() const { return output_ == "-" && stdout_is_terminal(); }

void Tool::warn(const std::string& text) const { std::cerr << name_ << ": warning: " << text << '\n'; }

void Tool::note(const std::string& text) const {
  if (!quiet_) std::cerr << name_ << ": " << text << '\n';
}

void Tool::detail(const std::string& text) const {
  if (verbose_) std::cerr << text << '\n';
}

}  // namespace asperity::cli
