// SPDX-License-Identifier: Apache-2.0
// Requests and replies of `thaw view`, independent of the HTTP library.
#pragma once
#include <map>
#include <optional>
#include <string>

namespace thaw {

struct ViewRequest {
  std::string method;                                  ///< "GET", "POST", ...
  std::string path;                                    ///< decoded, without the query: "/TOKEN/api/run"
  std::map<std::string, std::string> query;            ///< decoded
  std::optional<std::string> host, origin, fetchSite;  ///< headers; empty where a request has none
};

struct ViewReply {
  int status = 200;
  std::string type = "text/plain; charset=utf-8", body;
  std::string location = {};  ///< target of a redirection; empty: none
};

}  // namespace thaw
