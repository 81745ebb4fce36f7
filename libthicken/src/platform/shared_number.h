// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <cstdint>

namespace thicken::platform {

#if defined(__cpp_lib_atomic_ref)

/// A number that several threads read and write. It is still an ordinary number of an array.
using SharedNumber = std::atomic_ref<std::uint32_t>;

#else

/// The same for C++ libraries that do not have it yet, such as Clang's before 19.
class SharedNumber {
 public:
  explicit SharedNumber(std::uint32_t& number) : number_(&number) {}

  [[nodiscard]] std::uint32_t load(std::memory_order) const {
    return __atomic_load_n(number_, __ATOMIC_RELAXED);
  }
  void store(std::uint32_t value, std::memory_order) const {
    __atomic_store_n(number_, value, __ATOMIC_RELAXED);
  }
  [[nodiscard]] bool compare_exchange_strong(std::uint32_t& expected, std::uint32_t value,
                                             std::memory_order) const {
    return __atomic_compare_exchange_n(number_, &expected, value, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED);
  }

 private:
  std::uint32_t* number_;
};

#endif

}  // namespace thicken::platform
