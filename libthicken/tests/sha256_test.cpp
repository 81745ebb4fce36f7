// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/sha256.h"

#include <gtest/gtest.h>

#include <string>

namespace thicken::io {
namespace {

std::string digest(std::string_view bytes) {
  Sha256 sum;
  sum.add(bytes);
  return sum.digits();
}

// The examples of FIPS 180-4, and a million times the letter a.
TEST(Sha256, GivesTheDigestsOfTheStandard) {
  EXPECT_EQ(digest(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(digest("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(digest(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnHowTheBytesAreCut) {
  std::string bytes;
  for (int i = 0; i < 300; ++i) bytes.push_back(static_cast<char>(i));
  for (std::size_t length = 0; length <= bytes.size(); ++length) {
    const std::string_view text = std::string_view(bytes).substr(0, length);
    Sha256 pieces;
    for (std::size_t at = 0, piece = 1; at < length; at += piece, piece = piece % 70 + 3)
      pieces.add(text.substr(at, piece));
    EXPECT_EQ(pieces.digits(), digest(text)) << length;
  }
}

TEST(Sha256, OfNoRegularFileIsNothing) {
  EXPECT_FALSE(sha256Of("/nowhere/at/all"));
  EXPECT_FALSE(sha256Of("/"));
}

}  // namespace
}  // namespace thicken::io
