// SPDX-License-Identifier: GPL-3.0-or-later
// A recording as large as a day with a camera: a mission through `eight_rooms`, and beside it
// pictures that nobody asks for, as an MCAP without a summary (as one that was cut off has none).
// The pictures are holes of the file, so that it takes no room on a disk that knows such files.
//
//   bench_large_log [GB...]
// Default: 0, 5 and 50 GB. What is mapped must be the same.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "accuracy/program.hpp"
#include "bags/byte_text.hpp"
#include "bags/mcap_records.hpp"

namespace {

namespace fs = std::filesystem;
using namespace roomatlas::bench;
using roomatlas::io::ByteText;
using roomatlas::io::kMcapMagic;
using roomatlas::io::kMcapRecordHeader_bytes;
using roomatlas::io::McapOp;

constexpr std::uint64_t kPictureBytes = 4'000'000;
constexpr std::uint16_t kCamera = 999;  // no channel of a mission's

std::string record(McapOp op, const ByteText& content, std::uint64_t more_bytes = 0) {
  ByteText text;
  text.u8(static_cast<std::uint8_t>(op));
  text.u64(content.size() + more_bytes);
  text.append(content.text());
  return text.text();
}

/// Visits the records of a small MCAP, one after the other, until its data ends.
void for_each_record(const std::string& bytes,
                     const std::function<void(McapOp, const std::string&)>& visit) {
  for (std::size_t at = kMcapMagic.size(); at + kMcapRecordHeader_bytes <= bytes.size();) {
    std::uint64_t length = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      length |= std::uint64_t{static_cast<unsigned char>(bytes[at + 1 + i])} << (8 * i);
    }
    const auto op = static_cast<McapOp>(bytes[at]);
    if (op == McapOp::data_end) return;
    visit(op, bytes.substr(at, kMcapRecordHeader_bytes + length));
    at += kMcapRecordHeader_bytes + length;
  }
}

/// The mission with pictures behind each of its chunks, so many bytes of them in all.
void write_with_pictures(const std::string& mission, std::uint64_t picture_bytes,
                         const fs::path& file) {
  std::uint64_t chunks = 0;
  for_each_record(mission, [&](McapOp op, const std::string&) { chunks += op == McapOp::chunk; });
  const std::uint64_t pictures = picture_bytes / kPictureBytes;
  std::ofstream out(file, std::ios::binary);
  out << kMcapMagic;
  bool is_described = false;
  std::uint64_t chunk = 0;
  for_each_record(mission, [&](McapOp op, const std::string& bytes) {
    out << bytes;
    if (!is_described) {  // behind the header
      ByteText channel;
      channel.u16(kCamera);
      channel.u16(0);  // no schema
      channel.block("/camera/image");
      channel.block("cdr");
      channel.u32(0);
      out << record(McapOp::channel, channel);
      is_described = true;
    }
    if (op != McapOp::chunk) return;
    const std::uint64_t first = pictures * chunk / chunks;
    for (std::uint64_t i = first; i < pictures * (chunk + 1) / chunks; ++i) {
      ByteText head;
      head.u16(kCamera);
      head.u32(static_cast<std::uint32_t>(i));
      head.u64(i);
      head.u64(i);
      out << record(McapOp::message, head, kPictureBytes);
      out.seekp(static_cast<std::streamoff>(kPictureBytes), std::ios::cur);
    }
    ++chunk;
  });
  ByteText no_checksum;
  no_checksum.u32(0);
  ByteText no_summary;
  no_summary.append(std::string(20, '\0'));
  out << record(McapOp::data_end, no_checksum) << record(McapOp::footer, no_summary) << kMcapMagic;
}

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Where the robot was as mapped and corrected, without the store's own times and the log's name.
std::string path_of(const fs::path& store, const fs::path& said) {
  const fs::path out = store.parent_path() / "out";
  fs::remove_all(out);
  (void)run_roomatlas({"-q", "assemble", store.string()}, said);
  (void)run_roomatlas({"-q", "export", store.string(), "--format", "tum", "-o", out.string()},
                      said);
  return content_of(out / "trajectory_corrected.tum");
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> sizes_gb(argv + 1, argv + argc);
  if (sizes_gb.empty()) sizes_gb = {"0", "5", "50"};
  const fs::path folder = fs::temp_directory_path() / "roomatlas_bench_large_log";
  fs::create_directories(folder);
  const fs::path said = folder / "said.txt";
  const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/eight_rooms.geojson";
  (void)run_roomatlas({"-q", "simulate", world, "--sensor", "laser", "--tour", "--speed", "0.7",
                       "--format", "mcap", "-o", (folder / "mission").string()},
                      said);
  const std::string mission = content_of(folder / "mission" / "mission.mcap");
  std::string first;
  double first_mb = 0.0;
  std::printf("%9s %9s %9s %9s %7s  %s\n", "log (GB)", "time (s)", "cpu (s)", "peak (MB)", "ratio",
              "same path");
  for (const std::string& size_gb : sizes_gb) {
    const fs::path log = folder / "large.mcap";
    write_with_pictures(mission, static_cast<std::uint64_t>(std::stod(size_gb) * 1e9), log);
    const fs::path store = folder / "store.gpkg";
    const Finished mapped =
        run_roomatlas({"-q", "map", log.string(), "-o", store.string(), "--force"}, said);
    const std::string path = path_of(store, said);
    if (first.empty()) first = path;
    if (first_mb == 0.0) first_mb = mapped.peak_mb;
    std::printf("%9.2f %9.1f %9.1f %9.1f %7.2f  %s\n",
                static_cast<double>(fs::file_size(log)) / 1e9, mapped.elapsed_s, mapped.processor_s,
                mapped.peak_mb, mapped.peak_mb / first_mb,
                mapped.exit_code != 0            ? mapped.complaint.c_str()
                : !path.empty() && path == first ? "yes"
                                                 : "no");
    std::fflush(stdout);
  }
  fs::remove_all(folder);
}
