// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The elements of an XML part of a package, one after the other, with their namespaces resolved.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "io/package.h"

namespace thicken::io {

/// The attributes of an element; "namespace|name" for those that have one.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char* const* pairs) : pairs_(pairs) {}
  /// nullptr: there is none.
  [[nodiscard]] const char* find(std::string_view name) const;

 private:
  const char* const* pairs_;  // names and values, a null pointer after the last
};

/// What is done with the elements. Functions may throw.
class XmlHandler {
 public:
  virtual ~XmlHandler() = default;
  /// `name`: "namespace|name".
  virtual void begin(std::string_view name, const XmlAttributes& attributes) = 0;
  virtual void end(std::string_view /*name*/) {}
};

class XmlPart {
 public:
  XmlPart(const SourceFile& file, std::string name) : file_(file), name_(std::move(name)) {}

  /// Reads the part from beginning to end. Throws what the handler throws, and Error(kUnreadable).
  void read(PackageReader& package, XmlHandler& handler);

  /// The namespace that a prefix stands for in the elements that are open; empty: none.
  [[nodiscard]] std::string namespaceOf(const std::string& prefix) const;

  /// Throws Error(kUnreadable): the file, the part, the line that is being read, `reason`.
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  friend struct XmlCallbacks;
  const SourceFile& file_;
  std::string name_;
  std::size_t line_ = 0;
  std::map<std::string, std::string> prefixes_;
};

}  // namespace thicken::io
