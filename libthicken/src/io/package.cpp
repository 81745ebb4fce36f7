// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/package.h"

#include <zip.h>

namespace thicken::io {
namespace {

struct DiscardArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseFile {
  void operator()(zip_file_t* part) const { zip_fclose(part); }
};

}  // namespace

struct PackageReader::Impl {
  std::unique_ptr<zip_t, DiscardArchive> archive;
  std::unique_ptr<zip_file_t, CloseFile> part;
  std::string name;
  std::string block = std::string(std::size_t{1} << 16, '\0');
};

PackageReader::PackageReader(const SourceFile& file) : file_(file), impl_(std::make_unique<Impl>()) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(file.bytes().data(), file.bytes().size(), 0, &error);
  if (source == nullptr) throw std::bad_alloc();
  impl_->archive.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
  if (impl_->archive) return;
  const std::string reason = zip_error_strerror(&error);
  zip_error_fini(&error);
  zip_source_free(source);
  file.fail("is a damaged zip archive (" + reason + "); it may be cut short");
}

PackageReader::~PackageReader() = default;

bool PackageReader::has(const std::string& name) const {
  return zip_name_locate(impl_->archive.get(), name.c_str(), ZIP_FL_NOCASE) >= 0;
}

void PackageReader::open(const std::string& name) {
  const zip_int64_t index = zip_name_locate(impl_->archive.get(), name.c_str(), ZIP_FL_NOCASE);
  impl_->name = name;
  impl_->part.reset(index < 0 ? nullptr
                              : zip_fopen_index(impl_->archive.get(), static_cast<zip_uint64_t>(index), 0));
  if (!impl_->part)
    file_.fail("the part \"" + name +
               "\" of the package cannot be read: " + zip_strerror(impl_->archive.get()));
}

std::string_view PackageReader::next() {
  const zip_int64_t read = zip_fread(impl_->part.get(), impl_->block.data(), impl_->block.size());
  if (read < 0)
    file_.fail("the part \"" + impl_->name +
               "\" of the package is damaged: " + zip_file_strerror(impl_->part.get()));
  return std::string_view(impl_->block).substr(0, static_cast<std::size_t>(read));
}

}  // namespace thicken::io
