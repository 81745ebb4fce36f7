// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The platform on Linux, macOS and other systems with POSIX.
#if !defined(_WIN32)

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <climits>
#include <cstdlib>  // says which C library it is

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "platform/files.h"
#include "platform/memory.h"
#include "platform/process.h"

namespace thicken::platform {

std::FILE* openFile(const std::filesystem::path& path) noexcept {
  return std::fopen(path.c_str(), "rb");
}

std::FILE* createFile(const std::filesystem::path& path) noexcept {
  return std::fopen(path.c_str(), "wbx");  // x: fails when there is such a file
}

bool replaceFile(const std::filesystem::path& from, const std::filesystem::path& to) noexcept {
  return std::rename(from.c_str(), to.c_str()) == 0;
}

void removeFile(const PathChar* path) noexcept {
  ::unlink(path);
}

bool mayWrite(const std::filesystem::path& file) noexcept {
  return ::access(file.c_str(), W_OK) == 0;
}

bool mayWriteInto(const std::filesystem::path& folder) noexcept {
  return ::access(folder.c_str(), W_OK | X_OK) == 0;
}

std::vector<std::string> commandLine(int argc, const char* const* argv) {
  return {argv, argv + argc};
}

long processId() noexcept {
  return ::getpid();
}

bool stderrIsTerminal() noexcept {
  return ::isatty(STDERR_FILENO) != 0;
}

void writeToStderr(std::string_view text) noexcept {
  const auto written = ::write(STDERR_FILENO, text.data(), text.size());
  static_cast<void>(written);  // there is nobody else to tell
}

void endProcess(int status) noexcept {
  ::_exit(status);
}

std::size_t peakMemory() noexcept {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#if defined(__APPLE__)
  constexpr std::size_t kUnit = 1;
#else
  constexpr std::size_t kUnit = 1024;
#endif
  return static_cast<std::size_t>(usage.ru_maxrss) * kUnit;
}

std::size_t machineMemory() noexcept {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long size = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || size <= 0) return 0;
  return static_cast<std::size_t>(pages) * static_cast<std::size_t>(size);
}

void returnFreedMemory() noexcept {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

void keepFreedMemory() noexcept {
#if defined(__GLIBC__)
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that there is
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
#endif
}

void returnFreedArrays(std::size_t limit) noexcept {
#if defined(__GLIBC__)
  // Bytes; left alone, the C library raises it to that of what was freed. A hundred arrays that are free and
  // kept are a tenth of the limit then.
  constexpr std::size_t kLeast = std::size_t{1} << 18, kMost = std::size_t{32} << 20, kShare = 1000;
  const int large = static_cast<int>(std::clamp(limit / kShare, kLeast, kMost));
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TRIM_THRESHOLD, large);
#else
  static_cast<void>(limit);
#endif
}

}  // namespace thicken::platform

#endif
