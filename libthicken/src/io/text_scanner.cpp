// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/text_scanner.h"

#include <array>

#include "io/number_text.h"

namespace thicken::io {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool isLineEnd(char c) {
  return c == '\n' || c == '\r';
}

}  // namespace

std::string quotedWord(std::string_view word) {
  constexpr std::size_t kMost = 40;
  constexpr std::array<char, 17> kHex{"0123456789ABCDEF"};
  std::string result = "\"";
  for (const char c : word.substr(0, kMost)) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x20 && code < 0x7F) {
      result += c;
    } else {
      result += {'\\', 'x', kHex[code >> 4], kHex[code & 15]};
    }
  }
  if (word.size() > kMost) result += "…";
  return result + '"';
}

TextScanner::TextScanner(const SourceFile& file, Syntax syntax, std::size_t offset, std::size_t line)
    : file_(file),
      syntax_(syntax),
      at_(file.bytes().data() + offset),
      end_(file.bytes().data() + file.bytes().size()),
      line_(line),
      wordLine_(line) {
  if (offset == 0 && file.bytes().starts_with(kByteOrderMark)) at_ += kByteOrderMark.size();
}

bool TextScanner::passLineEnd() {
  if (at_ == end_ || !isLineEnd(*at_)) return false;
  if (*at_ == '\r' && end_ - at_ > 1 && at_[1] == '\n') ++at_;
  ++at_;
  ++line_;
  return true;
}

void TextScanner::skipBlanks() {
  while (at_ != end_) {
    if (isBlank(*at_)) {
      ++at_;
    } else if (syntax_.comment != 0 && *at_ == syntax_.comment) {
      while (at_ != end_ && !isLineEnd(*at_)) ++at_;
    } else if (syntax_.joinsAtBackslash && *at_ == '\\' && end_ - at_ > 1 && isLineEnd(at_[1])) {
      ++at_;
      passLineEnd();
    } else {
      return;
    }
  }
}

std::string_view TextScanner::wordInLine() {
  skipBlanks();
  wordLine_ = line_;
  const char* const begin = at_;
  while (at_ != end_ && !isBlank(*at_) && !isLineEnd(*at_)) {
    if (syntax_.comment != 0 && *at_ == syntax_.comment) break;
    if (syntax_.joinsAtBackslash && *at_ == '\\' && end_ - at_ > 1 && isLineEnd(at_[1])) break;
    ++at_;
  }
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

std::string_view TextScanner::word() {
  do {
    skipBlanks();
  } while (passLineEnd());
  return wordInLine();
}

void TextScanner::skipLine() {
  while (at_ != end_ && !isLineEnd(*at_)) {
    skipBlanks();
    if (at_ != end_ && !isLineEnd(*at_)) ++at_;
  }
  passLineEnd();
}

bool TextScanner::atEnd() {
  do {
    skipBlanks();
  } while (passLineEnd());
  return at_ == end_;
}

double TextScanner::number(std::string_view what) {
  const std::string_view text = word();
  const auto value = toDouble(text);
  if (!value) failNoNumber(text, what);
  return *value;
}

double TextScanner::numberInLine(std::string_view what) {
  const std::string_view text = wordInLine();
  const auto value = toDouble(text);
  if (!value) failNoNumber(text, what);
  return *value;
}

float TextScanner::single(std::string_view what) {
  const std::string_view text = word();
  const auto value = toFloat(text);
  if (!value) failNoNumber(text, what);
  return *value;
}

std::size_t TextScanner::count(std::string_view what, std::size_t most) {
  const std::string_view text = word();
  const auto value = toInteger(text);
  if (!value) failNoNumber(text, what);
  if (*value < 0) fail(std::string(what) + " is negative (" + quotedWord(text) + ")");
  if (static_cast<std::uint64_t>(*value) > most) {
    fail(std::string(what) + " is " + std::string(text) + ", which the rest of the file (" +
         std::to_string(bytesLeft()) + " bytes) cannot hold");
  }
  return static_cast<std::size_t>(*value);
}

void TextScanner::fail(const std::string& reason) const {
  file_.failAtLine(wordLine_, reason);
}

void TextScanner::failNoNumber(std::string_view word, std::string_view what) const {
  if (word.empty())
    fail("the " + std::string(at_ == end_ ? "file" : "line") + " ends before " + std::string(what));
  fail(std::string(what) + " is " + quotedWord(word) + ", which is not a number");
}

}  // namespace thicken::io
