// SPDX-License-Identifier: MIT
#include <map>

#include "fbx_records.hpp"

namespace shigusa {
namespace {

// Properties of version 6 lack the label of later ones.
void rename_properties(FbxRecord& record) {
  for (FbxRecord& list : record.within) {
    if (list.name != "Properties60") continue;
    list.name = "Properties70";
    for (FbxRecord& property : list.within) {
      property.name = "P";
      if (property.values.size() > 2) property.values.emplace(property.values.begin() + 2);
    }
  }
}

}  // namespace

void take_as_version_7(FbxRecord& root) {
  std::map<std::string_view, std::int64_t> ids{{"Model::Scene", 0}, {{"Scene\0\1Model", 12}, 0}};
  std::vector<FbxRecord> settings;
  std::int64_t models = 0;
  for (FbxRecord& section : root.within) {
    rename_properties(section);
    if (section.name != "Objects") continue;
    for (FbxRecord& record : section.within) {
      rename_properties(record);
      if (record.name == "GlobalSettings") settings.push_back(record);
      if (record.name != "Model") continue;
      ids.emplace(record.text(0), ++models);
      record.values.insert(record.values.begin(), {{}, 0.0, models});
    }
  }
  for (FbxRecord& section : root.within) {
    if (section.name != "Connections") continue;
    for (FbxRecord& link : section.within) {
      link.name = "C";
      for (FbxValue& value : link.values) {
        const auto found = ids.find(value.text);
        value.integer = found == ids.end() ? -1 : found->second;
      }
    }
  }
  root.within.insert(root.within.end(), settings.begin(), settings.end());
}

}  // namespace shigusa
