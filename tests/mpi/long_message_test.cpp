// SPDX-License-Identifier: Apache-2.0
// A message of more than 2^31 bytes, beyond MPI's counts, in chunks of real size. It is sent from the first
// rank to the last, or to itself on one rank.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>

#include "parallel/transfer.hpp"

using namespace thaw;

TEST(LongMessage, MoreThan2To31BytesArriveInOrder) {
  constexpr std::size_t bytes = (std::size_t{1} << 31) + 12345;
  const double free = static_cast<double>(sysconf(_SC_AVPHYS_PAGES)) *
                      static_cast<double>(sysconf(_SC_PAGESIZE));
  int enough = free > 3.0 * static_cast<double>(bytes), all = 0;
  MPI_Allreduce(&enough, &all, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (!all) GTEST_SKIP() << "needs 6.5 GB of free memory";
  const Communicator comm;
  const int last = comm.size() - 1;
  const auto release = [](std::byte* p) { std::free(p); };
  using Bytes = std::unique_ptr<std::byte, decltype(release)>;
  // Pages that are never written take no memory. Marks stand at possible ends of chunks.
  const auto marked = [&](auto each) {
    for (std::size_t at = 0; at < bytes; at += 4096 * 511) each(at);
    for (const std::size_t end : {std::size_t{1} << 30, std::size_t{1} << 31, bytes})
      each(end - 1), each(end < bytes ? end : 0);
  };
  const auto mark = [](std::size_t at) { return static_cast<std::byte>(1 + at % 251); };
  std::vector<MPI_Request> requests;
  Bytes from(nullptr, release), to(nullptr, release);
  if (comm.rank() == last) {
    to.reset(static_cast<std::byte*>(std::malloc(bytes)));
    ASSERT_NE(to, nullptr);
    startReceive(comm, {to.get(), bytes}, {0, 7}, requests);
  }
  if (comm.rank() == 0) {
    from.reset(static_cast<std::byte*>(std::calloc(bytes, 1)));
    ASSERT_NE(from, nullptr);
    marked([&](std::size_t at) { from.get()[at] = mark(at); });
    startSend(comm, {from.get(), bytes}, {last, 7}, MessagesFor::Migration, requests);
  }
  EXPECT_LE(comm.chunk(), std::size_t{1} << 30);
  finishAll(requests);
  if (comm.rank() == last) marked([&](std::size_t at) { ASSERT_EQ(to.get()[at], mark(at)) << at; });
}
