# SPDX-License-Identifier: LGPL-2.1-or-later
#
# How another project's source becomes a static library of this build, linked into what is to run elsewhere.
include(FetchContent)

# Fetches what FetchContent_Declare() named and adds it, or the `folder` of it that has its CMakeLists.txt. Nothing of it is
# installed. A macro, so that options that a function sets before it hold for the source, and for nothing else.
macro(thicken_add_static name folder)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
  set(CMAKE_C_VISIBILITY_PRESET hidden)
  set(CMAKE_POLICY_DEFAULT_CMP0063 NEW)  # a static library has hidden symbols, too
  set(CMAKE_POLICY_DEFAULT_CMP0077 NEW)  # what is set here counts before the options that it declares
  set(CMAKE_POLICY_VERSION_MINIMUM 3.5)
  FetchContent_Populate(${name})
  add_subdirectory("${${name}_SOURCE_DIR}/${folder}" "${${name}_BINARY_DIR}" EXCLUDE_FROM_ALL)
endmacro()
