// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Times of the library's inner parts, by Google Benchmark, on bumpy sheets that are made here. Names are
// part/surface/…; THICKEN_BENCH_SURFACE=FILE adds the same on the surface of a file, and
// THICKEN_BENCH_THICKNESS its thickness in mm (1 % of its diagonal).
//
// usage: thicken_kernels [--benchmark_filter=REGEX] [--benchmark_repetitions=N] …
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include "bumpy_patch.h"
#include "check/audit.h"
#include "check/meetings.h"
#include "exact/box_tree.h"
#include "mesh/bounds.h"
#include "mesh/normals.h"
#include "sweep/sweep.h"
#include "thicken/thicken.h"

namespace thicken {

using mesh::Bounds;
using mesh::boundsOf;

namespace {

constexpr int kAllThreads = 0;

struct Subject {
  std::string name;
  TriangleMesh surface;
  double thickness = 1;  ///< mm
};
using SubjectPtr = std::shared_ptr<const Subject>;

void countTriangles(benchmark::State& state, const TriangleMesh& mesh) {
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}

void buildTree(benchmark::State& state, const SubjectPtr& subject) {
  for (auto _ : state) {
    ClosestPointTree tree(subject->surface);
    benchmark::DoNotOptimize(tree);
  }
  countTriangles(state, subject->surface);
}

// Points below triangles all over the surface.
std::vector<Vec3> pointsBelow(const TriangleMesh& surface, double distance) {
  constexpr std::size_t kCount = 1 << 14, kStride = 7919;  // a prime: neighbours do not follow each other
  const auto normals = mesh::faceNormals(surface.positions, surface.triangles);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < kCount; ++i) {
    const std::size_t t = i * kStride % surface.triangles.size();
    const auto& [a, b, c] = surface.triangles[t];
    const Vec3 middle = (surface.positions[a] + surface.positions[b] + surface.positions[c]) / 3;
    points.push_back(middle - distance * normals[t].normalized());
  }
  return points;
}

// One query an iteration, on one thread.
void closest(benchmark::State& state, const SubjectPtr& subject, double distance) {
  const ClosestPointTree tree(subject->surface);
  const std::vector<Vec3> points = pointsBelow(subject->surface, distance);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(tree.closest(points[i++ % points.size()]));
  state.SetItemsProcessed(state.iterations());
}

void weldSurface(benchmark::State& state, const SubjectPtr& subject) {
  for (auto _ : state) benchmark::DoNotOptimize(weld(subject->surface));
  countTriangles(state, subject->surface);
}

void checkSurface(benchmark::State& state, const SubjectPtr& subject) {
  for (auto _ : state) benchmark::DoNotOptimize(check(subject->surface, {}, kAllThreads));
  countTriangles(state, subject->surface);
}

void findMeetings(benchmark::State& state, const SubjectPtr& subject) {
  for (auto _ : state) {
    const exact::PairSearch search(subject->surface, exact::PairSearch::kAll, kAllThreads);
    benchmark::DoNotOptimize(checking::meetingsOf(search, {}, kAllThreads));
  }
  countTriangles(state, subject->surface);
}

sweep::SweepResult swept(const Subject& subject, const ClosestPointTree& tree) {
  const Options options;
  const RunContext context;
  job::Stopwatch watch;
  return sweep::sweep(
      {subject.surface, tree, job::Thickness(subject.thickness), options, context, kAllThreads, watch});
}

void sweepSurface(benchmark::State& state, const SubjectPtr& subject) {
  const ClosestPointTree tree(subject->surface);
  for (auto _ : state) benchmark::DoNotOptimize(swept(*subject, tree));
  countTriangles(state, subject->surface);
}

void auditSolid(benchmark::State& state, const SubjectPtr& subject) {
  const TriangleMesh solid = swept(*subject, ClosestPointTree(subject->surface)).mesh;
  for (auto _ : state) {
    const checking::AuditResult proof =
        checking::audit(solid, subject->surface, Side::kNegative, {}, kAllThreads);
    if (!proof.facts.passed()) state.SkipWithError("the audit failed");
  }
  countTriangles(state, solid);
}

// The field and its contour as a whole run makes them, by the run's own clock.
void fieldAndContour(benchmark::State& state, const SubjectPtr& subject) {
  Options options;
  options.thickness = subject->thickness;
  options.method = Method::kReconstruct;
  options.cell = subject->thickness / static_cast<double>(state.range(0));
  Report report;
  for (auto _ : state) {
    report = thicken(subject->surface, options).report;
    double seconds = 0;
    for (const auto& [stage, time] : report.seconds)
      if (stage == "field" || stage == "faces") seconds += time;
    state.SetIterationTime(seconds);
  }
  state.counters["cells"] = static_cast<double>(report.fieldCells);
  state.counters["nodes"] = static_cast<double>(report.fieldNodes);
}

template <class Run, class... More>
benchmark::internal::Benchmark* add(const std::string& part, const SubjectPtr& subject, Run run,
                                    More... more) {
  return benchmark::RegisterBenchmark((part + "/" + subject->name).c_str(),
                                      [=](benchmark::State& state) { run(state, subject, more...); });
}

void addProofs(const SubjectPtr& subject) {
  using Run = void (*)(benchmark::State&, const SubjectPtr&);
  constexpr std::pair<const char*, Run> kParts[] = {{"weld", weldSurface},
                                                    {"check", checkSurface},
                                                    {"meetings", findMeetings},
                                                    {"sweep", sweepSurface},
                                                    {"audit", auditSolid}};
  for (const auto& [part, run] : kParts)
    add(part, subject, run)->UseRealTime()->Unit(benchmark::kMillisecond);
}

void addAll(const SubjectPtr& subject) {
  const Bounds box = boundsOf(subject->surface);
  add("tree", subject, buildTree)->UseRealTime()->Unit(benchmark::kMillisecond);
  add("closest/on", subject, closest, 0.0);
  add("closest/near", subject, closest, subject->thickness);
  add("closest/far", subject, closest, 0.2 * (box.high - box.low).norm());
  addProofs(subject);
  add("field+contour", subject, fieldAndContour)
      ->ArgName("cells_per_thickness")
      ->Arg(3)
      ->Arg(6)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

// The surface that the environment names, if any.
SubjectPtr namedSurface() {
  const char* file = std::getenv("THICKEN_BENCH_SURFACE");
  if (!file) return nullptr;
  TriangleMesh surface = weld(readMesh(file));
  const Bounds box = boundsOf(surface);
  const char* thickness = std::getenv("THICKEN_BENCH_THICKNESS");
  const double r = thickness ? std::atof(thickness) : 0.01 * (box.high - box.low).norm();
  return std::make_shared<Subject>(Subject{"file", std::move(surface), r});
}

void addSubjects() {
  addAll(std::make_shared<Subject>(Subject{"20k", bumpyPatch(100)}));
  addAll(std::make_shared<Subject>(Subject{"320k", bumpyPatch(400)}));
  // Its solid has a million triangles.
  addProofs(std::make_shared<Subject>(Subject{"500k", bumpyPatch(500)}));
  if (const SubjectPtr named = namedSurface()) addAll(named);
}

}  // namespace
}  // namespace thicken

int main(int count, char** word) {
  benchmark::Initialize(&count, word);
  if (benchmark::ReportUnrecognizedArguments(count, word)) return 2;
  try {
    thicken::addSubjects();
    benchmark::RunSpecifiedBenchmarks();
  } catch (const thicken::Error& error) {
    std::cerr << "thicken_kernels: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
