# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Toolchain: programs for 64-bit Windows made on Debian by mingw-w64. THICKEN_HEADERS is a prefix with the libraries that are
# headers only: the system's own would bring the headers of its C library along. scripts/test-windows uses it.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES THICKEN_HEADERS)
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32 "${THICKEN_HEADERS}")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
