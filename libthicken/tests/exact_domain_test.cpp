// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The contract of the exact predicates: which coordinates they are exact for, in which arithmetic, and that
// nothing is called proved outside of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "exact/domain.h"

#ifdef __SSE2__
#include <immintrin.h>
#endif

#include "check/audit.h"
#include "exact/predicates.h"
#include "exact_oracle.h"
#include "plain_shapes.h"
#include "scratch_folder.h"
#include "thicken/check.h"
#include "thicken/io.h"
#include "thicken/thicken.h"

namespace thicken {

using checking::AuditResult;

namespace {

using oracle::Rational;

constexpr double kSubnormal = std::numeric_limits<double>::denorm_min();

AuditResult audited(const TriangleMesh& solid, const TriangleMesh& surface, Side side = Side::kNegative) {
  return checking::audit(solid, surface, side, {}, 1);
}

class Magnitudes {
 public:
  explicit Magnitudes(unsigned seed) : random_(seed) {}

  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  // ±2^k with k from `low` to `high`, and random digits.
  double ofPower(int low, int high) {
    return std::ldexp(uniform(0.5, 1), integer(low, high)) * (integer(0, 1) ? 1 : -1);
  }
  Vec3 pointOfPower(int low, int high) {
    return {ofPower(low, high), ofPower(low, high), ofPower(low, high)};
  }

