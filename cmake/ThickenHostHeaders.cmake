# SPDX-License-Identifier: LGPL-2.1-or-later
#
# For a cross-compiler: targets of the libraries that are headers only, of this machine's packages. Their folder, /usr/include,
# also holds this machine's C library, so each library is given alone, in a folder of links.
set(thicken_host_headers "${PROJECT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${thicken_host_headers}")

function(thicken_host_header target folder)
  find_path(THICKEN_${folder} NAMES ${folder} PATHS /usr/include /usr/include/eigen3 NO_DEFAULT_PATH
            NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  mark_as_advanced(THICKEN_${folder})
  file(CREATE_LINK "${THICKEN_${folder}}/${folder}" "${thicken_host_headers}/${folder}" SYMBOLIC)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} INTERFACE "${thicken_host_headers}")
endfunction()

thicken_host_header(Eigen3::Eigen Eigen)
thicken_host_header(nlohmann_json::nlohmann_json nlohmann)
thicken_host_header(CLI11::CLI11 CLI)
thicken_host_header(fmt::fmt-header-only fmt)
target_compile_definitions(fmt::fmt-header-only INTERFACE FMT_HEADER_ONLY=1)
