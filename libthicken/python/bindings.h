// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The parts that the module _thicken is put together from.
#pragma once

#include <pybind11/pybind11.h>

namespace thicken::python {

void bindError(pybind11::module_& module);
void bindContext(pybind11::module_& module);
void bindThicken(pybind11::module_& module);
void bindDrill(pybind11::module_& module);
void bindInspect(pybind11::module_& module);
void bindPicture(pybind11::module_& module);
void bindRepair(pybind11::module_& module);
void bindTrim(pybind11::module_& module);
void bindFiles(pybind11::module_& module);

}  // namespace thicken::python
