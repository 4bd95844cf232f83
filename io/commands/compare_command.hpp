// SPDX-License-Identifier: Apache-2.0
// thaw compare A B: exit code 0 equal, 1 different, 3 not readable.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace thaw {

struct CompareArguments {
  std::string a, b;
  double tolerance = -1;  ///< < 0: bit by bit
  bool frames = false;    ///< compare all frames of two runs, too
  bool all = false;       ///< list each difference, not only a few of each kind
};

/// Declares the command; its arguments appear in `arguments`, which must outlive the parsing.
CLI::App* addCompareCommand(CLI::App& app, CompareArguments& arguments);

/// One process; prints to standard output, errors to standard error. Returns the exit code.
int compareCommand(const CompareArguments& arguments);

}  // namespace thaw
