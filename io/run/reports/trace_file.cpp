// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/trace_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "core/time/phase_times.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "parallel/transfer.hpp"

namespace thaw {
namespace {

enum Tag { ClockTag = 51, CountTag = 52, EventsTag = 53 };

std::int64_t now() { return StepTrace::nanoseconds(StepTrace::Clock::now()); }

/// Returns the clock offset of the first rank of a machine, by round trips to rank 0.
std::int64_t measureClockOffset(MPI_Comm comm) {
  std::int64_t quickest = INT64_MAX, offset = 0;
  for (int k = 0; k < 20; k++) {
    const std::int64_t sent = now();
    std::int64_t there = 0;
    MPI_Send(&sent, 1, MPI_INT64_T, 0, ClockTag, comm);
    MPI_Recv(&there, 1, MPI_INT64_T, 0, ClockTag, comm, MPI_STATUS_IGNORE);
    const std::int64_t back = now();
    if (back - sent >= quickest) continue;
    quickest = back - sent;
    offset = there - (sent + quickest / 2);
  }
  return offset;
}

void answerClockRequests(MPI_Comm comm, int rank) {
  for (int k = 0; k < 20; k++) {
    std::int64_t sent = 0;
    MPI_Recv(&sent, 1, MPI_INT64_T, rank, ClockTag, comm, MPI_STATUS_IGNORE);
    const std::int64_t here = now();
    MPI_Send(&here, 1, MPI_INT64_T, rank, ClockTag, comm);
  }
}

/// A file writer that remembers its first error.
class Lines {
 public:
  explicit Lines(const std::string& path) : path_(path), file_(std::fopen(path.c_str(), "w")) {
    if (!file_) problem_ = path + ": cannot be created: " + std::strerror(errno);
  }
  ~Lines() {
    if (file_) std::fclose(file_);
  }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;
  void put(const std::string& text) {
    if (problem_.empty() && std::fwrite(text.data(), 1, text.size(), file_) != text.size())
      problem_ = path_ + ": cannot be written: " + std::strerror(errno);
  }
  /// Closes the file. Returns the error, or "".
  std::string close() {
    if (file_ && std::fclose(file_) != 0 && problem_.empty())
      problem_ = path_ + ": cannot be written: " + std::strerror(errno);
    file_ = nullptr;
    return problem_;
  }

