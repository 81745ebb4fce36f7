// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings.h"
#include "thicken/version.h"

PYBIND11_MODULE(_thicken, module) {
  module.doc() = "Thickens open triangle surfaces into printable solids: libthicken on NumPy arrays.";
  module.attr("__version__") = thicken::kVersion;
  module.attr("__abi__") = THICKEN_ABI;
  thicken::python::bindError(module);
  thicken::python::bindContext(module);
  thicken::python::bindThicken(module);
  thicken::python::bindDrill(module);
  thicken::python::bindInspect(module);
  thicken::python::bindPicture(module);
  thicken::python::bindRepair(module);
  thicken::python::bindTrim(module);
  thicken::python::bindFiles(module);
}
