// SPDX-License-Identifier: MIT
// shigusa_people sets generated motions beside recorded people and writes docs/people.md.
#include <fstream>
#include <iostream>
#include <iterator>
#include <string_view>

#include "evenness.hpp"
#include "gaze.hpp"
#include "jolts.hpp"
#include "persons.hpp"
#include "recorded_man.hpp"
#include "regularities.hpp"

namespace {

using namespace shigusa;
using namespace shigusa::bench;

constexpr const char* kUsage =
    "usage: shigusa_people DOCS_FOLDER SHARED_FOLDER [REGULARITIES_FOLDER]\n"
    "       shigusa_people --only SECTION [SHARED_FOLDER [REGULARITIES_FOLDER]]\n";

// Where what people do is read from.
struct Sources {
  std::filesystem::path shared;
  std::filesystem::path regularities;  // what regularities.py has written; may be empty
};

// A part of the page after the recorded man's.
struct Section {
  std::string_view name;  // of --only
  Result<std::string> (*text)(const Sources&);
};
constexpr std::array kSections{
    Section{"regularities",
            [](const Sources& from) { return regularities_section(from.regularities); }},
    Section{"persons",
            [](const Sources& from) {
              return persons_section(from.shared / "people" / "reaches.tsv");
            }},
    Section{"evenness", [](const Sources&) -> Result<std::string> { return evenness_section(); }},
    Section{"jolts", [](const Sources&) -> Result<std::string> { return jolts_section(); }},
    Section{"gaze", [](const Sources&) -> Result<std::string> { return gaze_section(); }},
};

int fault(const Error& error) {
  std::cerr << "shigusa_people: " << error.to_string() << "\n";
  return 2;
}

int print_only(std::string_view name, const Sources& sources) {
  for (const Section& section : kSections) {
    if (section.name != name) continue;
    const Result<std::string> text = section.text(sources);
    if (!text) return fault(text.error());
    std::cout << *text;
    return 0;
  }
  std::cerr << "shigusa_people: no section " << name << "; there are";
  for (const Section& section : kSections) std::cerr << " " << section.name;
  std::cerr << "\n";
  return 2;
}

Result<void> write_pictures(const std::vector<Compared>& man, const std::filesystem::path& docs) {
  SHG_TRY_ASSIGN(const auto pictures, people_pictures(man));
  const std::filesystem::path images = docs / "images" / "people";
  std::filesystem::create_directories(images);
  for (const NamedPicture& picture : pictures) {
    std::ofstream(images / (picture.name + ".svg"), std::ios::binary) << picture.svg;
  }
  return {};
}

Result<void> write_page(const std::filesystem::path& docs, const Sources& sources) {
  SHG_TRY_ASSIGN(const std::vector<Compared> man, recorded_man(sources.shared / "reach"));
  std::string page = people_page(man);
  for (const Section& section : kSections) {
    SHG_TRY_ASSIGN(const std::string text, section.text(sources));
    page += "\n" + text;
  }
  page += "\n" + reaches_section(man);
  SHG_TRY(write_pictures(man, docs));
  std::ifstream remarks(docs / "people_remarks.md", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(remarks), {}};
  std::ofstream(docs / "people.md", std::ios::binary) << page << "\n" << text;
  std::cout << (docs / "people.md").string() << "\n";
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> words(argv + 1, argv + argc);
  const bool only = !words.empty() && words[0] == "--only";
  const std::size_t first = only ? 2 : 1;  // of the sources
  if (words.size() < 2 || words.size() > first + 2) {
    std::cerr << kUsage;
    return 2;
  }
  const Sources sources{words.size() > first ? words[first] : "../shared",
                        words.size() > first + 1 ? words[first + 1] : ""};
  if (only) return print_only(words[1], sources);
  const Result<void> written = write_page(words[0], sources);
  return written ? 0 : fault(written.error());
}
