// SPDX-License-Identifier: Apache-2.0
#include "parallel/sparse_exchange.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "parallel/transfer.hpp"
#include "tests/support/hashed.hpp"

using namespace thaw;
using thaw::test::hashed;

namespace {

/// Number of messages from one rank to another in a round (mostly none). Every rank computes the same numbers
/// and sizes.
int messagesBetween(int from, int to, int round) {
  const int key = round * 10007 + from * 101 + to;
  return static_cast<int>(hashed(static_cast<std::uint64_t>(key)) * 5) - 2;
}
std::size_t sizeOf(int from, int to, int round, int k) {
  const int key = ((round * 64 + from) * 64 + to) * 8 + k;
  const double u = hashed(static_cast<std::uint64_t>(key));
  return 1 + static_cast<std::size_t>(u < 0.1 ? u * 3e6 : u * 500);
}
std::byte content(std::size_t i, int from, int k) {
  return static_cast<std::byte>((i * 7 + static_cast<std::size_t>(from * 31 + k * 5)) & 255);
}

}  // namespace

TEST(SparseExchange, EverythingArrivesInOrderOfSenders) {
  const Communicator comm;
  ReceiveBuffer in;
  for (int round = 0; round < 60; round++) {
    std::vector<Message> out;
    for (int to = comm.size() - 1; to >= 0; to--)
      for (int k = 0; k < messagesBetween(comm.rank(), to, round); k++) {
        Message m{to, std::vector<std::byte>(sizeOf(comm.rank(), to, round, k))};
        for (std::size_t i = 0; i < m.bytes.size(); i++) m.bytes[i] = content(i, comm.rank(), k);
        out.push_back(std::move(m));
      }
    out.push_back({(comm.rank() + 1) % comm.size(), {}});  // empty: not sent
    sparseExchange(comm, out, in, 1 + round % 3, MessagesFor::Migration);
    std::size_t at = 0;
    for (int from = 0; from < comm.size(); from++)
      for (int k = 0; k < messagesBetween(from, comm.rank(), round); k++, at++) {
        ASSERT_LT(at, in.messages().size());
        const Message& m = in.messages()[at];
        ASSERT_EQ(m.rank, from);
        ASSERT_EQ(m.bytes.size(), sizeOf(from, comm.rank(), round, k));
        for (std::size_t i = 0; i < m.bytes.size(); i++) ASSERT_EQ(m.bytes[i], content(i, from, k));
      }
    ASSERT_EQ(at, in.messages().size());
  }
}

TEST(SparseExchange, LongMessagesAreSplitIntoChunks) {
  const Communicator comm(MPI_COMM_WORLD, 64);
  ASSERT_EQ(comm.chunk(), 64u);
  const std::size_t sizes[] = {1, 63, 64, 65, 128, 1000, 6400};  // multiples of a chunk end with an empty one
  for (int round = 0; round < 10; round++) {
    std::vector<Message> out;
    const int to = (comm.rank() + 1 + round) % comm.size(),
              from = ((comm.rank() - 1 - round) % comm.size() + comm.size()) % comm.size();
    for (int k = 0; k < 7; k++) {
      Message m{to, std::vector<std::byte>(sizes[k])};
      for (std::size_t i = 0; i < m.bytes.size(); i++) m.bytes[i] = content(i, comm.rank(), k);
      out.push_back(std::move(m));
    }
    const std::vector<Message> in = sparseExchange(comm, out, 3, MessagesFor::Rows);
    ASSERT_EQ(in.size(), 7u);
    for (int k = 0; k < 7; k++) {
      const Message& m = in[static_cast<std::size_t>(k)];
      ASSERT_EQ(m.rank, from);
      ASSERT_EQ(m.bytes.size(), sizes[k]);
      for (std::size_t i = 0; i < m.bytes.size(); i++) ASSERT_EQ(m.bytes[i], content(i, from, k));
    }
  }
}

TEST(SparseExchange, CountsItsMessages) {
  const Communicator comm(MPI_COMM_WORLD, 64);
  if (comm.size() == 1) return;
  const std::vector<Message> out{{(comm.rank() + 1) % comm.size(), std::vector<std::byte>(100)}};
  sparseExchange(comm, out, 3, MessagesFor::Rows);
  EXPECT_EQ(comm.statistics()[MessagesFor::Rows].messages, 2);  // in two chunks
  EXPECT_EQ(comm.statistics()[MessagesFor::Rows].bytes, 100);
  EXPECT_EQ(comm.statistics().collectives, 1);
  EXPECT_GE(comm.statistics().total().waited, 0);
}

TEST(Transfer, ChunksArriveInOrder) {
  const Communicator comm(MPI_COMM_WORLD, 64);
  if (comm.size() == 1) return;
  const int to = (comm.rank() + 1) % comm.size(), from = (comm.rank() + comm.size() - 1) % comm.size();
  for (const std::size_t bytes : {0, 1, 64, 65, 1000}) {
    std::vector<std::byte> mine(bytes), theirs(bytes);
    for (std::size_t i = 0; i < bytes; i++) mine[i] = content(i, comm.rank(), 1);
    std::vector<MPI_Request> sending, receiving;
    startReceive(comm, {theirs.data(), bytes}, {from, 7}, receiving);
    startSend(comm, {mine.data(), bytes}, {to, 7}, MessagesFor::Rows, sending);
    EXPECT_EQ(sending.size(), (bytes + 63) / 64);
    finishAll(receiving);
    finishAll(sending);
    for (std::size_t i = 0; i < bytes; i++) ASSERT_EQ(theirs[i], content(i, from, 1));
  }
}

TEST(MpiReducer, LongReductionsAreSplit) {
  const Communicator comm(MPI_COMM_WORLD, 64);
  MpiReducer all(comm);
  std::vector<std::int64_t> sums(200);
  for (std::size_t k = 0; k < sums.size(); k++) sums[k] = static_cast<std::int64_t>(k) * (comm.rank() + 1);
  all.sum(sums);
  for (std::size_t k = 0; k < sums.size(); k++)
    ASSERT_EQ(sums[k], static_cast<std::int64_t>(k) * comm.size() * (comm.size() + 1) / 2);
  EXPECT_EQ(comm.statistics().collectives, comm.size() == 1 ? 0 : 4);
}

TEST(MpiReducer, MaximumAndSumOverAllRanks) {
  const Communicator comm;
  MpiReducer all(comm);
  double values[3] = {static_cast<double>(comm.rank()), -static_cast<double>(comm.rank()), 1};
  if (comm.rank() == comm.size() / 2) values[2] = std::numeric_limits<double>::quiet_NaN();
  all.maximum(values);
  EXPECT_EQ(values[0], comm.size() - 1);
  EXPECT_EQ(values[1], 0);
  EXPECT_EQ(values[2], std::numeric_limits<double>::infinity());
  std::int64_t sums[2] = {comm.rank() + 1, std::int64_t{1} << 55};
  all.sum(sums);
  EXPECT_EQ(sums[0], comm.size() * (comm.size() + 1) / 2);
  EXPECT_EQ(sums[1], comm.size() * (std::int64_t{1} << 55));
}
