// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings.h"
#include "thicken/run_context.h"

namespace py = pybind11;

namespace thicken::python {

void bindContext(py::module_& module) {
  py::class_<RunContext>(module, "RunContext",
                         "A handle to one run: give it to the run, poll and cancel it from another thread.")
      .def(py::init<>())
      .def("cancel", &RunContext::cancel,
           "Ask the run to stop; it ends with ThickenError, code 'cancelled'. Any thread, any number of "
           "times.")
      .def_property_readonly("cancelled", &RunContext::cancelled, "Whether cancel() was called.")
      .def_property_readonly("progress", &RunContext::progress, "Share of the run that is done, 0 to 1.")
      .def_property_readonly(
          "stage", [](const RunContext& context) { return std::string(name(context.stage())); },
          "What the run is doing, such as 'checking' or 'sweeping'.")
      .def("set_time_limit", &RunContext::setTimeLimit, py::arg("seconds"),
           "Seconds that the run may take from now on; it ends with ThickenError, code 'time-limit'. 0: no "
           "limit.")
      .def_property("memory_limit", &RunContext::memoryLimit, &RunContext::setMemoryLimit,
                    "Bytes that the run may take; 0: no limit. Set it before the run.");
}

}  // namespace thicken::python
