// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/bridges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "mesh/half_edges.h"
#include "mesh/union_find.h"
#include "repair/crumbs.h"
#include "repair/near_rim.h"
#include "repair/open_rims.h"
#include "repair/sense.h"

namespace thicken::repairing {

using mesh::kNone;
using mesh::RimEdge;
using mesh::toSegment;

namespace {

constexpr double kLong = 3;      // gaps: the least length of a strip
constexpr double kFolded = 0.3;  // cosine: nearer to the inside of the sheet beside it no triangle leans
constexpr int kAhead = 2;        // rim edges ahead that the way across may end at

using Stop = std::uint32_t;  // a rim edge, for the corner that it begins at

struct Seed {
  double apart;
  Stop a, b;
};

// A strip that grows along two rims. Along the second it goes `sense` (±1) edges for one of the first.
struct Strip {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> edges;                   // of the rim, that it uses
  std::map<std::pair<VertexId, VertexId>, int> uses;  // its edges from one rim to the other
  std::array<double, 2> length{0, 0};
};

class Bridging {
 public:
  Bridging(Workpiece& piece, double distance, int threads)
      : piece_(piece),
        at_(piece.mesh.positions),
        distance_(distance),
        rim_(openRimsOf(piece, threads)),
        edges_(piece.mesh.positions.size(), piece.mesh.triangles, piece.present),
        additions_(piece, threads),
        used_(rim_.edges.size(), 0),
        failed_(rim_.edges.size(), 0),
        partOf_(partsOfPiece(piece)),
        joined_(piece.mesh.triangles.size()),
        turned_(piece.mesh.triangles.size(), 0) {
    place();
  }

  std::size_t run(const RunContext& context) {
    std::size_t strips = 0;
    for (const Seed& seed : seeds()) {
      context.throwIfCancelled();
      if (used_[seed.a] + used_[prev(seed.a)] == 2 || used_[seed.b] + used_[prev(seed.b)] == 2) continue;
      if (failed_[seed.a] == 0) strips += grow(seed);
    }
    return strips;
  }

 private:
  // --- the rims ---
  [[nodiscard]] std::uint32_t next(std::uint32_t e) const { return e + 1 == end_[e] ? begin_[e] : e + 1; }
  [[nodiscard]] std::uint32_t prev(std::uint32_t e) const { return e == begin_[e] ? end_[e] - 1 : e - 1; }
  [[nodiscard]] VertexId vertex(Stop s) const { return rim_.edges[s].from; }
  [[nodiscard]] const Vec3& point(Stop s) const { return at_[vertex(s)]; }
  [[nodiscard]] Stop step(Stop s, int way) const { return way > 0 ? next(s) : prev(s); }
  [[nodiscard]] std::uint32_t edgeOf(Stop s, int way) const { return way > 0 ? s : prev(s); }
  [[nodiscard]] Vec3 along(std::uint32_t e) const {
    return (at_[rim_.edges[e].to] - at_[rim_.edges[e].from]).normalized();
  }
  [[nodiscard]] Vec3 inward(std::uint32_t e) const {
    const RimEdge& edge = rim_.edges[e];
    Vec3 up = Vec3::Zero();
    for (const VertexId v : piece_.mesh.triangles[edge.triangle])
      if (v != edge.from && v != edge.to) up = at_[v] - at_[edge.from];
    const Vec3 u = along(e);
    return (up - up.dot(u) * u).normalized();
  }

  [[nodiscard]] Vec3 normal(std::uint32_t e) const { return inward(e).cross(along(e)); }

  void place() {
    begin_.resize(rim_.edges.size());
    end_.resize(rim_.edges.size());
    way_.assign(rim_.edges.size() + 1, 0);
    for (std::size_t i = 0; i < rim_.loops(); ++i)
      for (std::uint32_t e = rim_.loopStart[i]; e < rim_.loopStart[i + 1]; ++e) {
        begin_[e] = rim_.loopStart[i];
        end_[e] = rim_.loopStart[i + 1];
        way_[e + 1] = way_[e] + (at_[rim_.edges[e].to] - at_[rim_.edges[e].from]).norm();
      }
  }

  // Whether the way along the rim is not much longer than the way across.
  [[nodiscard]] bool isBend(Stop a, Stop b, double apart) const {
    if (begin_[a] != begin_[b]) return false;
    const double whole = way_[end_[a]] - way_[begin_[a]], part = std::abs(way_[a] - way_[b]);
    return std::min(part, whole - part) <= kFoldedBack * apart;
  }

