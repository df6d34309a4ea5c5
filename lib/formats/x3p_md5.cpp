// MD5 after R. Rivest, The MD5 message-digest algorithm, RFC 1321 (1992), section 3. X3P asks for it to find
// damage; no secret depends on it. None of the libraries that the project is linked with has it. OpenSSL
// would be one more, and refuses it where a system admits approved algorithms only.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "formats/x3p_head.hpp"

namespace asperity::x3p {
namespace {

constexpr std::size_t md5_block = 64;  // bytes that are mixed into the state at a time
using Md5State = std::array<std::uint32_t, 4>;

// T of section 3.4.
std::array<std::uint32_t, 64> make_md5_sines() {
  std::array<std::uint32_t, 64> out{};
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = static_cast<std::uint32_t>(std::ldexp(std::abs(std::sin(static_cast<double>(i + 1))), 32));
  return out;
}
const std::array<std::uint32_t, 64> md5_sines = make_md5_sines();

// Little-endian, as the message is in words.
template <std::size_t bytes, class Word>
std::array<char, bytes> md5_bytes(Word word) {
  std::array<char, bytes> out{};
  for (std::size_t b = 0; b < bytes; ++b) out[b] = static_cast<char>(word >> 8 * b);
  return out;
}

// A round: 16 steps that mix a word each, in the order first + stride k.
template <unsigned round, unsigned first, unsigned stride, class Mix>
void md5_round(Md5State& s, const std::array<std::uint32_t, 16>& words, std::array<int, 4> turns,
               const Mix& mix) {
#pragma GCC unroll 16
  for (unsigned k = 0; k < 16; ++k) {
    const std::uint32_t sum =
        s[0] + mix(s[1], s[2], s[3]) + words[(first + stride * k) % 16] + md5_sines[16 * round + k];
    const int turn = turns[k % 4];
    s = {s[3], s[1] + (sum << turn | sum >> (32 - turn)), s[1], s[2]};
  }
}

void md5_mix(Md5State& state, const char* block) {
  std::array<std::uint32_t, 16> words{};
  for (std::size_t b = 0; b < md5_block; ++b)
    words[b / 4] |= std::uint32_t{static_cast<unsigned char>(block[b])} << 8 * (b % 4);
  Md5State s = state;
  md5_round<0, 0, 1>(s, words, {7, 12, 17, 22}, [](auto x, auto y, auto z) { return (x & y) | (~x & z); });
  md5_round<1, 1, 5>(s, words, {5, 9, 14, 20}, [](auto x, auto y, auto z) { return (x & z) | (y & ~z); });
  md5_round<2, 5, 3>(s, words, {4, 11, 16, 23}, [](auto x, auto y, auto z) { return x ^ y ^ z; });
  md5_round<3, 0, 7>(s, words, {6, 10, 15, 21}, [](auto x, auto y, auto z) { return y ^ (x | ~z); });
  for (std::size_t i = 0; i < s.size(); ++i) state[i] += s[i];
}

// Behind the message: a bit, zeros, and its length in bits, which end with a block.
std::string md5_tail(std::string_view rest, std::uint64_t message_bytes) {
  std::string out(rest);
  out += '\x80';
  out.resize((out.size() + 8 + md5_block - 1) / md5_block * md5_block - 8);
  const auto bits = md5_bytes<8>(8 * message_bytes);
  return out.append(bits.data(), bits.size());
}

}  // namespace

std::string md5_of(std::string_view bytes) {
  Md5State state{0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476};
  std::string_view rest = bytes;
  for (; rest.size() >= md5_block; rest.remove_prefix(md5_block)) md5_mix(state, rest.data());
  const std::string tail = md5_tail(rest, bytes.size());
  for (std::size_t at = 0; at < tail.size(); at += md5_block) md5_mix(state, tail.data() + at);
  std::string out;
  for (const std::uint32_t word : state)
    for (const char byte : md5_bytes<4>(word)) {
      constexpr std::string_view digits = "0123456789abcdef";
      out += digits[static_cast<unsigned char>(byte) >> 4];
      out += digits[byte & 15];
    }
  return out;
}

}  // namespace asperity::x3p
