// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/ply_header.h"

#include <algorithm>
#include <array>
#include <unordered_set>

#include "io/number_text.h"
#include "io/text_scanner.h"

namespace thicken::io {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};
constexpr std::array kTypeNames{
    TypeName{"char", PlyType::kInt8},     TypeName{"int8", PlyType::kInt8},
    TypeName{"uchar", PlyType::kUint8},   TypeName{"uint8", PlyType::kUint8},
    TypeName{"short", PlyType::kInt16},   TypeName{"int16", PlyType::kInt16},
    TypeName{"ushort", PlyType::kUint16}, TypeName{"uint16", PlyType::kUint16},
    TypeName{"int", PlyType::kInt32},     TypeName{"int32", PlyType::kInt32},
    TypeName{"uint", PlyType::kUint32},   TypeName{"uint32", PlyType::kUint32},
    TypeName{"int64", PlyType::kInt64},   TypeName{"uint64", PlyType::kUint64},
    TypeName{"float", PlyType::kFloat},   TypeName{"float32", PlyType::kFloat},
    TypeName{"double", PlyType::kDouble}, TypeName{"float64", PlyType::kDouble},
};

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::vector<std::string_view> wordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t begin = line.find_first_not_of(" \t\r", at);
    if (begin == std::string_view::npos) break;
    at = std::min(line.find_first_of(" \t\r", begin), line.size());
    words.push_back(line.substr(begin, at - begin));
  }
  return words;
}

class HeaderReader {
 public:
  explicit HeaderReader(const SourceFile& file) : file_(file), bytes_(file.bytes()) {
    if (bytes_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
    // Which byte ends the lines follows from the first line. It must not be guessed at the last one:
    // what stands there as a line feed may be the first byte of the data.
    const std::size_t end = bytes_.find_first_of("\r\n", at_);
    if (end != std::string_view::npos && bytes_[end] == '\r' && bytes_.substr(end + 1, 1) != "\n")
      lineEnd_ = '\r';
  }

  PlyHeader read() {
    const std::vector<std::string_view> first = nextLine();
    if (first.size() != 1 || first[0] != "ply") fail("does not begin with \"ply\"; this is no PLY file");
    for (;;) {
      const std::vector<std::string_view> words = nextLine();
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") break;
      readStatement(words);
    }
    if (!encodingSeen_) fail("the header has no \"format\"");
    header_.dataOffset = at_;
    header_.dataLine = line_ + 1;
    return std::move(header_);
  }

 private:
  std::vector<std::string_view> nextLine() {
    ++line_;
    const std::size_t end = bytes_.find(lineEnd_, at_);
    // A header that ends with the file, without data, may lack its last line end.
    const std::string_view line = bytes_.substr(at_, end == std::string_view::npos ? end : end - at_);
    if (at_ >= bytes_.size()) fail("the file ends before \"end_header\"; it is cut off or no PLY file");
    at_ = end == std::string_view::npos ? bytes_.size() : end + 1;
    return wordsOf(line);
  }

  void readStatement(const std::vector<std::string_view>& words) {
    if (words[0] == "format" && words.size() == 3) {
      readFormat(words[1], words[2]);
    } else if (words[0] == "element" && words.size() == 3) {
      readElement(words[1], words[2]);
    } else if (words[0] == "property" && words.size() == 3) {
      addProperty({std::string(words[2]), typeOf(words[1]), {}});
    } else if (words[0] == "property" && words.size() == 5 && words[1] == "list") {
      addProperty({std::string(words[4]), typeOf(words[3]), typeOf(words[2])});
    } else {
      fail("the statement of " + quotedWord(words[0]) + " is not what a PLY header holds");
    }
  }

  void readFormat(std::string_view encoding, std::string_view version) {
    if (encoding == "ascii") {
      header_.encoding = PlyEncoding::kAscii;
    } else if (encoding == "binary_little_endian") {
      header_.encoding = PlyEncoding::kLittleEndian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = PlyEncoding::kBigEndian;
    } else {
      fail("the format " + quotedWord(encoding) + " is unknown");
    }
    if (version != "1.0") fail("version " + quotedWord(version) + " of the format is unknown");
    encodingSeen_ = true;
  }

  void readElement(std::string_view name, std::string_view number) {
    const auto count = toInteger(number);
    if (!count || *count < 0)
      fail("the number of elements " + quotedWord(name) + " is " + quotedWord(number));
    if (!names_.emplace(name).second) fail("there is a second element " + quotedWord(name));
    header_.elements.push_back({std::string(name), static_cast<std::size_t>(*count), {}});
  }

  void addProperty(PlyProperty property) {
    if (header_.elements.empty()) fail("a property comes before the first element");
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType typeOf(std::string_view name) const {
    const auto* found = std::ranges::find(kTypeNames, name, &TypeName::name);
    if (found == kTypeNames.end()) fail("the type " + quotedWord(name) + " is unknown");
    return found->type;
  }

  [[noreturn]] void fail(const std::string& reason) const { file_.failAtLine(line_, reason); }

  const SourceFile& file_;
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
  char lineEnd_ = '\n';
  bool encodingSeen_ = false;
  PlyHeader header_;
  std::unordered_set<std::string> names_;  // of the elements; a header may name a million
};

}  // namespace

std::size_t sizeOf(PlyType type) noexcept {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat:
      return 4;
    case PlyType::kInt64:
    case PlyType::kUint64:
    case PlyType::kDouble:
      break;
  }
  return 8;
}

PlyHeader readPlyHeader(const SourceFile& file) {
  return HeaderReader(file).read();
}

}  // namespace thicken::io
