// SPDX-License-Identifier: GPL-3.0-or-later
// ROS's own library for Python reads what we write, and writes what we read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "bags/bag_writers.hpp"
#include "io/bags/small_bags.hpp"
#include "support/shared_data.hpp"
#include "support/temporary_folder.hpp"

namespace roomatlas::test::bags {
namespace {

constexpr const char* kPython = "/usr/bin/python3";  // whose packages are the system's

/// Prints a bag as `listed` does.
constexpr const char* kList = R"(
import rosbag, sys, zlib
bag = rosbag.Bag(sys.argv[1], allow_unindexed=True)
lines = ['%s %s %d %d %08x' % (c, m[0], t.to_nsec(), len(m[1]), zlib.crc32(m[1]))
         for c, m, t in bag.read_messages(raw=True)]
open(sys.argv[2], 'w').write('\n'.join(sorted(lines)) + '\n')
)";

/// Writes a bag of many small chunks, with messages of one topic long after their time.
constexpr const char* kWrite = R"(
import rosbag, sys, genpy
from std_msgs.msg import String, Int32
with rosbag.Bag(sys.argv[1], 'w', compression=sys.argv[2], chunk_threshold=3000) as bag:
    for i in range(500):
        t = 1500000000 * 10**9 + i * 123456789
        time = genpy.Time(t // 10**9, t % 10**9)
        bag.write('/text', String('message %d ' % i + 'x' * (i * 37 % 211)), time)
        if i % 3 == 0: bag.write('/number', Int32(i), time)
        if i > 100 and i % 7 == 0: bag.write('/late', Int32(i), genpy.Time(1500000000 + i // 9, i))
)";

std::string listed(io::BagReader& bag) {
  std::vector<std::string> lines;
  while (const auto message = bag.next()) {
    const io::BagTopic& topic = bag.topics()[message->topic];
    const std::string bytes(reinterpret_cast<const char*>(message->bytes.data()),
                            message->bytes.size());
    char sum[9];
    std::snprintf(sum, sizeof sum, "%08x", crc(bytes));
    lines.push_back(topic.name + " " + topic.type + " " + std::to_string(message->log_time_ns) +
                    " " + std::to_string(bytes.size()) + " " + sum + "\n");
  }
  std::sort(lines.begin(), lines.end());
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

class PythonRosbag : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system((std::string(kPython) + " -c 'import rosbag' >/dev/null 2>&1").c_str()) == 0)
      return;
    const char* ci = std::getenv("CI");
    if (ci != nullptr && std::string(ci) == "true") FAIL() << "python3-rosbag is missing";
    GTEST_SKIP() << "python3-rosbag is missing";
  }
  bool run(const char* script, const std::string& arguments) {
    const auto file = folder_.write("script.py", script);
    return std::system((std::string(kPython) + " '" + file.string() + "' " + arguments).c_str()) ==
           0;
  }
  std::string listed_by_python(const std::filesystem::path& bag) {
    const auto out = folder_ / "list.txt";
    if (!run(kList, "'" + bag.string() + "' '" + out.string() + "'")) return "python failed";
    return bytes_of(out);
  }

  TemporaryFolder folder_;
};

TEST_F(PythonRosbag, WritesWhatIsReadHere) {
  for (const std::string packing : {"none", "bz2", "lz4"}) {
    const auto file = folder_ / (packing + ".bag");
    ASSERT_TRUE(run(kWrite, "'" + file.string() + "' " + packing));
    const auto reader = io::open_bag(file);
    ASSERT_TRUE(reader);
    EXPECT_EQ(listed(*reader), listed_by_python(file)) << packing;
    EXPECT_EQ(text_of(reader->issues()), "");
    std::int64_t last_ns = 0;
    for (const Message& message : messages_of(file)) {
      EXPECT_LE(last_ns, message.time_ns);
      last_ns = message.time_ns;
    }
  }
}

TEST_F(PythonRosbag, ReadsWhatIsWrittenHere) {
  for (const io::Packing packing : {io::Packing::none, io::Packing::bz2, io::Packing::lz4}) {
    const auto file = folder_ / "ours.bag";
    const auto writer = io::create_ros1_bag(file, packing);
    writer->add_topic({"/a", "std_msgs/String", io::BagEncoding::ros1, "string data\n", {}});
    for (int i = 0; i < 3000; ++i) {
      const std::string bytes(static_cast<std::size_t>(i), static_cast<char>(i));
      writer->write(0, 1'700'000'000'000'000'000 + i, std::as_bytes(std::span(bytes)));
    }
    writer->finish();
    EXPECT_EQ(listed_by_python(file), listed(*io::open_bag(file)));
  }
}

TEST_F(PythonRosbag, ReadsRecordedBagsAlike) {
  const auto folder = shared_data("bags");
  if (!folder) return;
  int bags = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*folder)) {
    if (entry.path().extension() != ".bag") continue;
    ++bags;
    const auto reader = io::open_bag(entry.path());
    ASSERT_TRUE(reader);
    const std::string ours = listed(*reader);
    EXPECT_FALSE(ours.empty());
    EXPECT_TRUE(ours == listed_by_python(entry.path())) << entry.path();
  }
  EXPECT_GT(bags, 0);
}

}  // namespace
}  // namespace roomatlas::test::bags
