// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/audit.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <utility>

#include "check/findings.h"
#include "check/meetings.h"
#include "check/nesting.h"
#include "check/surface_facts.h"
#include "exact/domain.h"
#include "mesh/half_edges.h"
#include "mesh/topology.h"
#include "parallel/parallel_for.h"
#include "thicken/check.h"

namespace thicken::checking {

using mesh::HalfEdges;

namespace {

std::string text(const Vec3& p) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", p[0], p[1], p[2]);
}

// The solid and the surface over common vertices: equal coordinates, equal ids.
struct Subject {
  TriangleMesh solid;
  std::vector<Triangle> surface;
  std::vector<VertexId> given;  // the id that a vertex of the solid has outside of the audit
};

Subject welded(const TriangleMesh& solid, const TriangleMesh& surface, int threads) {
  TriangleMesh both;
  both.positions.reserve(solid.positions.size() + surface.positions.size());
  both.triangles.reserve(solid.triangles.size() + surface.triangles.size());
  both.positions = solid.positions;
  both.triangles = solid.triangles;
  const auto first = static_cast<VertexId>(solid.positions.size());
  both.positions.insert(both.positions.end(), surface.positions.begin(), surface.positions.end());
  for (const Triangle& t : surface.triangles)
    both.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  Subject subject{weld(both, threads), {}, {}};
  auto& triangles = subject.solid.triangles;
  const auto end = triangles.begin() + static_cast<std::ptrdiff_t>(solid.triangles.size());
  subject.surface.assign(end, triangles.end());
  triangles.erase(end, triangles.end());
  subject.given.resize(subject.solid.positions.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) subject.given[triangles[t][k]] = solid.triangles[t][k];
  return subject;
}

// One audit: the verdicts fall one after the other, each with its defect where it is negative.
class Auditor {
 public:
  Auditor(const TriangleMesh& solid, const TriangleMesh& surface, Side side, const RunContext& context,
          int threads, std::span<const TriangleId> order, std::size_t most)
      : subject_(welded(solid, surface, threads)),
        mesh_(subject_.solid),
        side_(side),
        context_(context),
        threads_(threads),
        order_(order),
        most_(most) {}

  AuditResult run() {
    exact::requireExactArithmetic();
    if (mesh_.triangles.empty()) {
      report(ErrorCode::kEmpty, 1, Vec3::Zero(), "the solid has no triangles");
      return result_;
    }
    if (!coordinatesInDomain()) return result_;
    const BadTriangles bad = badTriangles(mesh_, true, context_, threads_);
    judgeTriangles(bad);
    const HalfEdges edges(mesh_.positions.size(), mesh_.triangles, bad.joined, threads_);
    context_.throwIfCancelled();
    judgeJoints(badJoints(mesh_, edges, context_, threads_));
    judgeKept(edges);
    context_.throwIfCancelled();
    judgeMeetings(exact::PairSearch(mesh_, most_, threads_, bad.proper, order_));
    judgeSense(edges);
    return result_;
  }

