// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <shigusa/dataset_export.hpp>
#include <string>
#include <vector>

#include "data_rows.hpp"
#include "files/staging.hpp"

namespace shigusa {

// Output folder of an export. Files are completed in one staging folder and renamed, as write_file
// would scan the folder each time.
class ExportFolder {
 public:
  // Fails if the folder is not writable.
  [[nodiscard]] Result<void> open(const std::filesystem::path& path);
  // Writes a file of the folder, such as "motions/0000/000012-1.npz", creating its parent folders.
  [[nodiscard]] Result<void> put(const std::string& name, std::string_view bytes);

 private:
  Staging staging_;
  std::string last_;  // folder that was made last
};

// An export in progress. Borrows all members.
struct ExportJob {
  const DataExportSettings& settings;
  const DataFolder& data;
  ExportFolder& folder;
  double rate = 0.0;  // Hz, of forms that have one
};

// Writer of motions in one format, one after the other.
class DataWriter {
 public:
  DataWriter() = default;
  DataWriter(const DataWriter&) = delete;
  DataWriter& operator=(const DataWriter&) = delete;
  virtual ~DataWriter() = default;

  // Series that it reads of motions.
  [[nodiscard]] virtual std::vector<DatasetSeries> series() const = 0;
  // Writes one motion; ErrorCode::unsupported skips it, any other error ends the export.
  [[nodiscard]] virtual Result<void> add(const DataMotion& motion) = 0;
  // Writes the files about all motions.
  [[nodiscard]] virtual Result<void> finish() = 0;
  // Adds counts specific to the format.
  virtual void count(DataExportRun&) const {}
};

// Writer of a format; each has one.
template <DataFormat format>
[[nodiscard]] Result<std::unique_ptr<DataWriter>> make_writer(const ExportJob& job);
template <>
Result<std::unique_ptr<DataWriter>> make_writer<DataFormat::npz>(const ExportJob& job);
template <>
Result<std::unique_ptr<DataWriter>> make_writer<DataFormat::humanml3d>(const ExportJob& job);
template <>
Result<std::unique_ptr<DataWriter>> make_writer<DataFormat::csv>(const ExportJob& job);
template <>
Result<std::unique_ptr<DataWriter>> make_writer<DataFormat::glb>(const ExportJob& job);

// File of a motion, "motions/0000/000012-1.npz": a folder per thousand tasks, as folders of very
// many files are slow.
[[nodiscard]] std::string motion_file(const DataMotion& motion, std::string_view ending);

// Beginning of a README.md: source and selection of the motions.
[[nodiscard]] std::string about_export(const ExportJob& job, std::uint64_t motions);

}  // namespace shigusa
