# SPDX-License-Identifier: LGPL-2.1-or-later
#
# What the library links. Found at the top, so that every folder sees the targets.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json 3.10 REQUIRED)
if(THICKEN_SELF_CONTAINED)
  set(ZLIB_USE_STATIC_LIBS ON)
  include(ThickenLibZipSource)
  if(MINGW)
    add_link_options(-static)
  elseif(NOT MSVC AND NOT APPLE)
    # Hidden, what is linked in is not mixed up with the same library in the process, and need not be compiled for that.
    add_link_options(-static-libstdc++ -static-libgcc "LINKER:--exclude-libs,ALL")
  endif()
else()
  find_package(LibZip REQUIRED)
endif()
find_package(Threads REQUIRED)
