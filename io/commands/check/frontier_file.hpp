// SPDX-License-Identifier: Apache-2.0
// The file of settings on the frontier of error against time, share/thaw/frontier.csv.
#pragma once
#include <string>
#include <vector>

#include "io/commands/check/frontier.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

/// Returns the path of the file that belongs to this program: in its folder (a build), or installed with it.
/// Empty if there is none.
std::string frontierFile();

/// Returns the points in the text of a file: a header, and a line for each point. Throws IoError with the
/// path and the line.
std::vector<FrontierPoint> parseFrontier(const std::string& path, const std::string& text);

/// Returns the points of the program's file, none without it. Throws IoError. Collective.
std::vector<FrontierPoint> frontierForAll(const Communicator& comm);

}  // namespace thaw
