// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "check/findings.h"
#include "check/meetings.h"
#include "check/orientability.h"
#include "check/surface_facts.h"
#include "exact/domain.h"
#include "mesh/place_text.h"

namespace thicken {

using checking::BadJoints;
using checking::BadTriangles;
using checking::Edge;
using checking::Meetings;
using mesh::HalfEdges;
using mesh::text;

namespace {

// What the check itself holds at its peak: half-edges and sets of corners, or the tree.
constexpr std::size_t kBytesPerTriangle = 160;

template <class T>
void append(std::vector<T>& list, const T& item) {
  if (list.size() < Defect::kMaxListed) list.push_back(item);
}

// "", or ", and 7 more …": what follows the first of `count` findings.
std::string andMore(std::size_t count, const char* one, const char* many) {
  if (count < 2) return "";
  return fmt::format(", and {} more {}", count - 1, count == 2 ? one : many);
}

Vec3 centre(const TriangleMesh& mesh, TriangleId t) {
  const Triangle& c = mesh.triangles[t];
  return (mesh.positions[c[0]] + mesh.positions[c[1]] + mesh.positions[c[2]]) / 3;
}

Vec3 middle(const TriangleMesh& mesh, const Edge& e) {
  return 0.5 * (mesh.positions[e[0]] + mesh.positions[e[1]]);
}

Defect emptyDefect() {
  Defect d;
  d.code = ErrorCode::kEmpty;
  d.sentence = "the mesh has no triangles; export the surface with its faces, not only its points";
  d.count = 1;
  return d;
}

// What the arithmetic of exact decisions cannot take: no numbers, too large ones, and too small ones.
Defect notFinite(const TriangleMesh& mesh, const std::vector<VertexId>& vertices) {
  Defect d;
  d.code = ErrorCode::kNotFinite;
  d.count = vertices.size();
  std::vector<VertexId> unfit, tiny;
  for (const VertexId v : vertices) {
    append(d.vertices, v);
    (checking::isFinite(mesh.positions[v]) ? tiny : unfit).push_back(v);
  }
  if (!unfit.empty())
    d.sentence = fmt::format(
        "vertex {} has a coordinate that is not a number or too large for single precision: {}{}; "
        "export the mesh again or delete what uses it",
        unfit[0], text(mesh.positions[unfit[0]]), andMore(unfit.size(), "such vertex", "such vertices"));
  if (!tiny.empty()) {
    if (unfit.empty()) d.place = mesh.positions[tiny[0]];
    d.sentence += fmt::format(
        "{}vertex {} at {} has a coordinate that is not 0 but below {:.2g}, too small to be computed with "
        "exactly{}; make it 0, as storing it in an .stl does",
        d.sentence.empty() ? "" : "; also, ", tiny[0], text(mesh.positions[tiny[0]]), exact::kLeastCoordinate,
        andMore(tiny.size(), "such vertex", "such vertices"));
  }
  return d;
}

std::string trianglesAt(const HalfEdges& edges, const Edge& e) {
  constexpr std::size_t kNamed = 5;
  std::string ids;
  std::size_t count = 0;
  for (const auto& uses : {edges.uses(e[0], e[1]), edges.uses(e[1], e[0])})
    for (const mesh::HalfEdge& h : uses)
      if (++count <= kNamed) ids += fmt::format("{}{}", ids.empty() ? "" : ", ", h.triangle());
  return fmt::format("{} triangles ({}{})", count, ids, count > kNamed ? ", …" : "");
}

Defect notManifold(const TriangleMesh& mesh, const HalfEdges& edges, const BadJoints& joints) {
  Defect d;
  d.code = ErrorCode::kNotManifold;
  d.count = joints.nonManifoldEdges.size() + joints.nonManifoldVertices.size();
  for (const Edge& e : joints.nonManifoldEdges) append(d.edges, e);
  for (const VertexId v : joints.nonManifoldVertices) append(d.vertices, v);
  if (!joints.nonManifoldEdges.empty()) {
    const Edge& e = joints.nonManifoldEdges[0];
    d.place = middle(mesh, e);
    d.sentence = fmt::format(
        "edge {}-{} at {} is shared by {}, where at most two can meet on a surface{}; "
        "delete the surplus triangles or split the mesh along the edge",
        e[0], e[1], text(d.place), trianglesAt(edges, e),
        andMore(joints.nonManifoldEdges.size(), "such edge", "such edges"));
  }
  if (!joints.nonManifoldVertices.empty()) {
    const VertexId v = joints.nonManifoldVertices[0];
    if (joints.nonManifoldEdges.empty()) d.place = mesh.positions[v];
    d.sentence += fmt::format(
        "{}at vertex {} at {} parts of the surface touch in this point only{}; "
        "give each part a vertex of its own, moved apart, or delete one of them",
        d.sentence.empty() ? "" : "; also, ", v, text(mesh.positions[v]),
        andMore(joints.nonManifoldVertices.size(), "such vertex", "such vertices"));
  }
  return d;
}

Defect notOriented(const TriangleMesh& mesh, const HalfEdges& edges, const BadJoints& joints) {
  const checking::Orientability found = checking::orientability(mesh, edges);
  Defect d;
  d.code = ErrorCode::kNotOriented;
  d.count = joints.sameSense.size();
  for (const Edge& e : joints.sameSense) append(d.edges, e);
  for (const TriangleId t : found.toTurn) append(d.triangles, t);
  const Edge& e = found.oneSided.empty() ? joints.sameSense[0] : found.oneSided[0];
  d.place = middle(mesh, e);
  if (!found.oneSided.empty()) {
    d.sentence = fmt::format(
        "the surface is one-sided, like a Moebius strip, around edge {}-{} at {}: it has no "
        "positive and negative side; cut it open across the strip",
        e[0], e[1], text(d.place));
    return d;
  }
  const auto uses = edges.uses(e[0], e[1]);
  d.sentence = fmt::format(
      "triangles {} and {} at edge {}-{} at {} turn opposite sides to one another{}; turn over {} "
      "triangle{}, triangle {} the first of them, to give the surface one positive side",
      uses[0].triangle(), uses[1].triangle(), e[0], e[1], text(d.place),
      andMore(d.count, "such edge", "such edges"), found.toTurn.size(), found.toTurn.size() == 1 ? "" : "s",
      found.toTurn[0]);
  return d;
}

Defect degenerate(const TriangleMesh& mesh, const BadTriangles& bad) {
  Defect d;
  d.code = ErrorCode::kDegenerate;
  d.count = bad.withoutArea.size() + bad.duplicates.size();
  for (const TriangleId t : bad.withoutArea) append(d.triangles, t);
  for (const auto& pair : bad.duplicates) append(d.triangles, pair.second);
  if (!bad.withoutArea.empty()) {
    const TriangleId t = bad.withoutArea[0];
    d.place = centre(mesh, t);
    d.sentence = fmt::format(
        "triangle {} at {} has no area: its corners are on one line or are the same{}; "
        "delete it, or collapse its shortest edge where it joins others",
        t, text(d.place), andMore(bad.withoutArea.size(), "such triangle", "such triangles"));
  }
  if (!bad.duplicates.empty()) {
    const auto [first, later] = bad.duplicates[0];
    if (bad.withoutArea.empty()) d.place = centre(mesh, later);
    d.sentence +=
        fmt::format("{}triangle {} at {} has the same corners as triangle {}{}; delete one of the two",
                    d.sentence.empty() ? "" : "; also, ", later, text(centre(mesh, later)), first,
                    andMore(bad.duplicates.size(), "such triangle", "such triangles"));
  }
  return d;
}

Defect selfIntersecting(const TriangleMesh& mesh, const Meetings& meetings) {
  Defect d;
  d.code = ErrorCode::kSelfIntersecting;
  d.count = meetings.count;
  for (const auto& [a, b] : meetings.pairs) {
    append(d.triangles, a);
    append(d.triangles, b);
  }
  const auto& first = meetings.pairs[0];
  d.place = checking::placeOf(mesh, first);
  d.sentence = fmt::format(
      "triangles {} and {} run through or touch each other near {}{}; "
      "move the sheets apart there or delete the triangles that cross",
      first.first, first.second, text(d.place),
      meetings.more ? fmt::format(", and more than {} other pairs", meetings.count)
                    : andMore(meetings.count, "such pair", "such pairs"));
  return d;
}

std::vector<VertexId> verticesOutOfDomain(const TriangleMesh& mesh) {
  if (std::ranges::all_of(mesh.positions, exact::inDomain)) return {};
  std::vector<std::uint8_t> bad(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles)
    for (const VertexId v : t)
      if (!exact::inDomain(mesh.positions[v])) bad[v] = 1;
  std::vector<VertexId> result;
  for (VertexId v = 0; v < bad.size(); ++v)
    if (bad[v] != 0) result.push_back(v);
  return result;
}

}  // namespace

CheckResult check(const TriangleMesh& mesh, RunContext context, int threads) {
  context.reserve(kBytesPerTriangle * mesh.triangles.size(),
                  "simplify the mesh or check a part of it at a time");
  exact::requireExactArithmetic();
  CheckResult result;
  const std::vector<VertexId> unfit = verticesOutOfDomain(mesh);
  const bool finite = unfit.empty();
  const BadTriangles bad = checking::badTriangles(mesh, finite, context, threads);
  {
    const HalfEdges edges(mesh.positions.size(), mesh.triangles, bad.joined, threads);
    context.throwIfCancelled();
    const BadJoints joints = checking::badJoints(mesh, edges, context, threads);
    result.facts = checking::factsOf(mesh, joints, finite, threads);
    if (mesh.triangles.empty()) result.defects.push_back(emptyDefect());
    if (!finite) result.defects.push_back(notFinite(mesh, unfit));
    if (!bad.withoutArea.empty() || !bad.duplicates.empty()) result.defects.push_back(degenerate(mesh, bad));
    if (!joints.nonManifoldEdges.empty() || !joints.nonManifoldVertices.empty())
      result.defects.push_back(notManifold(mesh, edges, joints));
    if (!joints.sameSense.empty()) result.defects.push_back(notOriented(mesh, edges, joints));
  }
  if (finite && !mesh.triangles.empty()) {
    context.throwIfCancelled();
    const exact::PairSearch search(mesh, exact::PairSearch::kAll, threads, bad.proper);
    const Meetings meetings = checking::meetingsOf(search, context, threads);
    if (meetings.count > 0) result.defects.push_back(selfIntersecting(mesh, meetings));
  }
  return result;
}

}  // namespace thicken
