// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Reports reach Python as the JSON objects of docs/report.md, so that there is one form to document.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace thicken::python {

/// A str; bytes that are no UTF-8 (a path may hold some) are replaced.
[[nodiscard]] inline pybind11::str text(const std::string& utf8) {
  PyObject* decoded = PyUnicode_DecodeUTF8(utf8.data(), static_cast<Py_ssize_t>(utf8.size()), "replace");
  if (decoded == nullptr) throw pybind11::error_already_set();
  return pybind11::reinterpret_steal<pybind11::str>(decoded);
}

/// The object that a JSON text describes.
[[nodiscard]] inline pybind11::object fromJson(const std::string& json) {
  return pybind11::module_::import("json").attr("loads")(text(json));
}

}  // namespace thicken::python
