// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "dataset/hdf5.hpp"
#include "dataset/plans.hpp"
#include "dataset/task_rows.hpp"

// Manipulated shards: their checksums are right, and their content is not.
namespace shigusa::testing_support {

// Rewrites a shard, with its checksum, after a change of its tables.
inline void change_shard(const WorkFolder& folder, std::uint64_t shard,
                         const std::function<void(std::vector<Table>&)>& change) {
  const std::string name = shard_name(shard);
  std::vector<Table> tables;
  std::string text;
  ShardHead head;
  {
    const ShardReader reader = ShardReader::open(folder / name).value();
    std::vector<std::string> paths = reader.motion_tables().value();
    for (const Table& table : empty_tables()) paths.push_back(table.path);
    for (const std::string& path : paths) tables.push_back(reader.table(path).value());
    text = reader.plan_text().value();
    head = reader.head();
  }
  change(tables);
  folder.put(name, format_shard(head, text, tables).value());
}

// Changes each table of the first shard.
inline void change_tables(const WorkFolder& folder, const std::function<void(Table&)>& change) {
  change_shard(folder, 0, [&change](std::vector<Table>& tables) {
    for (Table& table : tables) change(table);
  });
}

// Changes the HDF5 bytes of a shard.
inline void change_file(const WorkFolder& folder, const std::function<void(hid_t)>& change) {
  const std::string name = shard_name(0);
  const std::string bytes = folder.get(name);
  const ShardHead head = parse_head(bytes).value();
  folder.put("image", bytes.substr(kHeadSize));
  hdf5::be_quiet();
  const hid_t file = H5Fopen((folder / "image").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  change(file);
  ASSERT_GE(H5Fclose(file), 0);
  folder.put(name, with_head(head, folder.get("image")));
  std::filesystem::remove(folder / "image");
}

// The group of a shard's motions.
inline std::string motions_of(const WorkFolder& folder) {
  return ShardReader::open(folder / shard_name(0)).value().motion_tables().value().front();
}

}  // namespace shigusa::testing_support
