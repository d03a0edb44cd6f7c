// SPDX-License-Identifier: GPL-3.0-or-later
#include "bag_issues.hpp"
#include "topic_table.hpp"
#include "wrapped_readers.hpp"

#include <algorithm>
#include <utility>

namespace roomatlas::io {
namespace {

using OpenBag = std::function<std::unique_ptr<BagReader>(const std::filesystem::path&)>;

class Sequence final : public BagReader {
 public:
  Sequence(const std::string& name, std::vector<BagPart> parts, std::vector<BagTopic> known,
           bool look_into_all, OpenBag open)
      : name_(name), parts_(std::move(parts)), open_(std::move(open)), issues_(name) {
    const bool is_known = !known.empty();
    for (BagTopic& topic : known) topics_.add(std::move(topic));
    look_into_parts(is_known, look_into_all || !is_known);
    if (topics_.topics().empty()) {
      std::string why;
      for (const Issue& issue : issues_.list()) why += (why.empty() ? "" : "; ") + issue.message;
      throw InputError(name + ": no file of the recording can be read: " + why);
    }
    wanted_.assign(topics().size(), 1);
    for (const BagPart& part : parts_) total_bytes_ += part.bytes;
  }

  [[nodiscard]] const std::string& format() const override { return format_; }
  [[nodiscard]] const std::vector<BagTopic>& topics() const override { return topics_.topics(); }
  void select(const std::vector<std::size_t>& topics) override {
    std::fill(wanted_.begin(), wanted_.end(), char{0});
    for (const std::size_t topic : topics) wanted_.at(topic) = 1;
  }

  [[nodiscard]] std::optional<BagMessage> next() override {
    while (bag_ || next_part_ < parts_.size()) {
      if (!bag_) start_part();
      if (!bag_) continue;
      if (auto message = bag_->next()) {
        message->topic = topic_of_[message->topic];
        return message;
      }
      finish_part();
    }
    return std::nullopt;
  }

  [[nodiscard]] Issues issues() const override {
    Issues issues = issues_.list();
    if (unlisted_ > 0) {
      issues.push_back({Severity::warning, name_, 0, "",
                        "topics that are not in the metadata were left out (" +
                            std::to_string(unlisted_) + " topics): " + unlisted_names_});
    }
    if (bag_) {
      for (Issue& issue : bag_->issues()) issues.push_back(std::move(issue));
    }
    return issues;
  }
  [[nodiscard]] double progress() const override {
    if (!bag_ && next_part_ == parts_.size()) return 1.0;
    if (total_bytes_ == 0) return 0.0;
    const double within =
        bag_ ? bag_->progress() * static_cast<double>(parts_[next_part_ - 1].bytes) : 0.0;
    return std::min(
        1.0, (static_cast<double>(done_bytes_) + within) / static_cast<double>(total_bytes_));
  }

 private:
  /// Collects the topics; of parts whose topics are known the first is opened alone, for its
  /// format.
  void look_into_parts(bool is_known, bool look_into_all) {
    std::vector<std::optional<std::int64_t>> counts;
    for (const BagPart& part : parts_) {
      const auto bag = open(part);
      if (!bag) continue;
      if (format_.empty()) format_ = bag->format();
      for (const BagTopic& topic : bag->topics()) add(topic, is_known, counts);
      if (!look_into_all) break;
    }
    if (is_known) return;
    for (std::size_t i = 0; i < counts.size(); ++i) topics_.set_count(i, counts[i]);
  }

  void add(BagTopic topic, bool is_known, std::vector<std::optional<std::int64_t>>& counts) {
    const std::optional<std::int64_t> messages = topic.messages;
    topic.messages.reset();
    const auto index = topics_.add(std::move(topic));
    if (!index || is_known) return;
    if (*index >= counts.size()) {
      counts.resize(*index + 1, messages);
    } else if (counts[*index] && messages) {
      *counts[*index] += *messages;
    } else {
      counts[*index].reset();
    }
  }

  std::unique_ptr<BagReader> open(const BagPart& part) {
    try {
      if (auto bag = open_(part.file)) return bag;
      issues_.add(Severity::warning, part.file.filename().string() +
                                         " was left out: it is neither SQLite of rosbag2 nor "
                                         "MCAP, nor one of them packed by zstd");
    } catch (const InputError& error) {
      issues_.add(Severity::warning,
                  part.file.filename().string() + " was left out: " + error.what());
    }
    return nullptr;
  }

  void start_part() {
    bag_ = open(parts_[next_part_++]);
    if (!bag_) {
      done_bytes_ += parts_[next_part_ - 1].bytes;
      return;
    }
    topic_of_.clear();
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < bag_->topics().size(); ++i) {
      const auto index = topics_.add(bag_->topics()[i]);
      topic_of_.push_back(index.value_or(0));
      const bool is_new = index && *index >= wanted_.size();
      if (is_new) name_unlisted(bag_->topics()[i].name);
      if (index && !is_new && wanted_[*index] != 0) wanted.push_back(i);
    }
    bag_->select(wanted);
  }

  void name_unlisted(const std::string& topic) {
    constexpr std::int64_t kMostNamed = 10;
    if (unlisted_ < kMostNamed) unlisted_names_ += (unlisted_ == 0 ? "" : ", ") + topic;
    if (unlisted_ == kMostNamed) unlisted_names_ += " ...";
    ++unlisted_;
  }

  void finish_part() {
    issues_.take(bag_->issues());
    done_bytes_ += parts_[next_part_ - 1].bytes;
    bag_.reset();
  }

  std::string name_;
  std::vector<BagPart> parts_;
  OpenBag open_;
  BagIssues issues_;
  std::string format_;
  TopicTable topics_;
  std::vector<char> wanted_;
  std::unique_ptr<BagReader> bag_;
  std::vector<std::size_t> topic_of_;  ///< of the part that is read
  std::int64_t unlisted_ = 0;          ///< topics that the metadata does not have
  std::string unlisted_names_;
  std::size_t next_part_ = 0;
  std::uint64_t done_bytes_ = 0;
  std::uint64_t total_bytes_ = 0;
};

}  // namespace

std::unique_ptr<BagReader> in_sequence(const std::string& name, std::vector<BagPart> parts,
                                       std::vector<BagTopic> known, bool look_into_all,
                                       OpenBag open) {
  return std::make_unique<Sequence>(name, std::move(parts), std::move(known), look_into_all,
                                    std::move(open));
}

}  // namespace roomatlas::io
