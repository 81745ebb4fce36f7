// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Numbers as text, independent of the locale and correctly rounded, so that what is written is
// read back bit for bit.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace thicken::io {

/// The number that all of `word` spells: "1", "+1.5", "-1e5", "nan", "inf". What is too large for
/// the type is infinite, what is too small is 0, as IEEE 754 rounds it. nullopt: not a number.
[[nodiscard]] std::optional<double> toDouble(std::string_view word);
[[nodiscard]] std::optional<float> toFloat(std::string_view word);

/// The whole number that all of `word` spells. nullopt: none, or none of 64 bits.
[[nodiscard]] std::optional<std::int64_t> toInteger(std::string_view word);

/// Appends the shortest text that is read back as `value`.
void appendNumber(std::string& text, double value);
void appendNumber(std::string& text, std::uint32_t value);

}  // namespace thicken::io
