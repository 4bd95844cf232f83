// SPDX-License-Identifier: Apache-2.0
#include "io/view/server/serve.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "io/hdf5/io_error.hpp"
#include "io/view/server/open_browser.hpp"
#include "io/view/server/routes.hpp"
#include "io/view/server/token.hpp"

namespace thaw {
namespace {

constexpr const char* loopback = "127.0.0.1";
constexpr int usualPort = 8573;

std::optional<std::string> headerOf(const httplib::Request& request, const char* name) {
  if (!request.has_header(name)) return std::nullopt;
  // A second header of the same name could contradict the first.
  return request.get_header_value_count(name) == 1 ? request.get_header_value(name) : std::string("?");
}

void handle(ViewState& state, const httplib::Request& from, httplib::Response& to) {
  ViewRequest request{from.method,
                      from.path,
                      {from.params.begin(), from.params.end()},
                      headerOf(from, "Host"),
                      headerOf(from, "Origin"),
                      headerOf(from, "Sec-Fetch-Site")};
  ViewReply reply = answer(state, request);
  to.status = reply.status;
  if (!reply.location.empty()) to.set_header("Location", reply.location);
  to.set_content(std::move(reply.body), reply.type.c_str());
}

void setUp(httplib::Server& server, ViewState& state) {
  httplib::Headers headers;
  for (const auto& header : replyHeaders()) headers.insert(header);
  server.set_default_headers(headers);
  server.set_payload_max_length(4096);
  server.set_read_timeout(10);
  server.set_tcp_nodelay(true);
  // SO_REUSEPORT, the default, would let two servers share a port.
  server.set_socket_options([](int socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  const auto handler = [&state](const httplib::Request& from, httplib::Response& to) {
    handle(state, from, to);
  };
  server.Get(".*", handler);
  server.Post(".*", handler);
}

int bind(httplib::Server& server, int port) {
  if (port > 0) {
    if (server.bind_to_port(loopback, port)) return port;
    throw IoError(fmt::format("{}:{}", loopback, port),
                  "in use or not permitted; choose another with --port");
  }
  if (server.bind_to_port(loopback, usualPort)) return usualPort;
  const int any = server.bind_to_any_port(loopback);
  if (any <= 0) throw IoError(loopback, "no port is free");
  return any;
}

void printAddress(const ServeOptions& options, const ViewState& state, int port) {
  fmt::print("{}: http://{}:{}/{}/\n", options.run.string(), loopback, port, state.token);
  if (std::getenv("SSH_CONNECTION"))
    fmt::print("from your own machine: ssh -L {0}:{1}:{0} HOST, then open the same address there\n", port,
               loopback);
  fmt::print("Ctrl-C ends the view; a run goes on\n");
  std::fflush(stdout);
}

}  // namespace

std::string serverProblem() { return {}; }

void serveRun(const ServeOptions& options) {
  ViewState state{options.run, newToken()};
  httplib::Server server;
  setUp(server, state);
  const int port = bind(server, options.port);
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &ends, nullptr);  // before the first thread, which inherits it
  std::signal(SIGPIPE, SIG_IGN);               // a page that closes early
  std::thread waiting([&] {
    int signal = 0;
    sigwait(&ends, &signal);
    server.stop();
  });
  printAddress(options, state, port);
  if (options.open && hasDesktop()) {
    const std::lock_guard lock(state.mutex);
    state.once = newToken();
    openBrowser(fmt::format("http://{}:{}/open/{}", loopback, port, state.once));
  }
  server.listen_after_bind();
  pthread_kill(waiting.native_handle(), SIGTERM);
  waiting.join();
}

}  // namespace thaw
