// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The program `thicken`: reads the command line, runs the command, and turns what went wrong into
// an exit status and one last line on stderr.
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "platform/memory.h"
#include "platform/process.h"
#include "program/arguments.h"
#include "program/interrupt.h"
#include "program/messages.h"
#include "program/run.h"

namespace {

using namespace thicken;
using namespace thicken::program;

int run(const std::vector<std::string>& words, bool& quiet) {
  std::vector<const char*> texts;
  for (const std::string& word : words) texts.push_back(word.c_str());
  const Request request = readArguments(static_cast<int>(texts.size()), texts.data());
  if (!request.arguments) {
    std::cout << request.answer;
    return EXIT_SUCCESS;
  }
  quiet = request.arguments->quiet;
  RunContext context;
  context.setMemoryLimit(request.arguments->memoryLimit);
  context.setTimeLimit(request.arguments->timeLimit);
  request.arguments->limitGiven ? platform::returnFreedArrays(request.arguments->memoryLimit)
                                : platform::keepFreedMemory();
  cancelOnInterrupt(context);
  switch (request.arguments->command) {
    case Command::kCheck:
      runCheck(*request.arguments, context);
      break;
    case Command::kTrim:
      runTrim(*request.arguments, context);
      break;
    case Command::kThicken:
      runThicken(*request.arguments, context);
      break;
  }
  return EXIT_SUCCESS;
}

int fail(const Error& error, bool quiet) {
  printError(error, quiet);
  return exitStatus(error.code());
}

}  // namespace

int main(int argc, char** argv) {
  bool quiet = false;
  try {
    return run(platform::commandLine(argc, argv), quiet);
  } catch (const Error& error) {
    return fail(error, quiet);
  } catch (const std::bad_alloc&) {
    return fail(Error(ErrorCode::kMemoryLimit, "the machine ran out of memory"), quiet);
  } catch (const std::exception&) {
    return fail(brokenRule(), quiet);
  }
}