 private:
  std::mt19937_64 random_;
};

TEST(ExactDomain, EndsWhereItsNumbersSay) {
  EXPECT_TRUE(exact::inDomain(Vec3(0, -0.0, 1)));
  EXPECT_TRUE(exact::inDomain(Vec3(0x1p-250, -0x1p-250, 0)));
  EXPECT_FALSE(exact::inDomain(Vec3(0, std::nextafter(0x1p-250, 0), 0)));
  EXPECT_FALSE(exact::inDomain(Vec3(0, 0, -kSubnormal)));
  constexpr double kMost = std::numeric_limits<float>::max();
  EXPECT_TRUE(exact::inDomain(Vec3(kMost, -kMost, 0)));
  EXPECT_FALSE(exact::inDomain(Vec3(std::nextafter(kMost, 1e300), 0, 0)));
  EXPECT_FALSE(exact::inDomain(Vec3(0, std::numeric_limits<double>::infinity(), 0)));
  EXPECT_FALSE(exact::inDomain(Vec3(0, std::numeric_limits<double>::quiet_NaN(), 0)));
}

// Four points of mixed magnitudes; in part moved into one plane or close to it.
TEST(ExactDomain, PredicatesAgreeWithRationalsForEveryMagnitudeInIt) {
  Magnitudes magnitudes(1);
  int coplanar = 0;
  for (int i = 0; i < 4000; ++i) {
    const bool mixed = i % 2 == 0;
    const int low = mixed ? -248 : magnitudes.integer(-248, 120), high = mixed ? 126 : low + 3;
    Vec3 p[4];
    for (Vec3& q : p) q = magnitudes.pointOfPower(low, high);
    if (i % 3 == 0) p[3] = p[2];
    if (i % 3 == 1) p[3] = p[1] / 2 + p[2] / 2;
    if (!std::all_of(p, p + 4, exact::inDomain)) continue;
    const int expected = oracle::orientation(p[0], p[1], p[2], p[3]);
    coplanar += expected == 0;
    ASSERT_EQ(exact::orientation(p[0], p[1], p[2], p[3]), expected) << i;
    ASSERT_EQ(exact::orientation(p[3], p[2], p[1], p[0]), expected) << i;
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_EQ(exact::orientation2(p[1], p[2], p[3], axis), oracle::orientation2(p[1], p[2], p[3], axis));
  }
  EXPECT_GT(coplanar, 1000);
}

// Why there is a domain: a product that underflows to 0 makes a triangle look as if it had no area.
TEST(ExactDomain, PredicatesAreWrongBelowIt) {
  const Vec3 a(0, 0, 0), b(1e-170, 0, 0), c(0, 1e-170, 0);
  EXPECT_NE(exact::orientation2(a, b, c, 2), oracle::orientation2(a, b, c, 2));
}

TEST(ExactDomain, CheckRefusesWhatIsTooSmallAndSaysWhere) {
  for (const double tiny : {kSubnormal, 1e-310, -1e-300, 1e-100}) {
    TriangleMesh mesh = shapes::sheet(3, 3);
    mesh.positions[5].z() = tiny;
    const CheckResult result = check(mesh);
    ASSERT_EQ(result.defects.size(), 1u) << tiny;
    const Defect& d = result.defects.front();
    EXPECT_EQ(d.code, ErrorCode::kNotFinite);
    EXPECT_EQ(d.vertices, std::vector<VertexId>{5});
    EXPECT_EQ(d.place, mesh.positions[5]);
    EXPECT_NE(d.sentence.find("vertex 5"), std::string::npos) << d.sentence;
    EXPECT_NE(d.sentence.find("too small"), std::string::npos) << d.sentence;
    EXPECT_NE(d.sentence.find("make it 0"), std::string::npos) << "what helps: " << d.sentence;
  }
}

TEST(ExactDomain, TheAuditRefusesWhatIsTooSmall) {
  const TriangleMesh sheet = shapes::flatSheet(3, 3, 0);
  TriangleMesh solid = shapes::slab(sheet, 1);
  ASSERT_TRUE(audited(solid, sheet).facts.passed());
  TriangleMesh noisy = sheet;
  solid.positions[5].z() = noisy.positions[5].z() = 1e-300;
  const AuditResult result = audited(solid, noisy);
  EXPECT_FALSE(result.facts.passed());
  ASSERT_FALSE(result.defects.empty());
  EXPECT_EQ(result.defects.front().vertices, std::vector<VertexId>{5});
}

class NoiseInAFile : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

INSTANTIATE_TEST_SUITE_P(
    Formats, NoiseInAFile,
    ::testing::Values(
        std::pair{"a.obj", "v 0 0 0\nv 4 0 1e-300\nv 4 4 4.9e-324\nv 0 4 -3e-310\nf 1 2 3\nf 1 3 4\n"},
        std::pair{"a.ply",
                  "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                  "property double z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
                  "0 0 0\n4 0 1e-300\n4 4 4.9e-324\n0 4 -3e-310\n3 0 1 2\n3 0 2 3\n"}));

TEST_P(NoiseInAFile, IsNamedAndGoesBySinglePrecision) {
  const test::ScratchFolder folder;
  const TriangleMesh mesh = readMesh(folder.put(GetParam().first, GetParam().second));
  EXPECT_EQ(mesh.positions[2].z(), kSubnormal) << "the reader changes nothing";
  Options options;
  options.thickness = 1;
  try {
    (void)thicken(mesh, options);
    FAIL() << "accepted";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kNotFinite);
    EXPECT_NE(std::string(e.what()).find("vertex 1"), std::string::npos) << e.what();
    ASSERT_FALSE(e.defects().empty());
    EXPECT_EQ(e.defects().front().count, 3u);
  }
  options.precision = Precision::kSingle;  // as for an .stl
  EXPECT_TRUE(thicken(mesh, options).report.audit.intersectionFree);
}

// --- the arithmetic of the process

ErrorCode codeOf(const TriangleMesh& mesh) {
  try {
    (void)check(mesh);
  } catch (const Error& e) {
    return e.code();
  }
  return ErrorCode::kInternal;
}

TEST(ExactArithmetic, IsWhatTheLibraryWasBuiltWith) {
  EXPECT_NO_THROW(exact::requireExactArithmetic()) << "contraction is not off, or the mode is another";
}

TEST(ExactArithmetic, ProvesNothingWhereNumbersAreRoundedOtherwise) {
  const TriangleMesh sheet = shapes::flatSheet(2, 2, 0), solid = shapes::slab(sheet, 1);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const ErrorCode checked = codeOf(sheet);
    ErrorCode ofAudit = ErrorCode::kInternal;
    try {
      (void)audited(solid, sheet);
    } catch (const Error& e) {
      ofAudit = e.code();
    }
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(checked, ErrorCode::kArithmetic) << mode;
    EXPECT_EQ(ofAudit, ErrorCode::kArithmetic) << mode;
  }
  EXPECT_TRUE(check(sheet).valid());
}

