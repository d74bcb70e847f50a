// SPDX-License-Identifier: MIT
#include "statistics.hpp"

#include <algorithm>
#include <bit>
#include <shigusa/dataset.hpp>
#include <shigusa/math.hpp>

#include "task_rows.hpp"

namespace shigusa {
namespace {

// Numbers read at once: memory is that of a few of these blocks.
constexpr std::size_t kBlockBytes = std::size_t{4} << 20;
constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;
constexpr int kDroppedBits = 40;  // of the 52 of a fraction

// Bit pattern whose integer order is that of the numbers.
std::uint64_t ordered_bits(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits & kSignBit) != 0 ? ~bits : bits | kSignBit;
}
double from_ordered_bits(std::uint64_t bits) {
  return std::bit_cast<double>((bits & kSignBit) != 0 ? bits ^ kSignBit : ~bits);
}

void take_extremes(double value, double& least, double& most) {
  if (!(value >= least)) least = value;
  if (!(value <= most)) most = value;
}

// Numbers in either precision.
std::vector<double> numbers_of(const Column& column) {
  if (column.type == ElementType::f64) return column.as<double>();
  if (column.type != ElementType::f32) return {};
  const std::vector<float> narrow = column.as<float>();
  return {narrow.begin(), narrow.end()};
}

void count_texts(const Column& column, Counts& counts) {
  for (const std::string& text : column.texts()) ++counts[text];
}

// Counts the words of a column of bytes; absent words get 0.
void count_words(const Column& column, Counts& counts) {
  for (const std::string& word : column.words) counts.try_emplace(word, 0);
  for (const std::uint8_t value : column.as<std::uint8_t>()) {
    if (value < column.words.size()) ++counts[column.words[value]];
  }
}

void add_numbers(std::span<const double> numbers, Moments& moments) {
  std::vector<Moments> one{moments};
  add_moments(numbers, one);
  moments = one.front();
}

// Series of a table, block after block.
Result<void> add_series(const ShardReader& shard, const std::string& path, std::size_t rows,
                        JointStatistics& series) {
  const std::vector<std::string> name{series.series};
  SHG_TRY_ASSIGN(const Table shape, shard.table(path, name, {0, 0}));
  const std::size_t row_size = std::max<std::size_t>(1, shape.columns.front().row_size());
  const std::size_t step = std::max<std::size_t>(1, kBlockBytes / row_size);
  for (std::size_t first = 0; first < rows; first += step) {
    SHG_TRY_ASSIGN(const Table block, shard.table(path, name, {first, first + step}));
    add_moments(numbers_of(block.columns.front()), series.joints);
  }
  return {};
}

}  // namespace

// Chan, Golub and LeVeque: Updating Formulae and a Pairwise Algorithm for Computing Sample
// Variances (1979).
void Moments::add(const Moments& block) {
  if (block.count == 0) return;
  const auto before = static_cast<double>(count);
  const auto more = static_cast<double>(block.count);
  const double difference = block.mean - mean;
  mean += difference * (more / (before + more));
  squares += block.squares + difference * difference * (before * more / (before + more));
  count += block.count;
  take_extremes(block.least, least, most);
  take_extremes(block.most, least, most);
}

double Moments::deviation() const {
  return count == 0 ? kNoNumber : sqrt(squares / static_cast<double>(count));
}

void add_moments(std::span<const double> rows, std::vector<Moments>& columns) {
  const std::size_t side = columns.size();
  if (side == 0) return;
  std::vector<Moments> block(side);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!is_finite(rows[k])) continue;
    Moments& column = block[k % side];
    ++column.count;
    column.mean += rows[k];
    take_extremes(rows[k], column.least, column.most);
  }
  for (Moments& column : block)
    column.mean /= static_cast<double>(std::max<std::uint64_t>(1, column.count));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!is_finite(rows[k])) continue;
    const double off = rows[k] - block[k % side].mean;
    block[k % side].squares += off * off;
  }
  for (std::size_t k = 0; k < side; ++k) columns[k].add(block[k]);
}

