// SPDX-License-Identifier: LGPL-2.1-or-later
//
// thicken_example INPUT OUTPUT MILLIMETRES: the library in one page. Another thread polls the run.
#include <thicken/thicken.h>

#include <chrono>
#include <cstdlib>
#include <future>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: thicken_example INPUT OUTPUT MILLIMETRES\n";
    return 2;
  }
  try {
    const thicken::TriangleMesh surface = thicken::readMesh(argv[1]);
    thicken::Options options;
    options.thickness = std::strtod(argv[3], nullptr);
    options.precision = thicken::storedPrecision(argv[2]);

    const thicken::RunContext context;  // copies of it are handles to the same run
    auto run = std::async(std::launch::async, [&] { return thicken::thicken(surface, options, context); });
    while (run.wait_for(std::chrono::milliseconds(500)) != std::future_status::ready)
      std::cerr << name(context.stage()) << ' ' << 100 * context.progress() << " %\n";
    const thicken::Solid solid = run.get();

    thicken::writeMesh(argv[2], solid.mesh);
    std::cout << toJson(solid.report);
  } catch (const thicken::Error& error) {
    std::cerr << name(error.code()) << ": " << error.what() << '\n';
    for (const thicken::Defect& defect : error.defects()) std::cerr << "  " << defect.sentence << '\n';
    return exitStatus(error.code());
  }
}
