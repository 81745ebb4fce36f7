// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The platform on Windows. Paths are wide there. Its C library gives large arrays back by itself.
#if defined(_WIN32)

#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
// Needs what windows.h declares.
#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <psapi.h>
#include <shellapi.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <utility>

#include "platform/files.h"
#include "platform/memory.h"
#include "platform/process.h"

namespace thicken::platform {
namespace {

constexpr int kStderr = 2;
constexpr int kWrite = 2;  // of _waccess

}  // namespace

std::FILE* openFile(const std::filesystem::path& path) noexcept {
  return _wfopen(path.c_str(), L"rb");
}

std::FILE* createFile(const std::filesystem::path& path) noexcept {
  const int file = _wopen(path.c_str(), _O_CREAT | _O_EXCL | _O_WRONLY | _O_BINARY, _S_IREAD | _S_IWRITE);
  return file < 0 ? nullptr : _fdopen(file, "wb");
}

bool replaceFile(const std::filesystem::path& from, const std::filesystem::path& to) noexcept {
  if (MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != 0)
    return true;
  errno = GetLastError() == ERROR_FILE_NOT_FOUND ? ENOENT : EACCES;
  return false;
}

void removeFile(const PathChar* path) noexcept {
  _wunlink(path);
}

bool mayWrite(const std::filesystem::path& file) noexcept {
  return _waccess(file.c_str(), kWrite) == 0;
}

// Whether a folder takes files is decided by access-control lists, which only an attempt asks.
bool mayWriteInto(const std::filesystem::path& folder) noexcept {
  return _waccess(folder.c_str(), 0) == 0;
}

// The words that main() gets have lost what the system's code page lacks.
std::vector<std::string> commandLine(int argc, const char* const* argv) {
  SetConsoleOutputCP(CP_UTF8);
  wchar_t** const wide = CommandLineToArgvW(GetCommandLineW(), &argc);
  if (wide == nullptr) return {argv, argv + argc};
  std::vector<std::string> words;
  for (int i = 0; i < argc; ++i) {
    const int length = WideCharToMultiByte(CP_UTF8, 0, wide[i], -1, nullptr, 0, nullptr, nullptr);
    std::string word(static_cast<std::size_t>(length), '\0');
    WideCharToMultiByte(CP_UTF8, 0, wide[i], -1, word.data(), length, nullptr, nullptr);
    word.resize(word.empty() ? 0 : word.size() - 1);  // without the 0 at its end
    words.push_back(std::move(word));
  }
  LocalFree(wide);
  return words;
}

long processId() noexcept {
  return _getpid();
}

bool stderrIsTerminal() noexcept {
  return _isatty(kStderr) != 0;
}

void writeToStderr(std::string_view text) noexcept {
  _write(kStderr, text.data(), static_cast<unsigned>(text.size()));
}

void endProcess(int status) noexcept {
  _exit(status);
}

std::size_t peakMemory() noexcept {
  PROCESS_MEMORY_COUNTERS counters{};
  if (K32GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters) == 0) return 0;
  return counters.PeakWorkingSetSize;
}

std::size_t machineMemory() noexcept {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  return GlobalMemoryStatusEx(&status) == 0 ? 0 : static_cast<std::size_t>(status.ullTotalPhys);
}

void returnFreedMemory() noexcept {}
void keepFreedMemory() noexcept {}
void returnFreedArrays(std::size_t) noexcept {}

}  // namespace thicken::platform

#endif