void Quantiles::add(double value) {
  if (!(value == value)) return;
  ++total_;
  ++counts_[ordered_bits(value) >> kDroppedBits];
  take_extremes(value, least_, most_);
}

double Quantiles::at(double share) const {
  if (total_ == 0) return kNoNumber;
  const double rank = share * static_cast<double>(total_ - 1);
  double before = 0.0;
  for (const auto& [bits, count] : counts_) {
    before += static_cast<double>(count);
    if (before <= rank) continue;
    // midpoint of the numbers that share a count
    const std::uint64_t middle = (bits << kDroppedBits) | (std::uint64_t{1} << (kDroppedBits - 1));
    const double value = from_ordered_bits(middle);
    return share <= 0.0 ? least_ : share >= 1.0 ? most_ : clamp(value, least_, most_);
  }
  return most_;
}

Result<void> DatasetStatistics::add_motions(const ShardReader& shard, const std::string& path) {
  SHG_TRY_ASSIGN(const Table table, shard.table(path, {"score", "verdict", "words"}));
  MotionStatistics& into = tables[path];
  const std::vector<double> scores = numbers_of(table.columns[0]);
  for (const double score : scores) into.scores.add(score);
  count_words(table.columns[1], into.verdicts);
  count_texts(table.columns[2], into.postures);
  into.motions += scores.size();
  motions += scores.size();
  if (into.joints.empty()) {
    if (const auto* joints = table.names_of("joints")) into.joints = *joints;
    SHG_TRY_ASSIGN(const Table all, shard.table(path, {}, {0, 0}));
    for (const DatasetSeries series : {DatasetSeries::angles, DatasetSeries::torques}) {
      const std::string name(word_of(series));
      const Column* column = all.find(name);
      if (column == nullptr || column->shape.size() != 2) continue;
      if (column->shape.back() != into.joints.size()) continue;
      into.series.push_back({name, column->unit, std::vector<Moments>(into.joints.size())});
    }
  }
  for (JointStatistics& series : into.series) {
    SHG_TRY(add_series(shard, path, scores.size(), series));
  }
  return {};
}

void DatasetStatistics::add_tasks(const Table& table, const Table& splits) {
  const auto kept = table.find("motions")->as<std::uint16_t>();
  const auto parts_by_person = splits.find("by_person")->as<std::uint8_t>();
  const auto parts_by_region = splits.find("by_region")->as<std::uint8_t>();
  const auto sexes_of = table.find("sex")->as<std::uint8_t>();
  const std::vector<std::string> names = table.find("character")->texts();
  const std::vector<std::string> presets_of = table.find("preset")->texts();
  const std::vector<std::string>& sex_words = table.find("sex")->words;
  tasks += kept.size();
  count_words(*table.find("status"), statuses);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    for (SplitCounts* counts : {&by_person[parts_by_person[k]], &by_region[parts_by_region[k]]}) {
      ++counts->tasks;
      counts->motions += kept[k];
    }
    // a refused task may have no body
    if (static_cast<Split>(parts_by_person[k]) == Split::none) {
      ++refused;
      continue;
    }
    ++characters[names[k]];
    ++presets[presets_of[k]];
    if (sexes_of[k] < sex_words.size()) ++sexes[sex_words[sexes_of[k]]];
  }
  add_numbers(table.find("stature_m")->as<double>(), stature_m);
  add_numbers(table.find("mass_kg")->as<double>(), mass_kg);
  for (const std::uint64_t count : table.find("evaluations")->as<std::uint64_t>()) {
    evaluations += count;
  }
}

void DatasetStatistics::add_goals(const Table& goals) {
  count_texts(*goals.find("effector"), effectors);
  std::vector<Moments> places(goal_m.begin(), goal_m.end());
  add_moments(goals.find("position_m")->as<double>(), places);
  std::copy(places.begin(), places.end(), goal_m.begin());
  std::vector<double> carried = goals.find("load_kg")->as<double>();
  std::erase(carried, 0.0);
  add_numbers(carried, load_kg);
}

