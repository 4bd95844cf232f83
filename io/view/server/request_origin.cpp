// SPDX-License-Identifier: Apache-2.0
#include "io/view/server/request_origin.hpp"

#include <algorithm>

namespace thaw {
namespace {

/// Returns whether a header is "localhost", "127.0.0.1" or "[::1]", with or without a port.
bool isLoopback(const std::string& host) {
  for (const std::string name : {"127.0.0.1", "localhost", "[::1]"}) {
    if (!host.starts_with(name)) continue;
    const std::string port = host.substr(name.size());
    const bool digits = port.size() > 1 && port.size() <= 6 && port[0] == ':' &&
                        std::all_of(port.begin() + 1, port.end(),
                                    [](char c) { return c >= '0' && c <= '9'; });
    if (port.empty() || digits) return true;
  }
  return false;
}

}  // namespace

std::string originProblem(const ViewRequest& request) {
  if (!request.host || !isLoopback(*request.host))
    return "the request names another host than 127.0.0.1 or localhost";
  if (request.origin && *request.origin != "http://" + *request.host)
    return "the request comes from a page of another site";
  if (request.fetchSite && *request.fetchSite != "same-origin" && *request.fetchSite != "none")
    return "the request comes from a page of another site: paste the address into the address bar";
  if (request.method != "GET" && !request.origin) return "the request has no origin";
  return {};
}

}  // namespace thaw
