// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "export_index.hpp"
#include "export_writer.hpp"

namespace shigusa {
namespace {

// One number of a series in each frame.
struct SeriesColumn {
  std::string name;
  const Column* column;
  std::size_t first;  // place of its number in the first frame
  std::size_t step;   // from one frame to the next
};

// Column names of a frame: "right_knee.flexion [rad]", "hips.x [m]", "hips.qw", "left_foot".
std::vector<std::string> names_of(const Table& table, const Column& column) {
  const auto all = [&](const char* list, std::initializer_list<const char*> ends) {
    std::vector<std::string> names;
    for (const std::string& name : *table.names_of(list)) {
      for (const char* end : ends) names.push_back(name + end);
    }
    return names;
  };
  if (column.name == "angles") return all("joints", {" [rad]"});
  if (column.name == "torques") return all("joints", {" torque [N m]"});
  if (column.name == "nodes") return all("nodes", {".qx", ".qy", ".qz", ".qw"});
  if (column.name == "positions") return all("nodes", {".x [m]", ".y [m]", ".z [m]"});
  if (column.name == "contacts") return all("feet", {" stands on"});
  if (column.name == "actions") return {"action"};
  if (column.name == "things") {
    return all("things", {".x [m]", ".y [m]", ".z [m]", ".qx", ".qy", ".qz", ".qw"});
  }
  if (column.name == "pressure") return {"pressure.x [m]", "pressure.z [m]"};
  if (column.name == "root_m") return {"root.x [m]", "root.y [m]", "root.z [m]"};
  if (column.name == "centre_of_mass") {
    return {"centre_of_mass.x [m]", "centre_of_mass.y [m]", "centre_of_mass.z [m]"};
  }
  return {};
}

std::vector<SeriesColumn> series_of(const Table& table, std::size_t& frames) {
  std::vector<SeriesColumn> all;
  for (const Column& column : table.columns) {
    if (column.shape.size() < 2) continue;
    const std::vector<std::string> names = names_of(table, column);
    for (std::size_t k = 0; k < names.size(); ++k) {
      all.push_back({names[k], &column, k, names.size()});
      frames = column.shape[0];
    }
  }
  return all;
}

std::string series_text(const DataMotion& motion) {
  const Row& row = motion.motion;
  std::size_t frames = 0;
  const std::vector<SeriesColumn> columns = series_of(*row.table, frames);
  CsvLine line;
  line.add("time [s]");
  for (const SeriesColumn& column : columns) line.add(column.name);
  std::string text = line.take();
  const double duration = row.number("duration_s");
  for (std::size_t f = 0; f < frames; ++f) {
    line.add(duration * static_cast<double>(f) / static_cast<double>(frames - 1));
    for (const SeriesColumn& one : columns) {
      const std::size_t place = one.first + f * one.step;
      if (one.column->words.empty()) {
        line.add(*one.column, row.at, place);
      } else {
        line.add(
            one.column->words[static_cast<std::size_t>(number_in(*one.column, row.at, place))]);
      }
    }
    text += line.take();
  }
  return text;
}

class CsvWriter : public DataWriter {
 public:
  explicit CsvWriter(const ExportJob& job) : job_(job) {}

  [[nodiscard]] std::vector<DatasetSeries> series() const override {
    return job_.settings.series ? job_.data.plan.series() : std::vector<DatasetSeries>{};
  }
  Result<void> add(const DataMotion& motion) override {
    if (index_.motions() == 0) SHG_TRY(index_.begin(job_));
    std::string file;
    if (job_.settings.series) {
      file = motion_file(motion, "csv");
      SHG_TRY(job_.folder.put(file, series_text(motion)));
    }
    return index_.add(motion, file);
  }
  Result<void> finish() override {
    SHG_TRY(index_.finish());
    std::string text = about_export(job_, index_.motions());
    text +=
        "\n`index.csv` has a row a motion: its numbers, those of its task (`goal1.…`), its "
        "criteria's penalties (`penalties.…`) and the parameters that it is made from "
        "(`parameters.…`; empty where locked). Units stand in the names: metres, radians, seconds, "
        "kilograms; y is up, the body faces z, its left is x.\n";
    if (job_.settings.series) {
      text +=
          "`motions/` has a file a motion: a row a frame, of equal times over its duration, and "
          "the "
          "series that the data set keeps.\n";
    }
    return job_.folder.put("README.md", text);
  }

 private:
  const ExportJob& job_;
  ExportIndex index_;
};

}  // namespace

template <>
Result<std::unique_ptr<DataWriter>> make_writer<DataFormat::csv>(const ExportJob& job) {
  if (job.settings.series && job.data.plan.series().empty()) {
    return fail(ErrorCode::invalid_argument, "the data set keeps no series: leave --series out",
                "--series");
  }
  return std::make_unique<CsvWriter>(job);
}

}  // namespace shigusa