void DatasetStatistics::add_missed(const Table& table) {
  // a task's goals are consecutive rows
  std::vector<std::uint64_t> numbers = table.find("task")->as<std::uint64_t>();
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  missed += numbers.size();
}

namespace {

constexpr std::size_t kTextSize = 64;

Column text_column(std::string name, std::string says) {
  return {.name = std::move(name),
          .type = ElementType::text,
          .says = std::move(says),
          .text_size = kTextSize};
}

// Table of words and their counts.
Table counts_table(std::string path, const std::string& says, const Counts& counts) {
  Table table{std::move(path),
              {text_column("word", says), {.name = "count", .type = ElementType::u64}}};
  for (const auto& [word, count] : counts) {
    table["word"].push(std::string_view(word));
    table["count"].push_as(count);
  }
  return table;
}

// Columns NAME_mean, NAME_deviation, … with their numbers.
void add_moments_columns(const std::string& name, const std::string& unit,
                         std::span<const Moments> rows, Table& table) {
  const auto add = [&](const char* what, auto number_of) {
    Column column{.name = name + "_" + what, .unit = unit};
    for (const Moments& row : rows) column.push(number_of(row));
    table.columns.push_back(std::move(column));
  };
  add("mean", [](const Moments& m) { return m.count == 0 ? kNoNumber : m.mean; });
  add("deviation", [](const Moments& m) { return m.deviation(); });
  add("least", [](const Moments& m) { return m.least; });
  add("most", [](const Moments& m) { return m.most; });
}

Table joints_table(const std::string& path, const MotionStatistics& motions) {
  Table table{path + "/joints", {text_column("joint", "of each frame of each motion")}};
  for (const std::string& joint : motions.joints) table["joint"].push(std::string_view(joint));
  for (const JointStatistics& series : motions.series) {
    add_moments_columns(series.series, series.unit, series.joints, table);
  }
  return table;
}

Table scores_table(const std::string& path, const MotionStatistics& motions) {
  Table table{path + "/scores", {{.name = "share"}, {.name = "score"}}};
  table.columns[1].says = "that this share of the motions does not exceed, to a part in 4000";
  for (const double share : kQuantileShares) {
    table["share"].push(share);
    table["score"].push(motions.scores.at(share));
  }
  return table;
}

Table quantities_table(const DatasetStatistics& all) {
  Table table{"/statistics/quantities",
              {text_column("quantity", "of the tasks' bodies and goals")}};
  const std::vector<Moments> rows{all.stature_m, all.mass_kg,   all.load_kg,
                                  all.goal_m[0], all.goal_m[1], all.goal_m[2]};
  for (const char* name : {"stature_m", "mass_kg", "load_kg", "goal_x_m", "goal_y_m", "goal_z_m"}) {
    table["quantity"].push(std::string_view(name));
  }
  Column count{.name = "count", .type = ElementType::u64};
  for (const Moments& row : rows) count.push_as(row.count);
  table.columns.push_back(std::move(count));
  add_moments_columns("value", "", rows, table);
  return table;
}

Table split_table(const char* path, const SplitShares& shares) {
  Table table{path,
              {text_column("split", ""),
               {.name = "tasks", .type = ElementType::u64},
               {.name = "motions", .type = ElementType::u64}}};
  for (const auto& [split, word] : kEnumWords<Split>) {
    const SplitCounts& counts = shares[static_cast<std::size_t>(split)];
    table["split"].push(word);
    table["tasks"].push_as(counts.tasks);
    table["motions"].push_as(counts.motions);
  }
  return table;
}

// JSON has no NaN.
Json number_or_null(double value) { return is_finite(value) ? Json(value) : Json(nullptr); }

Json json_of(const Moments& moments) {
  return {{"mean", number_or_null(moments.count == 0 ? kNoNumber : moments.mean)},
          {"deviation", number_or_null(moments.deviation())},
          {"least", number_or_null(moments.least)},
          {"most", number_or_null(moments.most)}};
}

// An object of lists, one number per joint.
Json json_of(const JointStatistics& series) {
  Json lists{{"unit", series.unit}};
  for (const Moments& joint : series.joints) {
    const Json one = json_of(joint);
    for (const auto& [key, value] : one.items()) lists[key].push_back(value);
  }
  return lists;
}

Json json_of(const Counts& counts) {
  Json json = Json::object();
  for (const auto& [word, count] : counts) json[word] = count;
  return json;
}

Json json_of(const SplitShares& shares) {
  Json json;
  for (const auto& [split, word] : kEnumWords<Split>) {
    const SplitCounts& counts = shares[static_cast<std::size_t>(split)];
    json[std::string(word)] = {{"tasks", counts.tasks}, {"motions", counts.motions}};
  }
  return json;
}

Json json_of(const MotionStatistics& motions) {
  Json scores = Json::array();
  for (const double share : kQuantileShares) {
    scores.push_back({{"share", share}, {"score", number_or_null(motions.scores.at(share))}});
  }
  Json json{{"motions", motions.motions},
            {"verdicts", json_of(motions.verdicts)},
            {"postures", json_of(motions.postures)},
            {"scores", scores},
            {"joints", motions.joints}};
  for (const JointStatistics& series : motions.series) json[series.series] = json_of(series);
  return json;
}

}  // namespace

