# SPDX-License-Identifier: LGPL-2.1-or-later
#
# What the library links. Found at the top, so that every folder sees the targets.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json 3.10 REQUIRED)
find_package(LibZip REQUIRED)
find_package(Threads REQUIRED)
