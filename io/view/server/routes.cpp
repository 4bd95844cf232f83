// SPDX-License-Identifier: Apache-2.0
#include "io/view/server/routes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/hdf5/io_error.hpp"
#include "io/run/run_lock.hpp"
#include "io/view/frames/frame_list.hpp"
#include "io/view/frames/frame_packet.hpp"
#include "io/view/frames/mesh_packet.hpp"
#include "io/view/frames/point_details.hpp"
#include "io/view/run/log_rows.hpp"
#include "io/view/run/run_files.hpp"
#include "io/view/run/run_status.hpp"
#include "io/view/run/scene_view.hpp"
#include "io/view/run/stop_request.hpp"
#include "io/view/server/page.hpp"
#include "io/view/server/request_origin.hpp"
#include "io/view/server/token.hpp"

namespace fs = std::filesystem;

namespace thaw {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* binary = "application/octet-stream";
constexpr std::uint64_t mostPoints = 10'000'000;

/// An address without meaning: status 400.
struct BadRequest : std::runtime_error {
  using std::runtime_error::runtime_error;
};

ViewReply jsonReply(const Json& json, int status = 200) {
  return {status, "application/json", json.dump(-1, ' ', false, Json::error_handler_t::replace)};
}
ViewReply problemReply(int status, const std::string& problem) {
  return jsonReply({{"problem", problem}}, status);
}

std::string textOf(const ViewRequest& q, const std::string& key) {
  const auto at = q.query.find(key);
  return at == q.query.end() ? std::string() : at->second;
}

template<class Number> std::optional<Number> numberOf(const ViewRequest& q, const std::string& key) {
  const std::string text = textOf(q, key);
  if (text.empty()) return std::nullopt;
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    throw BadRequest(key + ": expected a whole number");
  return number;
}

FrameRequest frameRequest(const ViewState& state, const ViewRequest& q) {
  const std::optional<PointType> type = pointTypeNamed(textOf(q, "type"));
  const auto number = numberOf<std::int64_t>(q, "number");
  if (!type || !number || *number < 0)
    throw BadRequest("expected a type of points and the number of a frame");
  FrameRequest request;
  request.type = *type;
  request.field = {textOf(q, "field"), numberOf<int>(q, "part").value_or(-1)};
  if (request.field.name == "speed") request.field = {"velocity", -1};
  request.most = std::clamp<std::uint64_t>(numberOf<std::uint64_t>(q, "most").value_or(request.most), 1,
                                           mostPoints);
  const fs::path file = framePath(state.run, readFrameList(state.run).scene, *type, *number);
  const auto path = fileInRun(state.run, file.lexically_relative(state.run));
  if (!path) throw IoError(file.filename().string(), "no such frame");
  request.path = path->string();
  return request;
}

/// Reads the scene of the first frame, again once that file has changed. Null without a usable scene.
const Scene* sceneOf(ViewState& state) {
  const FrameList list = readFrameList(state.run);
  if (list.frames.empty()) return nullptr;
  const ListedFrame& frame = list.frames.front();
  const auto type = std::find(frame.has.begin(), frame.has.end(), true) - frame.has.begin();
  const fs::path file = framePath(state.run, list.scene, static_cast<PointType>(type), frame.number);
  const auto path = fileInRun(state.run, file.lexically_relative(state.run));
  if (!path) return nullptr;
  const std::string from = fmt::format("{} {}", path->string(),
                                       fs::last_write_time(*path).time_since_epoch().count());
  if (from != state.sceneFrom) {
    state.scene.reset();
    state.scene = sceneOfFrame(*path);
    state.sceneFrom = from;
  }
  return state.scene ? &*state.scene : nullptr;
}

/// As sceneOf; null for a scene that cannot be read.
const Scene* usableScene(ViewState& state) {
  try {
    return sceneOf(state);
  } catch (const std::runtime_error&) { return nullptr; }
}

ViewReply runReply(const ViewState& state, const ViewRequest& q) {
  Json reply = {{"folder", fs::path(state.run).filename().string()}};
  reply.update(runStatus(state.run));
  const FrameList list = readFrameList(state.run);
  const std::string revision = fmt::format("{:016x}", list.revision);
  if (textOf(q, "frames") == revision) return jsonReply(reply);
  Json numbers = Json::array(), times = Json::array(), has = Json::array();
  for (const ListedFrame& f : list.frames) {
    int mask = 0;
    for (std::size_t k = 0; k < f.has.size(); k++) mask |= f.has[k] ? 1 << k : 0;
    numbers.push_back(f.number), times.push_back(f.time), has.push_back(mask);
  }
  reply["frames"] = {{"scene", list.scene}, {"revision", revision}, {"types", pointTypeNames},
                     {"numbers", numbers},  {"times", times},       {"has", has}};
  return jsonReply(reply);
}

ViewReply frameReply(ViewState& state, const ViewRequest& q) {
  Packet packet = framePacket(frameRequest(state, q));
  if (const Scene* scene = usableScene(state))
    packet.header["obstacles"] = obstaclePoses(*scene, packet.header["time"].get<double>());
  return {200, binary, packet.bytes()};
}

/// Reads the frame with the lock, and makes the mesh without it.
ViewReply meshReply(ViewState& state, const ViewRequest& q, std::unique_lock<std::mutex>& lock) {
  const FrameRequest request = frameRequest(state, q);
  if (request.type != PointType::Surface) throw BadRequest("expected the type surface");
  const Scene* scene = usableScene(state);
  const PeriodicSides sides = scene ? periodicSidesOf(scene->domain) : PeriodicSides{};
  const std::string key = fmt::format(
      "{} {} {}", request.path, fs::last_write_time(request.path).time_since_epoch().count(), request.most);
  const bool live = lockHolder(state.run.string()).has_value();
  lock.unlock();
  const auto read = [&] {
    const std::lock_guard hdf5(state.mutex);
    return readSurfaceToMesh(request);
  };
  return {200, binary, state.meshes.packet(key, read, sides, live)};
}

ViewReply logReply(const ViewState& state, const ViewRequest& q) {
  const auto path = logInRun(state.run, textOf(q, "file"));
  if (!path) return jsonReply({{"bytes", -1}, {"rows", 0}, {"columns", Json::object()}});
  LogRequest request{path->string(), {}};
  request.most = std::min<std::size_t>(numberOf<std::size_t>(q, "rows").value_or(request.most), 100'000);
  request.known = numberOf<std::int64_t>(q, "known").value_or(request.known);
  const std::string columns = textOf(q, "columns");
  for (std::size_t begin = 0; begin < columns.size();) {
    const std::size_t end = std::min(columns.find(',', begin), columns.size());
    request.columns.push_back(columns.substr(begin, end - begin));
    begin = end + 1;
  }
  return jsonReply(logRows(request));
}

ViewReply stopReply(const ViewState& state, const ViewRequest& q) {
  if (q.method != "POST") return problemReply(405, "expected POST");
  const std::string problem = requestStop(state.run);
  return problem.empty() ? jsonReply({{"stop_requested", true}}) : problemReply(409, problem);
}

ViewReply apiReply(ViewState& state, const ViewRequest& q, const std::string& name,
                   std::unique_lock<std::mutex>& lock) {
  if (name == "stop") return stopReply(state, q);
  if (q.method != "GET") return problemReply(405, "expected GET");
  if (name == "run") return runReply(state, q);
  if (name == "frame") return frameReply(state, q);
  if (name == "mesh") return meshReply(state, q, lock);
  if (name == "log") return logReply(state, q);
  if (name == "point")
    return jsonReply(pointDetails(frameRequest(state, q),
                                  {numberOf<std::uint64_t>(q, "index"), numberOf<std::uint64_t>(q, "id")}));
  if (name == "scene") {
    const Scene* scene = sceneOf(state);
    return jsonReply(scene ? sceneView(*scene) : Json(nullptr));
  }
  if (name == "obstacles") {
    const Scene* scene = sceneOf(state);
    return {200, binary, scene ? obstacleMeshes(*scene).bytes() : Packet{}.bytes()};
  }
  if (name == "marks") {
    const Scene* scene = sceneOf(state);
    return {200, binary, scene ? markLines(*scene).bytes() : Packet{}.bytes()};
  }
  return problemReply(404, "no such address");
}

ViewReply pageReply(const ViewRequest& q, const std::string& name) {
  if (q.method != "GET") return problemReply(405, "expected GET");
  for (const PageFile& file : pageFiles())
    if (file.name == (name.empty() ? "index.html" : name))
      return {200, std::string(file.type), std::string(file.bytes)};
  return problemReply(404, "no such address");
}

/// Leads a browser that this program has started to the page, once.
ViewReply openReply(ViewState& state, const std::string& once) {
  if (state.once.empty() || !sameToken(once, state.once)) return problemReply(403, "wrong token");
  state.once.clear();
  return {303, "text/plain; charset=utf-8", "", "/" + state.token + "/"};
}

ViewReply routed(ViewState& state, const ViewRequest& q, std::unique_lock<std::mutex>& lock) {
  if (const std::string problem = originProblem(q); !problem.empty()) return problemReply(403, problem);
  const std::size_t slash = q.path.find('/', 1);
  const std::string first = q.path.substr(std::min<std::size_t>(1, q.path.size()), slash - 1);
  const std::string rest = slash == std::string::npos ? std::string() : q.path.substr(slash + 1);
  if (first == "open") return openReply(state, rest);
  if (!sameToken(first, state.token))
    return problemReply(403, "wrong or missing token: use the address that thaw view prints");
  if (slash == std::string::npos) return {303, "text/plain; charset=utf-8", "", "/" + state.token + "/"};
  return rest.starts_with("api/") ? apiReply(state, q, rest.substr(4), lock) : pageReply(q, rest);
}

}  // namespace

ViewReply answer(ViewState& state, const ViewRequest& request) {
  std::unique_lock lock(state.mutex);
  try {
    return routed(state, request, lock);
  } catch (const BadRequest& error) {
    return problemReply(400, error.what());
  } catch (const std::bad_alloc&) {
    return problemReply(422, "not enough memory");
  } catch (const std::exception& error) {  // IoError, SceneErrors, a file system error
    return problemReply(422, error.what());
  }
}

const std::vector<std::pair<std::string, std::string>>& replyHeaders() {
  static const std::vector<std::pair<std::string, std::string>> headers{
      {"Cache-Control", "no-store"},
      {"X-Content-Type-Options", "nosniff"},
      {"X-Frame-Options", "DENY"},
      {"Referrer-Policy", "no-referrer"},
      {"Cross-Origin-Resource-Policy", "same-origin"},
      {"Cross-Origin-Opener-Policy", "same-origin"},
      {"Content-Security-Policy",
       "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; "
       "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"}};
  return headers;
}

}  // namespace thaw
