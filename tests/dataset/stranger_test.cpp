// SPDX-License-Identifier: MIT
// A data set may come from an untrusted source: whatever its shards contain, nothing crashes, no
// other file is read, and the shard is named.
#include "dataset/stranger.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <random>
#include <shigusa/dataset_check.hpp>
#include <shigusa/dataset_export.hpp>
#include <shigusa/dataset_merge.hpp>
#include <shigusa/dataset_read.hpp>

#include "dataset/data_rows.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

constexpr const char* kSecret = "what is in a file of the person's own";

class Stranger : public testing::Test {
 protected:
  Stranger() {
    Json json = small_plan(3, 3);
    json["series"] = {"angles", "nodes", "positions", "contacts"};
    json["motions"] = "all";
    const DatasetPlan plan = plan_of_json(json);
    EXPECT_TRUE(keep_plan(plan, folder_.path()));
    made(plan, {.folder = folder_.path(), .threads = 1});
  }

  [[nodiscard]] Result<DataExportRun> exported() const {
    return export_dataset({.from = folder_.path(), .to = out_.path(), .force = true});
  }
  // Reads all columns of all motions.
  [[nodiscard]] Result<void> read() const {
    SHG_TRY_ASSIGN(const ShardReader reader, ShardReader::open(folder_ / shard_name(0)));
    SHG_TRY_ASSIGN(const std::vector<std::string> paths, reader.motion_tables());
    for (const std::string& path : paths) SHG_TRY(reader.table(path));
    return {};
  }
  // Every reader of the set must name the shard.
  void expect_refused(const std::string& what) const {
    std::vector<std::string> said;
    const auto add = [&said](const auto& result) {
      said.push_back(result ? "" : result.error().to_string());
    };
    add(read());
    if (has_mannequin()) add(exported());
    add(merge_dataset(folder_.path()));
    add(read_motions(folder_.path(), [](const DatasetMotion&) {}));
    for (std::size_t k = 0; k < said.size(); ++k) {
      EXPECT_THAT(said[k], HasSubstr("shard-000000.h5")) << what << ", reader " << k;
    }
    const auto run = check_dataset(folder_.path(), {.share = 1.0});
    ASSERT_TRUE(run);
    EXPECT_GE(run->problem_count, 1u) << what;
  }
  // Puts a number into the first row of a column of the motions.
  void put_number(const std::string& column, double value) const {
    change_tables(folder_, [&](Table& table) {
      if (!table.path.starts_with(kMotionsGroup)) return;
      Column& own = table[column];
      Column wrong{.name = column, .type = own.type};
      wrong.push(value);
      own.bytes.replace(0, wrong.bytes.size(), wrong.bytes);
    });
  }
  // The column of that name made anew, otherwise.
  void remake(const std::string& column, hid_t type, const std::vector<hsize_t>& sides,
              const std::function<void(hid_t)>& creation) {
    const std::string path = motions_of(folder_) + "/" + column;
    change_file(folder_, [&](hid_t file) {
      H5Ldelete(file, path.c_str(), H5P_DEFAULT);
      const hid_t space = H5Screate_simple(static_cast<int>(sides.size()), sides.data(), nullptr);
      const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
      creation(list);
      const hid_t made =
          H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT);
      EXPECT_GE(made, 0) << column;
      H5Dclose(made);
      H5Pclose(list);
      H5Sclose(space);
    });
  }
  WorkFolder folder_;
  WorkFolder out_;
};

TEST_F(Stranger, ListsOfOtherSizesThanTheirTableAreRefused) {
  for (const char* list : {"criteria", "parameters", "nodes", "node_parents", "joints", "feet"}) {
    const std::string before = folder_.get(shard_name(0));
    for (const int more : {-2, -1, 3}) {
      change_tables(folder_, [&](Table& table) {
        for (auto& [what, names] : table.names) {
          const auto size = static_cast<int>(names.size());
          if (what == list) names.resize(static_cast<std::size_t>(std::max(0, size + more)), "x");
        }
      });
      // a data set of half a body has a foot or none
      if (folder_.get(shard_name(0)) != before) expect_refused(list);
      folder_.put(shard_name(0), before);
    }
  }
}

