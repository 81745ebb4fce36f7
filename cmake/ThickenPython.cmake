# SPDX-License-Identifier: LGPL-2.1-or-later
#
# The extension has to fit the Python that FreeCAD embeds. On Linux that is the distribution's, while
# `python3` on the PATH may belong to a version manager: so the search starts at /usr/bin.
# -DPython_EXECUTABLE=… chooses another.
if(THICKEN_ADDON_PYTHONS)
  set(PYBIND11_NOPYTHON ON)  # their headers are named, and there need be no interpreter
  find_package(pybind11 2.12 REQUIRED CONFIG)  # the first that knows NumPy 2
  return()
endif()
if(NOT DEFINED Python_EXECUTABLE AND NOT SKBUILD AND EXISTS "/usr/bin/python3")
  set(Python_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "The Python that FreeCAD embeds")
endif()
set(PYBIND11_FINDPYTHON ON)
find_package(Python 3.10 REQUIRED COMPONENTS Interpreter Development.Module)
find_package(pybind11 2.10 REQUIRED CONFIG)
# Said outright, so that pybind11 does not add link-time optimisation of its own: the time is spent in
# the library, which is compiled without it.
set(CMAKE_INTERPROCEDURAL_OPTIMIZATION OFF)
