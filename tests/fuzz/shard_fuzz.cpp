// SPDX-License-Identifier: MIT
// From the HDF5 bytes of a data set's shard, with a corrected checksum, to its rows and its index:
// no crash, hang or memory exhaustion.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <shigusa/dataset_check.hpp>
#include <shigusa/dataset_merge.hpp>
#include <shigusa/dataset_read.hpp>
#include <string>
#include <string_view>

#include "dataset/data_rows.hpp"
#include "dataset/index_reader.hpp"
#include "files/file.hpp"

namespace {

using namespace shigusa;

// The plan of tests/fuzz/shard_corpus, and a folder for one of its shards.
struct Folder {
  std::filesystem::path path;
  DatasetPlan plan;

  Folder() : path(made_folder()), plan(DatasetPlan::parse(kText, "plan.json", path).value()) {
    if (!keep_plan(plan, path)) std::abort();
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  static std::filesystem::path made_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "shard_fuzz-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) std::abort();
    return name;
  }
  static constexpr std::string_view kText = R"({
    "tasks": 2, "seed": 7, "shard_tasks": 2, "motions": "all",
    "series": ["nodes", "contacts"],
    "task": {"character": {"source": "half_body"}, "candidates": 1, "evaluations": 20,
             "goals": [{"effector": "right_hand",
                        "position_m": {"box_m": [[-0.4, 0.6, 0.2], [0.1, 1.5, 0.5]]}}]}})";
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  std::string image(reinterpret_cast<const char*>(data), size);
  const std::filesystem::path path = folder.path / shard_name(0);
  const ShardHead head{.plan = folder.plan.digest(), .shard = 0, .tasks = folder.plan.tasks_of(0)};
  if (!write_file(path, with_head(head, std::move(image)))) std::abort();
  (void)listed_shards(path);
  const Result<DataFolder> opened = DataFolder::open(folder.path);
  if (!opened) std::abort();
  if (!read_rows(*opened, 0)) return 0;
  (void)merge_dataset(folder.path);
  (void)read_motions(folder.path, [](const DatasetMotion&) {});
  return 0;
}
