// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <utility>

#include "arrays.h"
#include "bindings.h"
#include "from_json.h"
#include "interruptible.h"
#include "thicken/thicken.h"

namespace py = pybind11;

namespace thicken::python {
namespace {

constexpr std::array kSides{std::pair{"negative", Side::kNegative}, std::pair{"positive", Side::kPositive},
                            std::pair{"both", Side::kBoth}};
constexpr std::array kJoins{std::pair{"mitre", Join::kMitre}, std::pair{"round", Join::kRound}};
constexpr std::array kSimplify{std::pair{"off", Simplify::kOff}, std::pair{"auto", Simplify::kAuto},
                               std::pair{"shell", Simplify::kShell}};
constexpr std::array kMethods{std::pair{"auto", Method::kAuto}, std::pair{"sweep", Method::kSweep},
                              std::pair{"reconstruct", Method::kReconstruct}};
constexpr std::array kPrecisions{std::pair{"single", Precision::kSingle},
                                 std::pair{"double", Precision::kDouble}};

template <class Choices>
auto chosen(const Choices& choices, const char* what, const std::string& word) {
  std::string words;
  for (const auto& [choice, value] : choices) {
    if (word == choice) return value;
    words += (words.empty() ? "'" : ", '") + std::string(choice) + "'";
  }
  throw py::value_error(std::string(what) + " must be one of " + words + ", not '" + word + "'");
}

py::dict toDict(Solid solid) {
  py::dict result;
  result["report"] = fromJson(toJson(solid.report));
  result["vertices"] = positionArray(std::move(solid.mesh.positions));
  result["triangles"] = triangleArray(solid.mesh.triangles);
  result["region"] = regionArray(solid.region);
  result["depth"] = numberArray(std::move(solid.depth));
  result["gap_surface"] = py::none();
  if (solid.gapSurface) {
    const py::array corners = triangleArray(solid.gapSurface->triangles);
    result["gap_surface"] = py::make_tuple(positionArray(std::move(solid.gapSurface->positions)), corners);
  }
  return result;
}

py::dict thickenArrays(const py::object& vertices, const py::object& triangles, double thickness,
                       const std::string& side, const std::string& method, const std::string& precision,
                       std::optional<double> cell, std::optional<int> resolution,
                       std::optional<double> tolerance, std::optional<int> smooth, bool repair,
                       std::optional<double> weldDistance, std::optional<double> bridge,
                       std::optional<double> fillHoles, bool strict, const std::optional<std::string>& join,
                       const std::string& simplify, double gap, int threads,
                       const std::optional<RunContext>& context, const std::vector<double>& thicknessMap,
                       std::optional<double> rimThickness, std::optional<double> rimWidth,
                       std::optional<double> rimRound) {
  if (!std::isfinite(thickness) || thickness <= 0)
    throw py::value_error("thickness must be a finite length above 0 mm");
  Options options;
  options.thickness = thickness;
  options.thicknessMap = thicknessMap;
  options.rimThickness = rimThickness;
  options.rimWidth = rimWidth;
  options.rimRound = rimRound;
  options.side = chosen(kSides, "side", side);
  options.method = chosen(kMethods, "method", method);
  options.precision = chosen(kPrecisions, "precision", precision);
  options.cell = cell;
  options.resolution = resolution;
  options.tolerance = tolerance;
  if (join) options.join = chosen(kJoins, "join", *join);
  options.simplify = chosen(kSimplify, "simplify", simplify);
  options.gap = gap;
  options.smooth = smooth;
  options.repair = repair;
  options.weld = weldDistance;
  options.bridge = bridge;
  options.fillHoles = fillHoles;
  options.strict = strict;
  options.threads = threads;
  const RunContext run = context.value_or(RunContext());
  const TriangleMesh surface = meshFrom(vertices, triangles);
  return toDict(runInterruptibly(run, [&] { return thicken(surface, options, run); }));
}

py::tuple forecastOf(std::size_t triangles, double area, double thickness, double diagonal,
                     const std::string& side, const std::string& method, std::optional<double> cell,
                     std::optional<int> resolution, std::optional<double> tolerance, double gap,
                     int threads) {
  Options options;
  options.thickness = thickness;
  options.gap = gap;
  options.side = chosen(kSides, "side", side);
  options.method = chosen(kMethods, "method", method);
  options.cell = cell;
  options.resolution = resolution;
  options.tolerance = tolerance;
  options.threads = threads;
  SurfaceFacts surface;
  surface.triangles = triangles;
  surface.area = area;
  surface.diagonal = diagonal;
  const Forecast told = forecast(surface, options);
  return py::make_tuple(told.seconds, told.bytes);
}

py::object checkArrays(const py::object& vertices, const py::object& triangles, int threads,
                       const std::optional<RunContext>& context) {
  const RunContext run = context.value_or(RunContext());
  const TriangleMesh mesh = meshFrom(vertices, triangles);
  return fromJson(toJson(runInterruptibly(run, [&] {
    const TriangleMesh welded = weld(mesh);
    CheckResult result = check(welded, run, threads);
    result.nearRims = nearRims(welded, run, threads);
    return result;
  })));
}

py::tuple weldArrays(const py::object& vertices, const py::object& triangles) {
  const TriangleMesh mesh = meshFrom(vertices, triangles);
  TriangleMesh welded = [&mesh] {
    const py::gil_scoped_release released;
    return weld(mesh);
  }();
  const py::array corners = triangleArray(welded.triangles);
  return py::make_tuple(positionArray(std::move(welded.positions)), corners);
}

}  // namespace

void bindThicken(py::module_& module) {
  using py::arg;
  module.def(
      "thicken", &thickenArrays, arg("vertices"), arg("triangles"), arg("thickness"), py::kw_only(),
      arg("side") = "negative", arg("method") = "auto", arg("precision") = "single", arg("cell") = py::none(),
      arg("resolution") = py::none(), arg("tolerance") = py::none(), arg("smooth") = py::none(),
      arg("repair") = false, arg("weld") = py::none(), arg("bridge") = py::none(),
      arg("fill_holes") = py::none(), arg("strict") = false, arg("join") = py::none(),
      arg("simplify") = "auto", arg("gap") = 0.0, arg("threads") = 0, arg("context") = py::none(),
      arg("thickness_map") = std::vector<double>(), arg("rim_thickness") = py::none(),
      arg("rim_width") = py::none(), arg("rim_round") = py::none(),
      "Thicken a surface; returns a dict of vertices, triangles, region, depth, gap_surface and report.");
  module.def("forecast", &forecastOf, arg("triangles"), arg("area"), arg("thickness"), py::kw_only(),
             arg("diagonal") = 0.0, arg("side") = "negative", arg("method") = "auto",
             arg("cell") = py::none(), arg("resolution") = py::none(), arg("tolerance") = py::none(),
             arg("gap") = 0.0, arg("threads") = 0,
             "What thickening a surface of such a size is likely to take: seconds, and bytes at most.");
  module.def("check", &checkArrays, arg("vertices"), arg("triangles"), py::kw_only(), arg("threads") = 0,
             arg("context") = py::none(),
             "Find every kind of defect of a surface; returns a dict of status, input and defects.");
  module.def("weld", &weldArrays, arg("vertices"), arg("triangles"),
             "Make corners with equal coordinates one vertex; returns the new vertices and triangles, whose "
             "ids are those that defects name.");
}

}  // namespace thicken::python