  // --- where to begin ---
  [[nodiscard]] std::vector<Seed> seeds() const {
    std::vector<Triangle> segments;
    for (const RimEdge& e : rim_.edges) segments.push_back({e.from, e.to, e.to});
    const exact::BoxTree tree(at_, segments, 1);
    const Vec3 reach = Vec3::Constant(distance_);
    std::vector<Seed> all;
    for (Stop a = 0; a < rim_.edges.size(); ++a) {
      Seed best{distance_, kNone, kNone};
      for (const std::uint32_t e : tree.near(point(a) - reach, point(a) + reach)) {
        const Vec3 &p = at_[rim_.edges[e].from], &q = at_[rim_.edges[e].to];
        const double apart = toSegment(point(a), p, q);
        const Stop b = (point(a) - p).norm() <= (point(a) - q).norm() ? e : next(e);
        if (apart <= best.apart && apart > 0 && facesAcross(a, e) && !isBend(a, b, apart))
          best = {apart, a, b};
      }
      if (best.a != kNone) all.push_back(best);
    }
    std::sort(all.begin(), all.end(),
              [](const Seed& x, const Seed& y) { return std::tie(x.apart, x.a) < std::tie(y.apart, y.a); });
    return all;
  }

  // Whether the way from the edge to the stop leaves both sheets.
  [[nodiscard]] bool facesAcross(Stop a, std::uint32_t e) const {
    if (a == e || a == next(e)) return false;
    const Vec3 &p = at_[rim_.edges[e].from], &q = at_[rim_.edges[e].to];
    const Vec3 across = (point(a) - (p + mesh::shareOfSegment(point(a), p, q) * (q - p))).normalized();
    return inward(e).dot(across) < -kFolded &&
           std::min(inward(a).dot(-across), inward(prev(a)).dot(-across)) < -kFolded;
  }

  // --- a strip ---
  bool grow(const Seed& seed) {
    const int sense = along(seed.a).dot(along(seed.b)) > 0 ? 1 : -1;
    // Rims that run the same way are those of sheets of opposite sense; where they are not, it is a corner.
    if (normal(seed.a).dot(normal(seed.b)) * sense >= 0) return false;
    if (turnsOnItself(seed, sense) || usesOf({}, seed.a, seed.b) != 0) return false;
    Strip strip;
    ++count(strip, seed.a, seed.b);
    for (const int way : {1, -1}) growTo(strip, seed.a, seed.b, way, sense);
    if (!isLong(strip) || !additions_.fits(strip.triangles)) {
      for (const std::uint32_t e : strip.edges) {
        used_[e] = 0;
        failed_[e] = 1;
      }
      return false;
    }
    additions_.add(strip.triangles, RepairKind::kBridged);
    for (const auto& edge : strip.uses) strips_.insert(edge.first);
    noteJoin(seed, sense);
    return true;
  }

  // Against the mean width of its gap. A fan around one corner is no strip: it would hang on it in a point.
  [[nodiscard]] bool isLong(const Strip& strip) const {
    const auto [a, b] = strip.length;
    double area = 0;
    for (const Triangle& t : strip.triangles)
      area += (at_[t[1]] - at_[t[0]]).cross(at_[t[2]] - at_[t[0]]).norm() / 2;
    return std::min(a, b) > 0 && std::min(a, b) >= kLong * 2 * area / (a + b);
  }

  void growTo(Strip& strip, Stop a, Stop b, int way, int sense) {
    for (;;) {
      const std::array<std::pair<Stop, Stop>, 2> ahead{{{step(a, way), b}, {a, step(b, way * sense)}}};
      std::array<double, 2> cost{};
      for (int k = 0; k < 2; ++k) {
        const auto& [x, y] = ahead[k];
        cost[k] = (point(x) - point(y)).norm();
        if (!mayTake(strip, a, b, k, way, sense)) cost[k] = std::numeric_limits<double>::infinity();
      }
      const int k = cost[1] < cost[0] ? 1 : 0;
      if (!(cost[k] < std::numeric_limits<double>::infinity())) return;
      const bool closes = usesOf(strip, ahead[k].first, ahead[k].second) == 1;
      take(strip, a, b, k, way, sense);
      std::tie(a, b) = ahead[k];
      if (!closes) continue;
      for (const std::uint32_t e : {a, prev(a)})  // where the two rims are one it uses the edge between them
        if (isBetween(e, vertex(a), vertex(b))) use(strip, e);
      return;
    }
  }

  // Whether the strip may go on by the next edge of the first (k = 0) or the second rim.
  [[nodiscard]] bool mayTake(const Strip& strip, Stop a, Stop b, int k, int way, int sense) const {
    const int go = k == 0 ? way : way * sense;
    const Stop from = k == 0 ? a : b, to = step(from, go), other = k == 0 ? b : a;
    const std::uint32_t e = edgeOf(from, go);
    if (used_[e] != 0) return false;
    const VertexId v = vertex(to), w = vertex(other);
    if (v == w || usesOf(strip, to, other) > 1) return false;
    const bool closes = usesOf(strip, to, other) == 1;
    if (closes && isUsedRimEdge(to, other)) return false;
    if (!closes && gapAt(to, other, k == 0 ? way * sense : way) > distance_) return false;
    const Vec3 u = along(e), up = at_[w] - point(from);
    if ((up - up.dot(u) * u).normalized().dot(inward(e)) > kFolded) return false;
    return additions_.isFree({vertex(from), v, w});
  }

