// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/target_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <system_error>

#include "io/source_file.h"
#include "platform/files.h"
#include "platform/process.h"
#include "thicken/error.h"
#include "thicken/io.h"

namespace thicken::io {
namespace {

namespace fs = std::filesystem;

// The temporary files under way, in a form that a signal handler may read: fixed storage, no locks.
// A write beyond the last slot works as any other; it is just not known to abandonWrites().
struct Slot {
  enum State : int { kFree, kFilling, kUsed };
  std::atomic<int> state{kFree};
  std::array<platform::PathChar, 4096> path{};
};
static_assert(std::atomic<int>::is_always_lock_free);
std::array<Slot, 16> slots;

int takeSlot(const fs::path::string_type& path) {
  if (path.size() >= slots[0].path.size()) return -1;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    int free = Slot::kFree;
    if (!slots[i].state.compare_exchange_strong(free, Slot::kFilling)) continue;
    std::copy_n(path.c_str(), path.size() + 1, slots[i].path.data());
    slots[i].state.store(Slot::kUsed);
    return static_cast<int>(i);
  }
  return -1;
}

std::string reasonOf(int error) {
  return std::generic_category().message(error);
}

}  // namespace

fs::path linkedPlace(const fs::path& path) {
  constexpr int kMostLinks = 40;
  std::error_code ignored;
  fs::path place = fs::absolute(path);
  for (int i = 0; i < kMostLinks; ++i) {
    if (!fs::is_symlink(place, ignored)) return place;
    const fs::path target = fs::read_symlink(place, ignored);
    place = target.is_absolute() ? target : place.parent_path() / target;
  }
  throw Error(ErrorCode::kUnwritable, quoted(path) + ": is a link that leads back to itself.");
}

// A link stays a link: what it points to is replaced.
TargetFile::TargetFile(const fs::path& path) : path_(path), place_(linkedPlace(path)) {
  std::error_code ignored;
  if (fs::is_directory(place_, ignored)) fail("is a folder; name a file in it");
  if (fs::exists(place_, ignored)) {
    if (!fs::is_regular_file(place_, ignored)) fail("is not a regular file");
    // Renaming would replace even a file that is write-protected.
    if (!platform::mayWrite(place_)) fail("cannot be replaced: " + reasonOf(errno));
  }
  openTemporary();
}

void TargetFile::openTemporary() {
  constexpr int kMostTries = 1000;
  for (int i = 0; i < kMostTries && !file_; ++i) {
    temporary_ = place_.parent_path() /
                 (".thicken-" + std::to_string(platform::processId()) + "-" + std::to_string(i) + ".tmp");
    file_ = platform::createFile(temporary_);
    if (!file_ && errno != EEXIST) break;
  }
  if (!file_) fail("cannot be written: " + reasonOf(errno));
  slot_ = takeSlot(temporary_.native());
}

TargetFile::~TargetFile() {
  removeTemporary();
}

void TargetFile::removeTemporary() noexcept {
  if (file_) std::fclose(file_);
  file_ = nullptr;
  if (!temporary_.empty()) platform::removeFile(temporary_.c_str());
  temporary_.clear();
  if (slot_ >= 0) slots[static_cast<std::size_t>(slot_)].state.store(Slot::kFree);
  slot_ = -1;
}

void TargetFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) {
    fail("cannot be written: " + reasonOf(errno));
  }
}

void TargetFile::writeWhenLong(std::string& bytes) {
  constexpr std::size_t kLong = std::size_t{1} << 20;
  if (bytes.size() < kLong) return;
  write(bytes);
  bytes.clear();
}

void TargetFile::commit() {
  std::FILE* const file = file_;
  file_ = nullptr;
  if (std::fclose(file) != 0) fail("cannot be written: " + reasonOf(errno));
  if (!platform::replaceFile(temporary_, place_)) fail("cannot be replaced: " + reasonOf(errno));
  temporary_.clear();
  removeTemporary();
}

void TargetFile::fail(const std::string& reason) const {
  throw Error(ErrorCode::kUnwritable, quoted(path_) + ": " + reason + ".");
}

}  // namespace thicken::io

namespace thicken {

void abandonWrites() noexcept {
  for (io::Slot& slot : io::slots) {
    if (slot.state.load() == io::Slot::kUsed) platform::removeFile(slot.path.data());
  }
}

}  // namespace thicken
