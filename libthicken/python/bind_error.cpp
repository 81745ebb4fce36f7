// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings.h"
#include "from_json.h"
#include "thicken/error.h"
#include "thicken/report.h"

namespace py = pybind11;

namespace thicken::python {
namespace {

constexpr const char* kDoc =
    "What the library refuses or cannot do, as a sentence that says what to do.\n\n"
    "code: a word that programs can branch on, such as 'not-manifold' or 'no-solid'.\n"
    "defects: a list of dicts with code, sentence, count, place_mm, vertices, edges and triangles.\n"
    "input, repair: what is known of the surface and of its repair, as in the report, or None.\n"
    "memory, time: dicts of what would have been enough, as in the report, or None.";

// Lives as long as the interpreter: never released, so that no destructor runs after Python's end.
PyObject* errorType = nullptr;

void raise(const Error& error) {
  try {
    py::object raised = py::handle(errorType)(text(error.what()));
    raised.attr("code") = std::string(name(error.code()));
    const py::object report = fromJson(toJson(error));
    for (const char* key : {"defects", "input", "repair", "memory", "time"}) raised.attr(key) = report[key];
    PyErr_SetObject(errorType, raised.ptr());
  } catch (py::error_already_set& failure) {
    failure.restore();
  }
}

}  // namespace

void bindError(py::module_& module) {
  py::dict defaults;
  defaults["code"] = std::string(name(ErrorCode::kInternal));
  defaults["defects"] = py::tuple();
  defaults["input"] = py::none();
  defaults["repair"] = py::none();
  defaults["memory"] = py::none();
  defaults["time"] = py::none();
  const std::string fullName = module.attr("__name__").cast<std::string>() + ".ThickenError";
  errorType = PyErr_NewExceptionWithDoc(fullName.c_str(), kDoc, PyExc_RuntimeError, defaults.ptr());
  if (errorType == nullptr) throw py::error_already_set();
  module.attr("ThickenError") = py::reinterpret_borrow<py::object>(errorType);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(error);
    }
  });
}

}  // namespace thicken::python
