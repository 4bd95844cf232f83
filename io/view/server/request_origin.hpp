// SPDX-License-Identifier: Apache-2.0
// Refusal of requests that pages of other sites cause.
#pragma once
#include <string>

#include "io/view/server/request.hpp"

namespace thaw {

/// Returns why a request is refused, or "". Its host must be a name of the loopback interface, which excludes
/// DNS rebinding; any port is valid, since `ssh -L` changes it. An origin must be that of the host, and a
/// browser must call the request one of the same origin, or of the address bar. A method other than GET needs
/// an origin.
std::string originProblem(const ViewRequest& request);

}  // namespace thaw