  // From stop `p` to the rim near `s`, `way` along it.
  [[nodiscard]] double gapAt(Stop p, Stop s, int way) const {
    Stop from = step(s, -way);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kAhead; ++i) {
      const Stop to = step(from, way);
      if (from != p && to != p) least = std::min(least, toSegment(point(p), point(from), point(to)));
      from = to;
    }
    return least;
  }

  void take(Strip& strip, Stop a, Stop b, int k, int way, int sense) {
    const int go = k == 0 ? way : way * sense;
    const Stop from = k == 0 ? a : b, to = step(from, go), other = k == 0 ? b : a;
    // The strip's triangles run against the first rim's edges.
    const VertexId x = vertex(k == 0 ? to : other), y = vertex(from), z = vertex(k == 0 ? other : to);
    strip.triangles.push_back(way > 0 ? Triangle{x, y, z} : Triangle{x, z, y});
    use(strip, edgeOf(from, go));
    strip.length[k] += (point(to) - point(from)).norm();
    ++count(strip, to, other);
  }

  // --- edges ---
  void use(Strip& strip, std::uint32_t e) {
    used_[e] = 1;
    strip.edges.push_back(e);
  }
  [[nodiscard]] int& count(Strip& strip, Stop a, Stop b) const {
    return strip.uses[std::minmax(vertex(a), vertex(b))];
  }
  // The triangles at an edge: of the surface, and 1 for those of the strip.
  [[nodiscard]] int usesOf(const Strip& strip, Stop a, Stop b) const {
    const auto found = strip.uses.find(std::minmax(vertex(a), vertex(b)));
    const VertexId v = vertex(a), w = vertex(b);
    return static_cast<int>(edges_.uses(v, w).size() + edges_.uses(w, v).size() +
                            strips_.count(std::minmax(v, w))) +
           (found == strip.uses.end() ? 0 : found->second);
  }
  [[nodiscard]] bool isBetween(std::uint32_t e, VertexId v, VertexId w) const {
    const RimEdge& edge = rim_.edges[e];
    return (edge.from == v && edge.to == w) || (edge.from == w && edge.to == v);
  }
  [[nodiscard]] bool isUsedRimEdge(Stop a, Stop b) const {
    for (const std::uint32_t e : {a, prev(a)})
      if (isBetween(e, vertex(a), vertex(b))) return used_[e] != 0;
    return false;
  }

  // --- senses ---
  [[nodiscard]] std::uint32_t partAt(Stop s) const { return partOf_[rim_.edges[s].triangle]; }
  // Whether one part would have to be turned over against itself.
  [[nodiscard]] bool turnsOnItself(const Seed& seed, int sense) {
    const std::uint32_t a = partAt(seed.a), b = partAt(seed.b);
    return joined_.root(a) == joined_.root(b) && (turned_[a] ^ turned_[b]) != (sense > 0 ? 1 : 0);
  }
  void noteJoin(const Seed& seed, int sense) {
    const std::uint32_t a = partAt(seed.a), b = partAt(seed.b);
    if (joined_.root(a) == joined_.root(b)) return;
    if ((turned_[a] ^ turned_[b]) != (sense > 0 ? 1 : 0)) {
      const std::uint32_t group = joined_.root(b);
      for (std::uint32_t p = 0; p < turned_.size(); ++p)
        if (joined_.root(p) == group) turned_[p] ^= 1;
    }
    joined_.join(a, b);
  }

  Workpiece& piece_;
  const std::vector<Vec3>& at_;
  double distance_;
  mesh::Rim rim_;
  mesh::HalfEdges edges_;
  Additions additions_;
  std::vector<std::uint8_t> used_;    // per rim edge: a strip is there
  std::vector<std::uint8_t> failed_;  // per rim edge: a strip along it was given up; another would be, too
  std::set<std::pair<VertexId, VertexId>> strips_;  // edges of earlier strips from one rim to the other
  std::vector<std::uint32_t> begin_, end_;          // per rim edge: those of its loop
  std::vector<double> way_;                         // mm along all rims up to an edge
  std::vector<std::uint32_t> partOf_;               // per triangle
  mesh::UnionFind joined_;                          // parts that strips join
  std::vector<std::uint8_t> turned_;  // per part: of the other sense than the first of those joined
};

}  // namespace

void bridgeGaps(Workpiece& piece, double distance, AddedFacts& facts, const RunContext& context,
                int threads) {
  const std::size_t strips = Bridging(piece, distance, threads).run(context);
  facts.strips += strips;
  if (strips > 0) makeSenseConsistent(piece);
}

}  // namespace thicken::repairing
