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

// The folder that an export fills. Its files are made beside their places and moved there whole, by
// one folder for all of them: write_file looks through the folder each time.
class ExportFolder {
 public:
  // Fails where nothing can be written there.
  [[nodiscard]] Result<void> open(const std::filesystem::path& path);
  // Makes a file of the folder, "motions/0000/000012-1.npz", and the folders that it is in.
  [[nodiscard]] Result<void> put(const std::string& name, std::string_view bytes);

 private:
  Staging staging_;
  std::string last_;  // folder that was made last
};

// An export that is under way. Borrows all of it.
struct ExportJob {
  const DataExportSettings& settings;
  const DataFolder& data;
  ExportFolder& folder;
  double rate = 0.0;  // Hz, of forms that have one
};

// Writes motions in one form into the folder, one after the other.
class DataWriter {
 public:
  DataWriter() = default;
  DataWriter(const DataWriter&) = delete;
  DataWriter& operator=(const DataWriter&) = delete;
  virtual ~DataWriter() = default;

  // The series that it reads of motions.
  [[nodiscard]] virtual std::vector<DatasetSeries> series() const = 0;
  // Writes one motion; an error of ErrorCode::unsupported leaves it out, any other ends the export.
  [[nodiscard]] virtual Result<void> add(const DataMotion& motion) = 0;
  // Writes what tells of all motions.
  [[nodiscard]] virtual Result<void> finish() = 0;
  // Adds what only this form counts.
  virtual void count(DataExportRun&) const {}
};

// The writer of a form; each has one.
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

// "motions/0000/000012-1.npz": a folder for every thousand tasks, as folders of very many files are
// slow.
[[nodiscard]] std::string motion_file(const DataMotion& motion, std::string_view ending);

// The beginning of a README.md: where the motions are from and which they are.
[[nodiscard]] std::string about_export(const ExportJob& job, std::uint64_t motions);

}  // namespace shigusa
