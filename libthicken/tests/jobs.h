// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A job with what it refers to.
#pragma once

#include <map>
#include <utility>

#include "job/job.h"

namespace thicken {

/// A constant thickness that lives as long as the tests.
inline const job::Thickness& thick(double r) {
  static std::map<double, job::Thickness> all;
  return all.try_emplace(r, r).first->second;
}

struct OwnJob {
  TriangleMesh surface;
  Options options;
  RunContext context;
  ClosestPointTree tree{surface};
  job::Stopwatch watch;
  job::Job job{surface, tree, job::Thickness(options.thickness), options, context, 1, watch};

  OwnJob(TriangleMesh s, Options asked) : surface(std::move(s)), options(std::move(asked)) {}
  OwnJob(TriangleMesh s, double r, Side side = Side::kNegative) : OwnJob(std::move(s), optionsOf(r, side)) {}
  OwnJob(const OwnJob&) = delete;

 private:
  static Options optionsOf(double r, Side side) {
    Options o;
    o.thickness = r;
    o.side = side;
    return o;
  }
};

}  // namespace thicken