#ifdef __SSE2__
TEST(ExactArithmetic, ProvesNothingWhereSubnormalNumbersBecomeZero) {
  constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
  const TriangleMesh sheet = shapes::flatSheet(2, 2, 0);
  const unsigned usual = _mm_getcsr();
  for (const unsigned mode : {kFlushToZero, kDenormalsAreZero}) {
    _mm_setcsr(usual | mode);
    const ErrorCode code = codeOf(sheet);
    _mm_setcsr(usual);
    EXPECT_EQ(code, ErrorCode::kArithmetic) << mode;
  }
}
#endif

// --- random coordinates of every magnitude, judged by rationals

std::set<ErrorCode> codesOf(const std::vector<Defect>& defects) {
  std::set<ErrorCode> codes;
  for (const Defect& d : defects) codes.insert(d.code);
  return codes;
}

bool hasNoArea(const TriangleMesh& mesh, const Triangle& t) {
  for (int axis = 0; axis < 3; ++axis)
    if (oracle::orientation2(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]], axis) != 0)
      return false;
  return true;
}

bool boxesMeet(const TriangleMesh& mesh, const Triangle& s, const Triangle& t) {
  for (int k = 0; k < 3; ++k) {
    const auto range = [&](const Triangle& of) {
      const auto& p = mesh.positions;
      return std::minmax({p[of[0]][k], p[of[1]][k], p[of[2]][k]});
    };
    const auto a = range(s), b = range(t);
    if (a.second < b.first || b.second < a.first) return false;
  }
  return true;
}

bool meetsItself(const TriangleMesh& mesh) {
  for (std::size_t s = 0; s < mesh.triangles.size(); ++s)
    for (std::size_t t = s + 1; t < mesh.triangles.size(); ++t)
      if (boxesMeet(mesh, mesh.triangles[s], mesh.triangles[t]) &&
          oracle::expectedMeet(mesh.positions, mesh.triangles[s], mesh.triangles[t]))
        return true;
  return false;
}

bool isClosed(const TriangleMesh& mesh) {
  std::set<std::pair<VertexId, VertexId>> edges;
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      if (!edges.emplace(t[k], t[(k + 1) % 3]).second) return false;
  return std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
    return edges.count({e.second, e.first}) == 1;
  });
}

Rational sixfoldVolume(const TriangleMesh& mesh) {
  Rational sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += oracle::dot(oracle::cross(oracle::point(mesh.positions[a]), oracle::point(mesh.positions[b])),
                       oracle::point(mesh.positions[c]));
  return sum;
}

// A fan, two triangles at an edge, or one triangle, of coordinates that are 0, of one size, or of any.
TriangleMesh randomSurface(Magnitudes& m) {
  constexpr int kLeastPower = -1063, kMostPower = 997;  // 1e-320 to 1e300
  TriangleMesh mesh;
  switch (m.integer(0, 2)) {
    case 0:
      mesh.triangles = {{0, 1, 2}};
      break;
    case 1:
      mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
      break;
    default:
      mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
      break;
  }
  const int kind = m.integer(0, 9);
  const int size = kind < 6 ? m.integer(-30, 30) : m.integer(-300, 140);
  for (VertexId v = 0; v < mesh.triangles.size() + 2; ++v) {
    // Around an ellipse, in a plane that bends a little: mostly a valid fan, of whatever size.
    const double at = 1.1 * v;
    Vec3 p(v == 0 ? 0 : std::cos(at), v == 0 ? 0 : std::sin(at), v == 0 ? 0 : m.uniform(-0.2, 0.2));
    p *= std::ldexp(1.0, size);
    for (int k = 0; k < 3; ++k) {
      if (kind == 9) p[k] = m.uniform(-1, 1);  // crosses itself
      if (kind == 8) p[k] = m.ofPower(kLeastPower, kMostPower);
      if (kind == 7 && m.integer(0, 3) == 0) p[k] = m.ofPower(-240, 120);
      if (kind == 5 && m.integer(0, 5) == 0) p[k] = m.ofPower(kLeastPower, -260);  // noise
      if (m.integer(0, 9) == 0) p[k] = 0;
    }
    mesh.positions.push_back(p);
  }
  return mesh;
}