TEST_F(Stranger, ATableWithoutAListOrAColumnIsRefused) {
  const std::string before = folder_.get(shard_name(0));
  change_tables(folder_, [](Table& table) {
    if (table.path.starts_with(kMotionsGroup)) table.names.erase(table.names.begin() + 1);
  });
  expect_refused("a list");
  folder_.put(shard_name(0), before);
  change_tables(folder_, [](Table& table) {
    std::erase_if(table.columns, [](const Column& one) { return one.name == "effector"; });
  });
  expect_refused("a column");
}

TEST_F(Stranger, NodesThatAreTheirOwnParentsAreRefused) {
  change_tables(folder_, [](Table& table) {
    for (auto& [what, names] : table.names) {
      if (what == "node_parents") names[1] = *std::next(table.names_of("nodes")->begin());
    }
  });
  expect_refused("a ring of nodes");
}

TEST_F(Stranger, NoOtherFileIsReadForItsBytes) {
  folder_.put("secret", std::string(kSecret) + std::string(64 * 6, 'x'));
  const std::string path = (folder_ / "secret").string();
  hid_t text = H5Tcopy(H5T_C_S1);
  H5Tset_size(text, 64);
  const std::size_t rows = ShardReader::open(folder_ / shard_name(0))
                               .value()
                               .table(motions_of(folder_), {"words"})
                               .value()
                               .rows();
  remake("words", text, {rows},
         [&](hid_t list) { H5Pset_external(list, path.c_str(), 0, rows * 64); });
  H5Tclose(text);
  expect_refused("bytes elsewhere");
  for (const auto& [name, bytes] : out_.contents()) {
    EXPECT_EQ(bytes.find(kSecret), std::string::npos) << name;
  }
}

