// libFuzzer on one reader: fuzz_reader --format=NAME [LIBFUZZER-OPTION...] [FOLDER...]
#include <cstdlib>
#include <cstring>
#include <iostream>

#include "fuzz/reader.hpp"

namespace {

constexpr std::string_view option = "--format=";
std::string format;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  for (int i = 1; i < *argc; ++i)
    if (const std::string_view word = (*argv)[i]; word.starts_with(option))
      format = word.substr(option.size());
  if (!format.empty()) return 0;
  std::cerr << "fuzz_reader: " << option << "NAME is missing\n";
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  asperity::test::reads(format, {reinterpret_cast<const char*>(data), size});
  return 0;
}
