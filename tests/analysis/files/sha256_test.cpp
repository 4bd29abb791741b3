#include "analysis/files/sha256.h"

#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::sha256_test {
namespace {

std::string DigestOf(std::string_view bytes) {
  Sha256 digest;
  digest.AddBytes(bytes);
  return digest.Hex();
}

template <typename... Parts>
std::string DigestOfParts(const Parts&... parts) {
  Sha256 digest;
  (digest.Add(parts), ...);
  return digest.Hex();
}

// NIST, examples of FIPS 180 and CAVP: one block, two blocks, many.
TEST(Sha256, HasThePublishedDigests) {
  EXPECT_EQ(DigestOf(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(DigestOf("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(DigestOf("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(DigestOf(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, HasTheDigestInBase64AsWell) {
  Sha256 digest;
  digest.AddBytes("alert('Hello, world.');");
  // The example of Mozilla's page on script-src.
  EXPECT_EQ(digest.Base64(), "qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng=");
}

TEST(Sha256, DoesNotDependOnHowTheBytesCome) {
  const std::string text(200, 'x');
  for (const std::size_t first : {1u, 55u, 56u, 63u, 64u, 65u, 128u}) {
    Sha256 digest;
    digest.AddBytes(std::string_view(text).substr(0, first));
    digest.AddBytes(std::string_view(text).substr(first));
    EXPECT_EQ(digest.Hex(), DigestOf(text)) << first;
  }
}

TEST(Sha256, TellsWhereAPartEnds) {
  const std::string_view ab = "ab";
  const std::string_view c = "c";
  EXPECT_NE(DigestOfParts(ab, c), DigestOfParts(std::string_view("a"), std::string_view("bc")));
  EXPECT_NE(DigestOfParts(std::vector<double>{1, 2}, std::vector<double>{}),
            DigestOfParts(std::vector<double>{1}, std::vector<double>{2}));
}

TEST(Sha256, TellsNumbersApartByTheirBits) {
  EXPECT_NE(DigestOfParts(0.0), DigestOfParts(-0.0));
  EXPECT_NE(DigestOfParts(1.0), DigestOfParts(1.0 + std::numeric_limits<double>::epsilon()));
  EXPECT_EQ(DigestOfParts(0.1), DigestOfParts(0.1));
}

TEST(Sha256, CanBeTakenOnce) {
  Sha256 digest;
  digest.Hex();
  EXPECT_THROW(digest.Hex(), std::logic_error);
}

}  // namespace
}  // namespace fourpost::sha256_test
