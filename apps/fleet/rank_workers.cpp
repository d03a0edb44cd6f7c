// SPDX-License-Identifier: GPL-3.0-or-later
#include "rank_workers.hpp"

#include <mpi.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <limits>
#include <memory>
#include <thread>

#include "roomatlas/core/issue.hpp"

namespace roomatlas::apps {
namespace {

constexpr std::chrono::microseconds kBetweenProbes(100);  // MPI's own wait would keep a core busy
constexpr int kLooksAtLife = 2000;  // between two questions whether a rank is alive

// The first byte of what a leader says.
constexpr char kAll = 'a';
constexpr char kEnd = 'e';
// The second byte at the end.
constexpr char kWhole = 'w';
constexpr char kWithout = 'o';  // ranks that died

void append(std::string& message, std::size_t number) {
  message.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Takes numbers and texts off a message.
class Reader {
 public:
  Reader(const std::string& message, std::size_t from) : message_(message), at_(from) {}
  std::size_t number() {
    std::size_t value = 0;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string text() { return std::string(take(number())); }

 private:
  std::string_view take(std::size_t count) {
    if (message_.size() - at_ < count) throw std::logic_error("a message of a rank ends too early");
    at_ += count;
    return std::string_view(message_).substr(at_ - count, count);
  }
  const std::string& message_;
  std::size_t at_;
};

}  // namespace

RankWorkers::RankWorkers(const RunLocks& locks, int leader, int jobs, std::function<bool()> stops)
    : Workers(jobs), locks_(locks), leader_(leader), stops_(std::move(stops)) {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  for (int rank = leader; rank < size_; ++rank) live_.push_back(rank);
}

std::vector<std::size_t> RankWorkers::parts_of(int rank, std::size_t count) const {
  const auto place = std::find(live_.begin(), live_.end(), rank) - live_.begin();
  std::vector<std::size_t> parts;
  for (auto i = static_cast<std::size_t>(place); i < count; i += live_.size()) parts.push_back(i);
  return parts;
}

std::vector<std::string> RankWorkers::shared(
    std::size_t count, int jobs, const std::function<std::string(std::size_t)>& make) const {
  if (!is_shared()) return results_of<std::string>(count, jobs, make);
  Parts all(count);
  const std::vector<std::size_t> own = parts_of(rank_, count);
  for_each_index(own.size(), jobs, [&](std::size_t k) { all[own[k]] = make(own[k]); });
  if (is_leader()) {
    collect(all, jobs, make);
    return all;
  }
  std::string mine;
  for (const std::size_t i : own) {
    append(mine, all[i].size());
    mine += all[i];
  }
  if (!own.empty() && !send(leader_, mine)) throw LeaderDied("the leader died");
  const std::string message = from_leader();
  Reader reader(message, 1);
  live_.resize(reader.number());
  for (int& rank : live_) rank = static_cast<int>(reader.number());
  if (reader.number() != count) throw std::logic_error("ranks differ in what they share");
  for (std::string& part : all) part = reader.text();
  return all;
}

void RankWorkers::collect(Parts& all, int jobs,
                          const std::function<std::string(std::size_t)>& make) const {
  std::vector<int> alive = {rank_};
  std::vector<std::size_t> left;  // by those that died
  for (const int rank : live_) {
    if (rank == rank_) continue;
    const std::vector<std::size_t> parts = parts_of(rank, all.size());
    std::string message;
    if (parts.empty() ? locks_.is_held(RunLocks::rank(rank)) : receive(rank, message)) {
      alive.push_back(rank);
      Reader reader(message, 0);
      for (const std::size_t i : parts) all[i] = reader.text();
    } else {
      spdlog::warn("rank {} died; the others go on without it", rank);
      left.insert(left.end(), parts.begin(), parts.end());
    }
  }
  live_ = alive;
  for_each_index(left.size(), jobs, [&](std::size_t k) { all[left[k]] = make(left[k]); });
  std::string message(1, kAll);
  append(message, live_.size());
  for (const int rank : live_) append(message, static_cast<std::size_t>(rank));
  append(message, all.size());
  for (const std::string& part : all) {
    append(message, part.size());
    message += part;
  }
  send_to_all(message);
}

void RankWorkers::send_to_all(const std::string& message) const {
  for (const int rank : live_) {
    if (rank != rank_) (void)send(rank, message);  // who died is missed when it is asked next
  }
}

void RankWorkers::end() const {
  for (int rank = 0; rank < size_; ++rank) {
    has_lost_ranks_ = has_lost_ranks_ || (rank != rank_ && !locks_.is_held(RunLocks::rank(rank)));
  }
  send_to_all({kEnd, has_lost_ranks_ ? kWithout : kWhole});
}

void RankWorkers::wait_for_end() const {
  try {
    (void)from_leader();
  } catch (const RunEnded&) {
    return;
  }
  throw std::logic_error("the leader shares what this rank does not");
}

std::string RankWorkers::from_leader() const {
  std::string message;
  if (!receive(leader_, message)) throw LeaderDied("the leader died");
  if (message.front() == kEnd) {
    has_lost_ranks_ = message.back() == kWithout;
    throw RunEnded("the leader ended the run");
  }
  return message;
}

bool RankWorkers::wait_for(int rank, const std::function<bool()>& has_come) const {
  for (int looks = 0; !has_come(); ++looks) {
    if (stops_()) {
      throw Interrupted("interrupted; run the same command to go on from the finished missions");
    }
    if (looks % kLooksAtLife == kLooksAtLife - 1 && !locks_.is_held(RunLocks::rank(rank)))
      return has_come();
    std::this_thread::sleep_for(kBetweenProbes);
  }
  return true;
}

bool RankWorkers::receive(int rank, std::string& message) const {
  MPI_Message found = MPI_MESSAGE_NULL;
  MPI_Status status;
  const bool is_there = wait_for(rank, [&] {
    int flag = 0;
    MPI_Improbe(rank, leader_, MPI_COMM_WORLD, &flag, &found, &status);
    return flag != 0;
  });
  if (!is_there) return false;
  MPI_Count bytes = 0;
  MPI_Get_elements_x(&status, MPI_BYTE, &bytes);
  // Left behind where the rank dies in the middle: MPI may still write to it.
  auto buffer = std::make_unique<std::string>(static_cast<std::size_t>(bytes), '\0');
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Imrecv(buffer->data(), static_cast<int>(bytes), MPI_BYTE, &found, &request);
  const bool has_all = wait_for(rank, [&] {
    int flag = 0;
    MPI_Test(&request, &flag, MPI_STATUS_IGNORE);
    return flag != 0;
  });
  if (has_all) {
    message = std::move(*buffer);
  } else {
    (void)buffer.release();
  }
  return has_all;
}

bool RankWorkers::send(int rank, const std::string& message) const {
  if (message.size() > std::numeric_limits<int>::max()) throw std::length_error("too much for MPI");
  auto buffer = std::make_unique<std::string>(message);  // as when receiving
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Isend(buffer->data(), static_cast<int>(buffer->size()), MPI_BYTE, rank, leader_,
            MPI_COMM_WORLD, &request);
  const bool is_gone = wait_for(rank, [&] {
    int flag = 0;
    MPI_Test(&request, &flag, MPI_STATUS_IGNORE);
    return flag != 0;
  });
  if (!is_gone) (void)buffer.release();
  return is_gone;
}

}  // namespace roomatlas::apps
