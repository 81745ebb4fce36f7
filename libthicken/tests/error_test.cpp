// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/error.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <string>

namespace thicken {
namespace {

std::vector<ErrorCode> allCodes() {
  std::vector<ErrorCode> codes;
  for (int i = 0; i <= static_cast<int>(ErrorCode::kInternal); ++i)
    codes.push_back(static_cast<ErrorCode>(i));
  return codes;
}

/// The rows "| `code` | status |" of the documentation.
std::map<std::string, int> documentedCodes() {
  std::ifstream file(std::string(THICKEN_SOURCE_DIR) + "/docs/errors.md");
  EXPECT_TRUE(file) << "docs/errors.md is missing";
  const std::regex row(R"(^\| `([a-z-]+)` \| ([0-9]+) \|.*)");
  std::map<std::string, int> codes;
  std::smatch match;
  for (std::string line; std::getline(file, line);) {
    if (std::regex_match(line, match, row)) codes[match[1]] = std::stoi(match[2]);
  }
  return codes;
}

TEST(ErrorCode, EveryCodeHasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (ErrorCode code : allCodes()) {
    EXPECT_TRUE(names.insert(name(code)).second) << name(code);
    EXPECT_TRUE(std::regex_match(std::string(name(code)), std::regex("[a-z]+(-[a-z]+)*"))) << name(code);
  }
  EXPECT_EQ(names.size(), 16u);
}

TEST(ErrorCode, TheDocumentationListsEveryCodeWithItsExitStatusAndNoOther) {
  const auto documented = documentedCodes();
  EXPECT_EQ(documented.size(), allCodes().size());
  for (ErrorCode code : allCodes()) {
    const auto found = documented.find(std::string(name(code)));
    ASSERT_NE(found, documented.end()) << name(code) << " is not in docs/errors.md";
    EXPECT_EQ(found->second, exitStatus(code)) << name(code);
  }
}

TEST(ErrorCode, DefectsOfASurfaceEndWithStatusThree) {
  for (ErrorCode code :
       {ErrorCode::kEmpty, ErrorCode::kNotFinite, ErrorCode::kNotManifold, ErrorCode::kNotOriented,
        ErrorCode::kDegenerate, ErrorCode::kSelfIntersecting, ErrorCode::kTooLarge})
    EXPECT_EQ(exitStatus(code), 3) << name(code);
}

TEST(Error, CarriesSentenceCodeAndDefects) {
  Defect defect;
  defect.code = ErrorCode::kNotManifold;
  defect.edges = {{12, 57}};
  const Error error(ErrorCode::kNotManifold, "edge 12-57 has three triangles", {defect});
  EXPECT_STREQ(error.what(), "edge 12-57 has three triangles");
  EXPECT_EQ(error.code(), ErrorCode::kNotManifold);
  ASSERT_EQ(error.defects().size(), 1u);
  EXPECT_EQ(error.defects().front().edges.front()[1], 57u);
}

}  // namespace
}  // namespace thicken