 private:
  std::string path_, problem_;
  std::FILE* file_;
};

const char* nameOf(const TraceEvent& e) {
  if (e.kind == TraceKind::Step) return "step";
  return e.kind == TraceKind::Phase ? phaseName(static_cast<StepPhase>(e.name))
                                    : purposeName(static_cast<MessagesFor>(e.name));
}

void putRank(Lines& out, int rank, const std::vector<TraceEvent>& events, std::int64_t dropped,
             std::int64_t zero) {
  const auto us = [&](std::int64_t ns) { return static_cast<double>(ns - zero) * 1e-3; };
  out.put(fmt::format(
      "{}{{\"ph\":\"M\",\"name\":\"process_name\",\"pid\":{},\"tid\":0,\"args\":{{\"name\":\"rank {}{}\"}}}}",
      rank > 0 ? ",\n" : "", rank, rank, dropped > 0 ? fmt::format(", {} events left out", dropped) : ""));
  out.put(
      fmt::format(",\n{{\"ph\":\"M\",\"name\":\"process_sort_index\",\"pid\":{0},\"tid\":0,\"args\":{{\"sort_"
                  "index\":{0}}}}}",
                  rank));
  std::size_t number = 0;
  for (const TraceEvent& e : events) {
    if (e.kind != TraceKind::Exchange) {
      out.put(
          fmt::format(",\n{{\"ph\":\"X\",\"cat\":\"{}\",\"name\":\"{}{}\",\"pid\":{},\"tid\":0,\"ts\":{:.3f},"
                      "\"dur\":{:.3f},\"args\":{{\"step\":{}}}}}",
                      e.kind == TraceKind::Step    ? "step"
                      : e.kind == TraceKind::Phase ? "phase"
                                                   : "wait",
                      e.kind == TraceKind::Wait ? "wait: " : "", nameOf(e), rank, us(e.begin),
                      static_cast<double>(e.end - e.begin) * 1e-3, e.step));
      continue;
    }
    const std::string head = fmt::format(
        "\"cat\":\"exchange\",\"name\":\"{}\",\"id\":\"{}.{}\",\"pid\":{},\"tid\":0", nameOf(e), rank,
        number++, rank);
    out.put(fmt::format(
        ",\n{{\"ph\":\"b\",{},\"ts\":{:.3f},\"args\":{{\"step\":{},\"messages\":{},\"bytes\":{}}}}}", head,
        us(e.begin), e.step, e.messages, e.bytes));
    out.put(fmt::format(",\n{{\"ph\":\"e\",{},\"ts\":{:.3f}}}", head, us(e.end)));
  }
}

}  // namespace

std::int64_t clockOffset(const Communicator& comm) {
  MPI_Comm machine;
  MPI_Comm_split_type(comm.handle(), MPI_COMM_TYPE_SHARED, comm.rank(), MPI_INFO_NULL, &machine);
  int firstHere = comm.rank();  // the lowest rank of this machine
  MPI_Bcast(&firstHere, 1, MPI_INT, 0, machine);
  std::vector<int> firsts(static_cast<std::size_t>(comm.size()));
  MPI_Gather(&firstHere, 1, MPI_INT, firsts.data(), 1, MPI_INT, 0, comm.handle());
  std::int64_t offset = 0;
  if (comm.rank() == 0) {
    for (int r = 1; r < comm.size(); r++)
      if (firsts[static_cast<std::size_t>(r)] == r) answerClockRequests(comm.handle(), r);
  } else if (firstHere == comm.rank()) {
    offset = measureClockOffset(comm.handle());
  }
  MPI_Bcast(&offset, 1, MPI_INT64_T, 0, machine);
  MPI_Comm_free(&machine);
  return offset;
}

void writeTrace(const std::string& path, const Communicator& comm, const StepTrace& trace) {
  const std::int64_t offset = clockOffset(comm);
  std::vector<TraceEvent> events = trace.events();
  std::int64_t zero = INT64_MAX;
  for (TraceEvent& e : events) {
    e.begin += offset;
    e.end += offset;
    zero = std::min(zero, e.begin);
  }
  MPI_Allreduce(MPI_IN_PLACE, &zero, 1, MPI_INT64_T, MPI_MIN, comm.handle());
  std::int64_t head[2] = {static_cast<std::int64_t>(events.size()), trace.dropped()};
  std::vector<MPI_Request> requests;
  if (comm.rank() > 0) {
    MPI_Send(head, 2, MPI_INT64_T, 0, CountTag, comm.handle());
    startSend(comm, std::as_bytes(std::span(events)), {0, EventsTag}, MessagesFor::Rows, requests);
    finishAll(requests);
    return agree(comm.handle(), "");
  }
  Lines out(path + ".part");
  out.put("{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n");
  for (int r = 0; r < comm.size(); r++) {
    if (r > 0) {
      MPI_Recv(head, 2, MPI_INT64_T, r, CountTag, comm.handle(), MPI_STATUS_IGNORE);
      events.resize(static_cast<std::size_t>(head[0]));
      startReceive(comm, std::as_writable_bytes(std::span(events)), {r, EventsTag}, requests);
      finishAll(requests);
    }
    putRank(out, r, events, head[1], zero);
  }
  out.put("\n]}\n");
  std::string problem = out.close();
  if (problem.empty() && std::rename((path + ".part").c_str(), path.c_str()) != 0)
    problem = path + ": cannot be renamed to: " + std::strerror(errno);
  if (!problem.empty()) std::remove((path + ".part").c_str());
  agree(comm.handle(), problem);
}

}  // namespace thaw
