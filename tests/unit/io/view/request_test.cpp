// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>

#include "io/view/server/request_origin.hpp"
#include "io/view/server/token.hpp"

using namespace thaw;

namespace {

TEST(ViewToken, TokensHave128BitsAndDiffer) {
  std::set<std::string> tokens;
  for (int k = 0; k < 100; k++) tokens.insert(newToken());
  EXPECT_EQ(tokens.size(), 100u);
  for (const std::string& token : tokens) {
    EXPECT_EQ(token.size(), 32u);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), token.npos) << token;
  }
}

TEST(ViewToken, OnlyTheSameTokenIsAccepted) {
  const std::string token = newToken();
  EXPECT_TRUE(sameToken(token, token));
  for (std::size_t k = 0; k < token.size(); k++) {
    std::string other = token;
    other[k] = other[k] == '0' ? '1' : '0';
    EXPECT_FALSE(sameToken(other, token)) << other;
  }
  EXPECT_FALSE(sameToken("", token));
  EXPECT_FALSE(sameToken(token.substr(0, 31), token));
  EXPECT_FALSE(sameToken(token + token, token));
  EXPECT_FALSE(sameToken(token + "x", token));
  EXPECT_FALSE(sameToken("", ""));
}

ViewRequest requestOf(const std::string& host) {
  ViewRequest request;
  request.method = "GET";
  request.host = host;
  return request;
}

TEST(ViewOrigin, LoopbackHostsAreAcceptedOnAnyPort) {
  // ssh -L changes the port
  for (const char* host : {"127.0.0.1:8573", "localhost:1", "[::1]:65535", "127.0.0.1", "localhost"})
    EXPECT_EQ(originProblem(requestOf(host)), "") << host;
}

TEST(ViewOrigin, OtherHostsAreRefused) {
  for (const char* host :
       {"", "example.org", "example.org:8573", "127.0.0.1.example.org:8573", "localhost.example.org",
        "127.0.0.1:", "127.0.0.1:80x", "127.0.0.1:8573@example.org", "127.0.0.2", "0.0.0.0:8573", "?"})
    EXPECT_NE(originProblem(requestOf(host)), "") << host;
  EXPECT_NE(originProblem({"GET", "/", {}, {}, {}, {}}), "") << "no host";
}

TEST(ViewOrigin, OtherOriginsAreRefused) {
  ViewRequest request = requestOf("127.0.0.1:8573");
  request.origin = "http://127.0.0.1:8573";
  EXPECT_EQ(originProblem(request), "");
  for (const char* origin :
       {"null", "", "http://example.org", "http://127.0.0.1:9000", "https://127.0.0.1:8573",
        "http://localhost:8573", "http://127.0.0.1:8573.example.org"}) {
    request.origin = origin;
    EXPECT_NE(originProblem(request), "") << origin;
  }
}

TEST(ViewOrigin, RequestsOfOtherSitesAreRefused) {
  ViewRequest request = requestOf("127.0.0.1:8573");
  for (const char* site : {"same-origin", "none"}) {
    request.fetchSite = site;
    EXPECT_EQ(originProblem(request), "") << site;
  }
  for (const char* site : {"cross-site", "same-site", "", "?"}) {
    request.fetchSite = site;
    EXPECT_NE(originProblem(request), "") << site;
  }
}

TEST(ViewOrigin, RequestsThatWriteNeedAnOrigin) {
  ViewRequest request = requestOf("127.0.0.1:8573");
  request.method = "POST";
  EXPECT_NE(originProblem(request), "");
  request.origin = "http://127.0.0.1:8573";
  EXPECT_EQ(originProblem(request), "");
}

}  // namespace
