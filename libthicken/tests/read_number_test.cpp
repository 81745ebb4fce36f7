// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "io/number_text.h"

namespace thicken::io {
namespace {

TEST(NumberText, ReadsTheSpellingsThatFilesHold) {
  EXPECT_EQ(toDouble("1"), 1);
  EXPECT_EQ(toDouble("+1.0"), 1);
  EXPECT_EQ(toDouble("-.5"), -0.5);
  EXPECT_EQ(toDouble("2."), 2);
  EXPECT_EQ(toDouble("1e5"), 1e5);
  EXPECT_EQ(toDouble("1E+05"), 1e5);
  EXPECT_EQ(toDouble("-0"), 0);
  EXPECT_TRUE(std::signbit(*toDouble("-0")));
  EXPECT_EQ(toInteger("+12"), 12);
  EXPECT_EQ(toInteger("-7"), -7);
}

TEST(NumberText, ReadsWhatIsNotFinite) {
  EXPECT_TRUE(std::isnan(*toDouble("nan")));
  EXPECT_TRUE(std::isnan(*toDouble("-NaN")));
  EXPECT_EQ(toDouble("inf"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(toDouble("-Infinity"), -std::numeric_limits<double>::infinity());
}

TEST(NumberText, RoundsWhatIsOutOfRangeAsIeeeDoes) {
  EXPECT_EQ(toDouble("1e400"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(toDouble("-1e400"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(toDouble("1e-400"), 0);
  EXPECT_EQ(toDouble("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(toFloat("1e39"), std::numeric_limits<float>::infinity());
  EXPECT_EQ(toFloat("1e-50"), 0.0f);
  EXPECT_EQ(toFloat("1e-45"), std::numeric_limits<float>::denorm_min());
  EXPECT_TRUE(std::signbit(*toDouble("-1e-400")));
}

// Also beyond what any type of the machine holds.
TEST(NumberText, RoundsWhatIsFarOutOfRange) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(toDouble("1e5000"), kInfinity);
  EXPECT_EQ(toDouble("-1E+99999999999999999999"), -kInfinity);
  EXPECT_EQ(toDouble("1e-5000"), 0);
  EXPECT_EQ(toDouble("1e-99999999999999999999"), 0);
  EXPECT_EQ(toDouble('1' + std::string(5000, '0')), kInfinity);
  EXPECT_EQ(toDouble("0." + std::string(5000, '0') + '1'), 0);
  EXPECT_EQ(toDouble("0." + std::string(5000, '0') + "1e9999"), kInfinity);
  EXPECT_EQ(toDouble('1' + std::string(5000, '0') + "e-9999"), 0);
}

TEST(NumberText, RefusesWhatIsNoNumber) {
  for (const char* word :
       {"", "+", "-", ".", "e5", "1e", "1.0x", "0x10", "1,5", "zero", "+-1", "++1", "1 "}) {
    EXPECT_FALSE(toDouble(word)) << word;
    EXPECT_FALSE(toInteger(word)) << word;
  }
  EXPECT_FALSE(toInteger("1.5"));
  EXPECT_FALSE(toInteger("99999999999999999999"));
}

TEST(NumberText, DoesNotMindTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    std::setlocale(LC_ALL, locale);  // where it is not installed this changes nothing
    EXPECT_EQ(toDouble("1.5"), 1.5);
    EXPECT_EQ(toDouble("1.5e400"), std::numeric_limits<double>::infinity());
    std::string text;
    appendNumber(text, 0.1);
    EXPECT_EQ(text, "0.1");
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(NumberText, WritesEveryDoubleSoThatItComesBack) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 100000; ++i) {
    const std::uint64_t bits = random();
    double value;
    std::memcpy(&value, &bits, sizeof(value));
    if (!std::isfinite(value)) continue;
    std::string text;
    appendNumber(text, value);
    const auto back = toDouble(text);
    ASSERT_TRUE(back) << text;
    ASSERT_EQ(std::memcmp(&*back, &value, sizeof(value)), 0) << text;
  }
}

}  // namespace
}  // namespace thicken::io