std::vector<Table> tables_of(const DatasetStatistics& all) {
  std::vector<Table> tables;
  tables.push_back(counts_table("/statistics/statuses", "tasks by status", all.statuses));
  tables.push_back(counts_table("/statistics/characters", "tasks by character", all.characters));
  tables.push_back(counts_table("/statistics/presets", "tasks by preset", all.presets));
  tables.push_back(counts_table("/statistics/sexes", "tasks by sex", all.sexes));
  tables.push_back(counts_table("/statistics/effectors", "goals by effector", all.effectors));
  tables.push_back(quantities_table(all));
  tables.push_back(split_table("/statistics/by_person", all.by_person));
  tables.push_back(split_table("/statistics/by_region", all.by_region));
  for (const auto& [path, motions] : all.tables) {
    const std::string place = "/statistics" + path;
    tables.push_back(counts_table(place + "/verdicts", "motions by verdict", motions.verdicts));
    tables.push_back(
        counts_table(place + "/postures", "motions by how they end", motions.postures));
    tables.push_back(scores_table(place, motions));
    tables.push_back(joints_table(place, motions));
  }
  return tables;
}

Json json_of(const DatasetStatistics& all) {
  const auto searched = static_cast<double>(all.tasks - all.refused);
  Json json{
      {"tasks", all.tasks},
      {"motions", all.motions},
      {"refused", all.refused},
      {"missed", all.missed},
      {"missed_share",
       number_or_null(searched > 0.0 ? static_cast<double>(all.missed) / searched : kNoNumber)},
      {"evaluations", all.evaluations},
      {"statuses", json_of(all.statuses)},
      {"characters", json_of(all.characters)},
      {"presets", json_of(all.presets)},
      {"sexes", json_of(all.sexes)},
      {"effectors", json_of(all.effectors)},
      {"stature_m", json_of(all.stature_m)},
      {"mass_kg", json_of(all.mass_kg)},
      {"load_kg", json_of(all.load_kg)},
      {"goal_m", {json_of(all.goal_m[0]), json_of(all.goal_m[1]), json_of(all.goal_m[2])}},
      {"splits", {{"by_person", json_of(all.by_person)}, {"by_region", json_of(all.by_region)}}}};
  for (const auto& [path, motions] : all.tables) json["tables"][path] = json_of(motions);
  return json;
}

}  // namespace shigusa
