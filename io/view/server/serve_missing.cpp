// SPDX-License-Identifier: Apache-2.0
// Stands for the server in a program that is built without cpp-httplib.
#include "io/hdf5/io_error.hpp"
#include "io/view/server/serve.hpp"

namespace thaw {

std::string serverProblem() {
  return "this program is built without its server, cpp-httplib: scripts/view installs what is missing "
         "(Debian: libcpp-httplib-dev, nodejs, npm) and builds it";
}

void serveRun(const ServeOptions& options) { throw IoError(options.run.string(), serverProblem()); }

}  // namespace thaw
