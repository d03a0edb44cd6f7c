// SPDX-License-Identifier: GPL-3.0-or-later
#include "wrapped_readers.hpp"
#include "files/unpack_bounds.hpp"

#include "bag_issues.hpp"
#include "chunk.hpp"
#include "unpack.hpp"

#include <utility>

namespace roomatlas::io {
namespace {

/// Passes on what the recording within says.
class Wrapper : public BagReader {
 public:
  explicit Wrapper(std::unique_ptr<BagReader> bag) : bag_(std::move(bag)) {}

  [[nodiscard]] const std::string& format() const override { return bag_->format(); }
  [[nodiscard]] const std::vector<BagTopic>& topics() const override { return bag_->topics(); }
  void select(const std::vector<std::size_t>& topics) override { bag_->select(topics); }
  [[nodiscard]] std::optional<BagMessage> next() override { return bag_->next(); }
  [[nodiscard]] Issues issues() const override { return bag_->issues(); }
  [[nodiscard]] double progress() const override { return bag_->progress(); }

 private:
  std::unique_ptr<BagReader> bag_;
};

class MessageUnpacker final : public Wrapper {
 public:
  using Wrapper::Wrapper;

  [[nodiscard]] std::optional<BagMessage> next() override {
    while (auto message = Wrapper::next()) {
      const bool is_packed =
          is_zstd(message->bytes) && topics()[message->topic].encoding == BagEncoding::cdr;
      if (!is_packed) return message;
      const std::string fault = unpack(message->bytes);
      if (fault.empty()) {
        message->bytes = content_.view();
        return message;
      }
      issues_.add(Severity::warning, "a message was left out: " + fault, "messages", 1);
    }
    return std::nullopt;
  }
  [[nodiscard]] Issues issues() const override {
    Issues issues = Wrapper::issues();
    for (Issue& issue : issues_.list()) issues.push_back(std::move(issue));
    return issues;
  }

 private:
  /// Into `content_`; what is wrong, for people.
  std::string unpack(ByteSpan packed) {
    packed_bytes_ += packed.size();
    const std::uint64_t in_all = most_unpacked_bytes(packed_bytes_, kMostGrowthStreamed);
    const std::uint64_t most =
        std::min({most_unpacked_bytes(packed.size(), kMostGrowth), kLargestChunk_bytes,
                  in_all - std::min(in_all, unpacked_bytes_)});
    std::string fault = unpacker_.unpack(Packing::zstd, packed, most, content_);
    unpacked_bytes_ += content_.size();
    return fault;
  }

  std::uint64_t packed_bytes_ = 0;
  std::uint64_t unpacked_bytes_ = 0;
  Unpacker unpacker_;
  Buffer content_;
  BagIssues issues_{""};
};

class Remarks final : public Wrapper {
 public:
  Remarks(std::unique_ptr<BagReader> bag, std::string format, Issues issues)
      : Wrapper(std::move(bag)), format_(std::move(format)), remarks_(std::move(issues)) {}

  [[nodiscard]] const std::string& format() const override { return format_; }
  [[nodiscard]] Issues issues() const override {
    Issues issues = remarks_;
    for (Issue& issue : Wrapper::issues()) issues.push_back(std::move(issue));
    return issues;
  }

 private:
  std::string format_;
  Issues remarks_;
};

}  // namespace

std::unique_ptr<BagReader> with_messages_unpacked(std::unique_ptr<BagReader> bag) {
  return std::make_unique<MessageUnpacker>(std::move(bag));
}

std::unique_ptr<BagReader> with_remarks(std::unique_ptr<BagReader> bag, std::string format,
                                        Issues issues) {
  return std::make_unique<Remarks>(std::move(bag), std::move(format), std::move(issues));
}

}  // namespace roomatlas::io