TEST_F(Stranger, LinksAndDatasetsOfDatasetsAreRefused) {
  const std::string before = folder_.get(shard_name(0));
  const std::string score = motions_of(folder_) + "/score";
  change_file(folder_, [&](hid_t file) {
    H5Ldelete(file, score.c_str(), H5P_DEFAULT);
    H5Lcreate_soft("/tasks/stature_m", file, score.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  });
  expect_refused("a soft link");
  folder_.put(shard_name(0), before);
  folder_.put("other.h5", before);
  change_file(folder_, [&](hid_t file) {
    H5Ldelete(file, score.c_str(), H5P_DEFAULT);
    H5Lcreate_external("other.h5", score.c_str(), file, score.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  });
  expect_refused("an external link");
  folder_.put(shard_name(0), before);
  remake("score", H5T_IEEE_F64LE, {6}, [&](hid_t list) {
    const hsize_t all = 6;
    const hid_t space = H5Screate_simple(1, &all, nullptr);
    H5Pset_virtual(list, space, "other.h5", score.c_str(), space);
    H5Sclose(space);
  });
  expect_refused("a virtual dataset");
}

TEST_F(Stranger, OtherLayoutsFiltersAndTypesAreRefused) {
  const std::string before = folder_.get(shard_name(0));
  const auto none = [](hid_t) {};
  const auto chunks = [](hid_t list) {
    const hsize_t rows = 2;
    H5Pset_chunk(list, 1, &rows);
  };
  const hid_t pair = H5Tcreate(H5T_COMPOUND, 8);
  H5Tinsert(pair, "a", 0, H5T_STD_U32LE);
  H5Tinsert(pair, "b", 4, H5T_STD_U32LE);
  const struct {
    const char* what;
    hid_t type;
    std::vector<hsize_t> sides;
    std::function<void(hid_t)> creation;
  } cases[] = {
      {"compact", H5T_IEEE_F64LE, {6}, [](hid_t list) { H5Pset_layout(list, H5D_COMPACT); }},
      {"a filter of others",
       H5T_IEEE_F64LE,
       {6},
       [&](hid_t list) {
         chunks(list);
         H5Pset_nbit(list);
       }},
      {"a compound", pair, {6}, none},
      {"the other byte first", H5T_IEEE_F64BE, {6}, none},
      {"signed", H5T_STD_I64LE, {6}, none},
      {"narrow", H5T_IEEE_F32LE, {6}, none},
      {"wide rows", H5T_IEEE_F64LE, {6, 4}, none},
      {"no rows at all", H5T_IEEE_F64LE, {}, none},
      {"more sides", H5T_IEEE_F64LE, {6, 1, 1, 1, 1}, none},
      {"very many rows",
       H5T_IEEE_F64LE,
       {hsize_t{1} << 40},
       [&](hid_t list) {
         const hsize_t rows = hsize_t{1} << 20;
         H5Pset_chunk(list, 1, &rows);
       }},
      {"rows that are not there", H5T_IEEE_F64LE, {6}, chunks},
  };
  for (const auto& one : cases) {
    remake("score", one.type, one.sides, one.creation);
    expect_refused(one.what);
    folder_.put(shard_name(0), before);
  }
  H5Tclose(pair);
}

TEST_F(Stranger, NumbersThatNoMotionHasAreRefused) {
  const std::string before = folder_.get(shard_name(0));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr std::pair<const char*, double> kWrong[] = {{"duration_s", kNoNumber},
                                                       {"duration_s", kInfinity},
                                                       {"duration_s", -1.25},
                                                       {"duration_s", 0.0},
                                                       {"duration_s", 3e7},
                                                       {"score", kNoNumber},
                                                       {"rank", 0.0},
                                                       {"verdict", 200.0},
                                                       {"error_m", kInfinity},
                                                       {"nodes", 7.0},
                                                       {"root_m", -kInfinity},
                                                       {"positions", 1e30},
                                                       {"contacts", 9.0}};
  for (const auto& [column, value] : kWrong) {
    put_number(column, value);
    const auto done = read();
    ASSERT_FALSE(done) << column << " " << value;
    EXPECT_THAT(done.error().to_string(), HasSubstr("shard-000000.h5")) << column;
    EXPECT_THAT(done.error().to_string(), HasSubstr(column)) << value;
    folder_.put(shard_name(0), before);
  }
}

TEST_F(Stranger, TextsThatAreNoneAreRefused) {
  const std::string before = folder_.get(shard_name(0));
  for (const char* wrong : {"a\n", "\xFF\xFE", "\x7F."}) {
    change_tables(folder_, [wrong](Table& table) {
      for (Column& one : table.columns) {
        if (one.name == "effector") one.bytes.replace(0, 2, wrong);
      }
    });
    EXPECT_FALSE(read_motions(folder_.path(), [](const DatasetMotion&) {})) << wrong;
    folder_.put(shard_name(0), before);
  }
}

TEST_F(Stranger, AMotionThatIsThereTwiceIsRefused) {
  change_tables(folder_, [](Table& table) {
    if (!table.path.starts_with(kMotionsGroup)) return;
    for (Column& one : table.columns) one.bytes += one.bytes.substr(0, one.row_size());
  });
  const auto done = read_motions(folder_.path(), [](const DatasetMotion&) {});
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().to_string(), HasSubstr("twice"));
}

// With any byte of the file changed, it is read, or refused.
TEST_F(Stranger, AnyByteMayBeAnother) {
  const std::string bytes = folder_.get(shard_name(0));
  const ShardHead head = parse_head(bytes).value();
  std::mt19937 random(7);
  int refused = 0;
  for (int k = 0; k < 400; ++k) {
    std::string image = bytes.substr(kHeadSize);
    for (int n = 0; n < 4; ++n) image[random() % image.size()] = static_cast<char>(random());
    folder_.put(shard_name(0), with_head(head, image));
    const DataFolder data = DataFolder::open(folder_.path()).value();
    if (!read() || !read_rows(data, 0)) ++refused;
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace shigusa