 private:
  // A defect with its first place; the caller adds the elements.
  Defect& report(ErrorCode code, std::size_t count, const Vec3& place, std::string sentence) {
    Defect d;
    d.code = code;
    d.count = count;
    d.place = place;
    d.sentence = std::move(sentence);
    return result_.defects.emplace_back(std::move(d));
  }
  template <class T>
  static void fill(std::vector<T>& list, const std::vector<T>& all) {
    list.assign(all.begin(),
                all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), Defect::kMaxListed)));
  }
  void fillVertices(Defect& d, const std::vector<VertexId>& all) const {
    fill(d.vertices, all);
    for (VertexId& v : d.vertices) v = subject_.given[v];
  }
  [[nodiscard]] Vec3 middle(const Edge& e) const {
    return 0.5 * (mesh_.positions[e[0]] + mesh_.positions[e[1]]);
  }

  bool coordinatesInDomain() {
    if (std::ranges::all_of(mesh_.positions, exact::inDomain)) return true;
    for (const Triangle& t : mesh_.triangles) {
      for (const VertexId v : t) {
        const Vec3& p = mesh_.positions[v];
        if (exact::inDomain(p)) continue;
        const bool tiny = isFinite(p);
        Defect& d = report(ErrorCode::kNotFinite, 1, tiny ? p : Vec3(Vec3::Zero()),
                           fmt::format("the solid has a coordinate {}, at {}",
                                       tiny ? "that is not 0 but too small to be computed with exactly"
                                            : "that no single-precision number can hold",
                                       text(p)));
        fillVertices(d, {v});
        return false;
      }
    }
    return true;
  }

  void judgeTriangles(const BadTriangles& bad) {
    std::vector<TriangleId> all = bad.withoutArea;
    for (const auto& pair : bad.duplicates) all.push_back(pair.second);
    result_.facts.nonDegenerate = all.empty();
    if (all.empty()) return;
    const Vec3& place = mesh_.positions[mesh_.triangles[all[0]][0]];
    Defect& d =
        report(ErrorCode::kDegenerate, all.size(), place,
               fmt::format("the solid has {} triangles without area or with the corners of another, the "
                           "first at {}",
                           all.size(), text(place)));
    fill(d.triangles, all);
  }

  void judgeEdges(const std::vector<Edge>& all, ErrorCode code, const char* what) {
    if (all.empty()) return;
    const Vec3 place = middle(all[0]);
    Defect& d =
        report(code, all.size(), place,
               fmt::format("{} edges of the solid {}, the first at {}", all.size(), what, text(place)));
    fill(d.edges, all);
    for (Edge& e : d.edges) e = {subject_.given[e[0]], subject_.given[e[1]]};
  }

  void judgeJoints(const BadJoints& joints) {
    AuditFacts& facts = result_.facts;
    facts.closed = joints.rim.empty();
    facts.edgeManifold = joints.nonManifoldEdges.empty();
    facts.vertexManifold = joints.nonManifoldVertices.empty();
    facts.oriented = joints.sameSense.empty();
    judgeEdges(joints.rim, ErrorCode::kNoSolid, "have a triangle on one side only");
    judgeEdges(joints.nonManifoldEdges, ErrorCode::kNotManifold, "join more than two triangles");
    judgeEdges(joints.sameSense, ErrorCode::kNotOriented, "join triangles of opposite sense");
    if (joints.nonManifoldVertices.empty()) return;
    const Vec3& place = mesh_.positions[joints.nonManifoldVertices[0]];
    Defect& d = report(ErrorCode::kNotManifold, joints.nonManifoldVertices.size(), place,
                       fmt::format("parts of the solid touch in {} single points, the first at {}",
                                   joints.nonManifoldVertices.size(), text(place)));
    fillVertices(d, joints.nonManifoldVertices);
  }

  // Triangles of the surface (in the sense that the side asks for), or for Side::kBoth the edges of
  // its rim, that the solid does not have.
  [[nodiscard]] std::vector<TriangleId> missingTriangles(const HalfEdges& edges) const {
    std::vector<std::uint8_t> found(subject_.surface.size());
    parallel::parallelFor(found.size(), threads_, context_, 4096, [&](std::size_t i) {
      Triangle t = subject_.surface[i];
      if (side_ == Side::kPositive) std::swap(t[1], t[2]);
      const auto uses = edges.uses(t[0], t[1]);
      found[i] = std::any_of(uses.begin(), uses.end(), [&](const mesh::HalfEdge& e) {
        return mesh_.triangles[e.triangle()][(e.corner() + 2) % 3] == t[2];
      });
    });
    std::vector<TriangleId> missing;
    for (TriangleId i = 0; i < found.size(); ++i)
      if (found[i] == 0) missing.push_back(i);
    return missing;
  }
  [[nodiscard]] std::vector<TriangleId> missingRim(const HalfEdges& edges) const {
    std::vector<TriangleId> missing;
    for (const mesh::RimEdge& e : mesh::rimOf(mesh_.positions.size(), subject_.surface).edges)
      if (edges.uses(e.from, e.to).empty() && edges.uses(e.to, e.from).empty()) missing.push_back(e.triangle);
    std::sort(missing.begin(), missing.end());
    return missing;
  }
  void judgeKept(const HalfEdges& edges) {
    const bool rimOnly = side_ == Side::kBoth;
    const std::vector<TriangleId> missing = rimOnly ? missingRim(edges) : missingTriangles(edges);
    result_.facts.surfaceKept = missing.empty();
    if (missing.empty()) return;
    const Vec3& place = mesh_.positions[subject_.surface[missing[0]][0]];
    Defect& d =
        report(ErrorCode::kNoSolid, missing.size(), place,
               fmt::format("{} {} of the surface are not found in the solid, the first at triangle {} at {}",
                           missing.size(), rimOnly ? "rim edges" : "triangles", missing[0], text(place)));
    fill(d.triangles, missing);
  }

  void judgeMeetings(const exact::PairSearch& search) {
    const Meetings meetings = meetingsOf(search, context_, threads_);
    result_.facts.intersectionFree = meetings.count == 0;
    if (meetings.count == 0) return;
    const Vec3 place = placeOf(mesh_, meetings.pairs[0]);
    Defect& d = report(ErrorCode::kSelfIntersecting, meetings.count, place,
                       fmt::format("{}{} pairs of triangles of the solid meet, the first near {}",
                                   meetings.more ? "more than " : "", meetings.count, text(place)));
    for (const auto& [a, b] : meetings.pairs) {
      d.triangles.push_back(a);
      d.triangles.push_back(b);
    }
  }

  [[nodiscard]] double summedVolume() const {
    const Vec3 origin = mesh_.positions[mesh_.triangles[0][0]];
    double sum = 0;
    for (const Triangle& t : mesh_.triangles) {
      const Vec3 a = mesh_.positions[t[0]] - origin, b = mesh_.positions[t[1]] - origin;
      sum += a.cross(b).dot(mesh_.positions[t[2]] - origin);
    }
    return sum / 6;
  }

  // Inside and outside mean something only where every other clause holds. Then the sense of each
  // shell is decided exactly, and shells of the right sense enclose a positive volume. Elsewhere the
  // solid has failed already, and the sign of a floating-point sum says what is left to say.
  void judgeSense(const HalfEdges& edges) {
    AuditFacts& facts = result_.facts;
    const bool decidable = facts.closed && facts.edgeManifold && facts.vertexManifold && facts.oriented &&
                           facts.nonDegenerate && facts.intersectionFree;
    std::vector<VertexId> wrong;
    if (decidable) {
      const mesh::Components shells = mesh::componentsOf(mesh_.positions.size(), mesh_.triangles, threads_);
      const std::vector<VertexId> lowest = lowestVertices(mesh_, shells);
      const exact::BoxTree tree(mesh_.positions, mesh_.triangles, threads_,
                                trianglesBelow(mesh_, lowest, threads_));
      for (std::uint32_t s = 0; s < shells.count; ++s)
        if (facesOutward(mesh_, edges, lowest[s]) == insideOddNumber(mesh_, tree, shells, lowest[s], s))
          wrong.push_back(lowest[s]);
      facts.oriented = wrong.empty();
    }
    facts.positiveVolume = (decidable && wrong.empty()) || summedVolume() > 0;
    if (!wrong.empty()) {
      const Vec3& place = mesh_.positions[wrong[0]];
      Defect& d = report(
          ErrorCode::kNotOriented, wrong.size(), place,
          fmt::format("{} shells of the solid are inside out, the first at {}", wrong.size(), text(place)));
      fillVertices(d, wrong);
    }
    if (!facts.positiveVolume)
      report(ErrorCode::kNoSolid, 1, Vec3::Zero(), "the volume of the solid is not positive");
  }

  Subject subject_;
  const TriangleMesh& mesh_;
  Side side_;
  const RunContext& context_;
  int threads_;
  std::span<const TriangleId> order_;
  std::size_t most_;
  AuditResult result_;
};

}  // namespace

AuditResult audit(const TriangleMesh& solid, const TriangleMesh& surface, Side side,
                  const RunContext& context, int threads, std::span<const TriangleId> order,
                  std::size_t most) {
  return Auditor(solid, surface, side, context, threads, order, most).run();
}

}  // namespace thicken::checking