class EveryMagnitudeSlow : public ::testing::Test {
 protected:
  // Whether `mesh` is valid by rationals, and that check() says the same.
  bool judgedValid(const TriangleMesh& mesh) {
    const CheckResult result = check(mesh);
    const bool inside = std::all_of(mesh.positions.begin(), mesh.positions.end(), exact::inDomain);
    if (!inside) {
      EXPECT_EQ(codesOf(result.defects).count(ErrorCode::kNotFinite), 1u);
      ++outside_;
      return false;
    }
    const bool flat = std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                                  [&](const Triangle& t) { return hasNoArea(mesh, t); });
    EXPECT_EQ(codesOf(result.defects).count(ErrorCode::kDegenerate), flat ? 1u : 0u);
    if (flat) return false;
    const bool meets = meetsItself(mesh);
    EXPECT_EQ(codesOf(result.defects).count(ErrorCode::kSelfIntersecting), meets ? 1u : 0u);
    meeting_ += meets;
    return result.valid();
  }

  // A solid is what it is said to be, or there is none and an Error says why.
  void thickenAndJudge(const TriangleMesh& surface, const Options& options) {
    Solid made;
    try {
      made = thicken(surface, options);
    } catch (const Error& e) {
      EXPECT_NE(e.code(), ErrorCode::kInternal) << e.what();
      ++refused_;
      return;
    }
    const TriangleMesh solid = weld(made.mesh);
    if (solid.triangles.size() > kMostJudged) return;
    ++solids_;
    EXPECT_TRUE(isClosed(solid));
    EXPECT_FALSE(meetsItself(solid));
    EXPECT_GT(sixfoldVolume(solid), 0);
    for (const Triangle& t : solid.triangles) EXPECT_FALSE(hasNoArea(solid, t));
    EXPECT_TRUE(audited(made.mesh, surface, options.side).facts.passed());
  }

  static constexpr std::size_t kMostJudged = 600;
  int outside_ = 0, meeting_ = 0, refused_ = 0, solids_ = 0;
};

TEST_F(EveryMagnitudeSlow, IsThickenedToAValidSolidOrRefused) {
  Magnitudes magnitudes(2);
  for (int i = 0; i < 400; ++i) {
    const TriangleMesh surface = weld(randomSurface(magnitudes));
    const bool valid = judgedValid(surface);
    Options options;
    options.method = i % 80 == 0 ? Method::kAuto : Method::kSweep;
    options.side = static_cast<Side>(i % 3);
    double size = 0;
    for (const Vec3& p : surface.positions) size = std::max(size, p.cwiseAbs().maxCoeff());
    options.thickness = size * magnitudes.uniform(0.01, 0.3);
    if (i % 20 == 19) options.thickness = std::abs(magnitudes.ofPower(-1063, 997));
    if (!(options.thickness > 0) || !std::isfinite(options.thickness)) continue;
    if (valid) {
      thickenAndJudge(surface, options);
    } else {
      EXPECT_THROW((void)thicken(surface, options), Error);
    }
    ASSERT_FALSE(HasFailure()) << "surface " << i;
  }
  EXPECT_GT(outside_, 40);
  EXPECT_GT(meeting_, 5);
  EXPECT_GT(refused_, 20);
  EXPECT_GT(solids_, 100);
}

}  // namespace
}  // namespace thicken
