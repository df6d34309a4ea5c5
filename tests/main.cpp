// A run that matches no test is a failure: CMake would otherwise let a name that it mangled pass for ever.
#if __has_include(<catch2/catch_session.hpp>)
#include <catch2/catch_session.hpp>
constexpr auto must_match = Catch::WarnAbout::UnmatchedTestSpec;
#else
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
constexpr auto must_match = Catch::WarnAbout::NoTests;
#endif

int main(int argc, char** argv) {
  Catch::Session session;
  if (const int error = session.applyCommandLine(argc, argv)) return error;
  auto& warnings = session.configData().warnings;
  warnings = static_cast<Catch::WarnAbout::What>(warnings | must_match);
  return session.run();
}
