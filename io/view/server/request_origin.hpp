// SPDX-License-Identifier: Apache-2.0
// Refusal of requests that pages of other sites cause.
#pragma once
#include <string>

#include "io/view/server/request.hpp"

namespace thaw {

/// Returns why a request is refused, or "". Its host must be a name of the loopback interface, which excludes
/// DNS rebinding. Any port is valid, since `ssh -L` changes it. An `Origin` header must match the host.
/// `Sec-Fetch-Site`, if present, must be `same-origin` or `none`. A method other than GET needs an `Origin`.
std::string originProblem(const ViewRequest& request);

}  // namespace thaw
