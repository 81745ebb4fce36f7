// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/xml_elements.h"

#include <expat.h>

#include <exception>
#include <memory>
#include <new>
#include <type_traits>

namespace thicken::io {

const char* XmlAttributes::find(std::string_view name) const {
  for (const char* const* pair = pairs_; *pair != nullptr; pair += 2)
    if (name == pair[0]) return pair[1];
  return nullptr;
}

// Exceptions must not pass through Expat, which is C: they wait until it has stopped.
struct XmlCallbacks {
  XmlPart& part;
  XmlHandler& handler;
  XML_Parser parser;
  std::exception_ptr error = {};

  template <class Call>
  void guarded(Call call) {
    if (error) return;
    try {
      part.line_ = XML_GetCurrentLineNumber(parser);
      call();
    } catch (...) {
      error = std::current_exception();
      XML_StopParser(parser, XML_FALSE);
    }
  }
  static XmlCallbacks& of(void* self) { return *static_cast<XmlCallbacks*>(self); }

  static void begin(void* self, const XML_Char* name, const XML_Char** attributes) {
    of(self).guarded([&] { of(self).handler.begin(name, XmlAttributes(attributes)); });
  }
  static void end(void* self, const XML_Char* name) {
    of(self).guarded([&] { of(self).handler.end(name); });
  }
  static void beginNamespace(void* self, const XML_Char* prefix, const XML_Char* uri) {
    of(self).guarded([&] { of(self).part.prefixes_[prefix ? prefix : ""] = uri ? uri : ""; });
  }
  // Entities, which could make much of little, are declared in it; 3MF has neither.
  static void beginDoctype(void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    of(self).guarded(
        [&] { of(self).part.fail("it has a document type declaration, which 3MF does not allow"); });
  }
};

void XmlPart::read(PackageReader& package, XmlHandler& handler) {
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(
      XML_ParserCreateNS(nullptr, '|'), XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  XmlCallbacks callbacks{*this, handler, parser.get()};
  XML_SetUserData(parser.get(), &callbacks);
  XML_SetElementHandler(parser.get(), XmlCallbacks::begin, XmlCallbacks::end);
  XML_SetStartNamespaceDeclHandler(parser.get(), XmlCallbacks::beginNamespace);
  XML_SetStartDoctypeDeclHandler(parser.get(), XmlCallbacks::beginDoctype);
  package.open(name_);
  for (bool isLast = false; !isLast;) {
    const std::string_view bytes = package.next();
    isLast = bytes.empty();
    const XML_Status status =
        XML_Parse(parser.get(), bytes.data(), static_cast<int>(bytes.size()), isLast ? XML_TRUE : XML_FALSE);
    if (callbacks.error) std::rethrow_exception(callbacks.error);
    line_ = XML_GetCurrentLineNumber(parser.get());
    const XML_Error code = XML_GetErrorCode(parser.get());
    if (status == XML_STATUS_ERROR && code == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
    if (status == XML_STATUS_ERROR) fail(std::string("this is no XML: ") + XML_ErrorString(code));
  }
}

std::string XmlPart::namespaceOf(const std::string& prefix) const {
  const auto found = prefixes_.find(prefix);
  return found == prefixes_.end() ? std::string() : found->second;
}

void XmlPart::fail(const std::string& reason) const {
  file_.fail("in its part \"" + name_ + "\", line " + std::to_string(line_) + ": " + reason);
}

}  // namespace thicken::io
