// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Writes what each stage of the reconstruction has made, for pictures of it.
//
// usage: thicken_stages SURFACE THICKNESS CELL FOLDER
//
// nodes.txt    x y z and a letter for each node that was evaluated: inside, far, before S, rim
// cells.txt    lowest corner of each cell that the carrier's rim passes, after a line with the cell's width
// faces.ply    the boundary before shape optimisation, and faces.txt: a line a triangle with its region
// shaped.ply   the boundary after it, of the same triangles
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "mesh/float_lattice.h"
#include "reconstruct/assembly.h"
#include "reconstruct/contourer.h"
#include "reconstruct/deep_walls.h"
#include "reconstruct/shape.h"
#include "thicken/check.h"
#include "thicken/error.h"
#include "thicken/io.h"

namespace thicken {

using reconstruct::Assembly;
using reconstruct::Contour;
using reconstruct::Contourer;

namespace {

void writeNodes(const Contourer& contourer, const std::filesystem::path& file) {
  std::ofstream out(file);
  contourer.field().forEach([&](const Vec3& p, const field::NodeField::Sample& sample) {
    constexpr char kLetter[] = {'i', 'f', 'b', 'r'};
    out << fmt::format("{} {} {} {}\n", p.x(), p.y(), p.z(), kLetter[static_cast<int>(sample.standing)]);
  });
}

void writeRimCells(const Contour& contour, const field::UniformGrid& grid,
                   const std::filesystem::path& file) {
  std::ofstream out(file);
  out << fmt::format("{}\n", grid.width());
  for (const contour::RimWay& way : contour.ways)
    for (const contour::RimVisit& visit : way) {
      const Vec3 p = grid.node(visit.cell);
      out << fmt::format("{} {} {}\n", p.x(), p.y(), p.z());
    }
}

void writeFaces(Assembly assembly, std::span<const Vec3> shaped, const std::filesystem::path& folder) {
  std::ofstream regions(folder / "faces.txt");
  for (const Region region : assembly.region) regions << static_cast<int>(region) << '\n';
  writeMesh((folder / "faces.ply").string(), assembly.mesh);
  for (std::size_t i = 0; i < shaped.size(); ++i)
    assembly.mesh.positions[assembly.carrierVertices + i] = mesh::roundToFloat(shaped[i]);
  writeMesh((folder / "shaped.ply").string(), assembly.mesh);
}

void run(const std::string& input, double thickness, double cell, const std::filesystem::path& folder) {
  const TriangleMesh surface = weld(readMesh(input));
  const ClosestPointTree tree(surface);
  const RunContext context;
  constexpr int kAllThreads = 0, kRounds = 15;
  const Options options;
  job::Stopwatch watch;
  const job::Job job{surface, tree, job::Thickness(thickness), options, context, kAllThreads, watch};
  const sweep::SweepResult swept = sweep::sweep(job, sweep::Polish::kNo);
  std::vector<std::uint8_t> keep;
  for (const Region region : swept.region) keep.push_back(region != Region::kShell);
  reconstruct::DeepWalls walls(job, swept);
  walls.fit(keep);
  const reconstruct::Carrier carrier = reconstruct::makeCarrier(
      swept, walls.positions(), walls.up(), surface.triangles.size(), keep, cell, nullptr, kAllThreads);
  const field::Membership membership(carrier.mesh, tree, surface.triangles.size(), job.thickness);
  Contourer contourer(job, cell, {}, nullptr);
  Contour contour = contourer.contour(carrier, membership, {});
  const Assembly assembly =
      reconstruct::assemble(carrier, contour.dual, contour.crossings, contour.ways, kAllThreads);
  const std::vector<Vec3> shaped = reconstruct::shapedPositions(
      assembly, contour.dual, contour.crossings, membership, cell, kRounds, context, kAllThreads);
  std::filesystem::create_directories(folder);
  writeNodes(contourer, folder / "nodes.txt");
  writeRimCells(contour, contourer.grid(), folder / "cells.txt");
  writeFaces(assembly, shaped, folder);
}

}  // namespace
}  // namespace thicken

int main(int count, char** word) {
  if (count != 5) {
    std::cerr << "usage: thicken_stages SURFACE THICKNESS CELL FOLDER\n";
    return 2;
  }
  try {
    thicken::run(word[1], std::atof(word[2]), std::atof(word[3]), word[4]);
  } catch (const thicken::Error& error) {
    std::cerr << "thicken_stages: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
