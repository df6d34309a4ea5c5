#include "tools/report/html.hpp"

#include "support.hpp"

using namespace asperity::report;

// RFC 4648, section 10.
TEST_CASE("base64 is that of RFC 4648", "[html][exact]") {
  const char* pairs[][2] = {{"", ""},
                            {"f", "Zg=="},
                            {"fo", "Zm8="},
                            {"foo", "Zm9v"},
                            {"foob", "Zm9vYg=="},
                            {"fooba", "Zm9vYmE="},
                            {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, expected] : pairs) CHECK(base64(bytes) == expected);
}

TEST_CASE("escaped text holds no markup, and nothing that is not UTF-8", "[html][contract]") {
  CHECK(escaped("<a href=\"x\">&'µ") == "&lt;a href=&quot;x&quot;&gt;&amp;&#39;µ");
  CHECK(escaped(std::string("a\xff\x01z\xc3")) == "a\u00FF\uFFFDz\u00C3");
}
