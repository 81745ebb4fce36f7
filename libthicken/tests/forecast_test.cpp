// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/forecast.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "analytic_surfaces.h"
#include "thicken/thicken.h"

namespace thicken {
namespace {

SurfaceFacts sizes(std::size_t triangles, double area) {
  SurfaceFacts surface;
  surface.triangles = triangles;
  surface.area = area;
  surface.diagonal = std::sqrt(area);
  return surface;
}

Options optionsOf(Method method, double thickness) {
  Options options;
  options.method = method;
  options.thickness = thickness;
  options.threads = 1;
  return options;
}

TEST(Forecast, GoesWithTrianglesAreaThicknessAndCells) {
  const SurfaceFacts surface = sizes(10'000, 1000);
  const Options usual = optionsOf(Method::kReconstruct, 2);
  const auto expectMore = [&](const SurfaceFacts& larger, const Options& options, const char* what) {
    EXPECT_GT(forecast(larger, options).seconds, forecast(surface, usual).seconds) << what;
    EXPECT_GT(forecast(larger, options).bytes, forecast(surface, usual).bytes) << what;
  };
  expectMore(sizes(20'000, 1000), usual, "triangles");
  expectMore(sizes(10'000, 2000), usual, "area");
  expectMore(surface, optionsOf(Method::kReconstruct, 1), "thickness");
  Options finer = usual;
  finer.cell = 0.1;
  expectMore(surface, finer, "cell");
  finer = usual;
  finer.resolution = 1000;
  expectMore(surface, finer, "resolution");
  finer = usual;
  finer.tolerance = 0.01;
  expectMore(surface, finer, "tolerance");
}

TEST(Forecast, ASweepHasNoCellsAndBothSidesAreMore) {
  const SurfaceFacts surface = sizes(10'000, 1000);
  Options options = optionsOf(Method::kSweep, 2);
  const Forecast one = forecast(surface, options);
  EXPECT_EQ(one.bytes, one.leastBytes);
  EXPECT_LT(one.seconds, forecast(surface, optionsOf(Method::kAuto, 2)).seconds);
  options.side = Side::kBoth;
  EXPECT_NEAR(forecast(surface, options).seconds, 1.5 * one.seconds, 1e-12);
}

TEST(Forecast, MoreThreadsTakeLessTime) {
  const SurfaceFacts surface = sizes(10'000, 1000);
  Options options = optionsOf(Method::kSweep, 2);
  const double one = forecast(surface, options).seconds;
  options.threads = 2;
  const double two = forecast(surface, options).seconds;
  EXPECT_LT(two, one);
  EXPECT_GT(two, one / 2);
}

TEST(Forecast, IsANumberForAnySurface) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const double area : {0.0, 1e-300, 1e300, kInfinite, std::nan("")})
    for (const double r : {1e-300, 1.0, 1e300}) {
      const Forecast told = forecast(sizes(100, area), optionsOf(Method::kReconstruct, r));
      EXPECT_TRUE(std::isfinite(told.seconds)) << area << ' ' << r;
      EXPECT_GE(told.bytes, told.leastBytes) << area << ' ' << r;
    }
}

TEST(Forecast, IsWhatTheReportTells) {
  const TriangleMesh surface = shapes::plane(20, 10);
  for (const Method method : {Method::kSweep, Method::kAuto, Method::kReconstruct}) {
    const Options options = optionsOf(method, 0.5);
    const Report report = thicken(surface, options).report;
    const Forecast told = forecast(report.input, options);
    EXPECT_DOUBLE_EQ(report.predictedSeconds, told.seconds);
    EXPECT_GE(report.predictedMemory, told.bytes);
    EXPECT_LE(report.predictedMemory, 2 * told.bytes);
  }
}

}  // namespace
}  // namespace thicken
