// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Words and numbers of a text file, with the line that they are on.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/source_file.h"
#include "thicken/mesh.h"

namespace thicken::io {

/// A word of the file as it stands in sentences: quoted, shortened, without control characters.
[[nodiscard]] std::string quotedWord(std::string_view word);

/// Lines end with LF, CR LF or CR. A byte order mark at the beginning is skipped.
class TextScanner {
 public:
  struct Syntax {
    char comment = 0;               ///< starts a comment that reaches to the end of the line; 0: none
    bool joinsAtBackslash = false;  ///< a backslash at the end of a line continues it
  };

  /// Scans the bytes of `file` from `offset`, which is on the line `line`. `file` must stay alive.
  TextScanner(const SourceFile& file, Syntax syntax, std::size_t offset = 0, std::size_t line = 1);

  /// The next word, on whatever line; empty at the end of the file.
  std::string_view word();
  /// The next word on this line; empty at the end of the line, which is not passed.
  std::string_view wordInLine();
  /// Passes the rest of the line and its end.
  void skipLine();
  [[nodiscard]] bool atEnd();

  /// The next word, which has to be a number; `what` it is for ("the x coordinate") stands in the error.
  double number(std::string_view what);
  double numberInLine(std::string_view what);
  float single(std::string_view what);
  /// The next word, which has to be a whole number from `least` to `most`.
  std::size_t count(std::string_view what, std::size_t most);

  /// Line of the word returned last.
  [[nodiscard]] std::size_t line() const { return wordLine_; }
  [[nodiscard]] std::size_t bytesLeft() const { return static_cast<std::size_t>(end_ - at_); }

  /// Throws Error(kUnreadable) at the line of the word returned last.
  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] void failNoNumber(std::string_view word, std::string_view what) const;

 private:
  void skipBlanks();  // within the line, its comment too
  bool passLineEnd();

  const SourceFile& file_;
  Syntax syntax_;
  const char* at_;
  const char* end_;
  std::size_t line_;
  std::size_t wordLine_;
};

}  // namespace thicken::io
