// SPDX-License-Identifier: MIT
// shigusa_people compares generated motions with recorded people and writes docs/people.md.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <string_view>

#include "candidates.hpp"
#include "evenness.hpp"
#include "gaze.hpp"
#include "jolts.hpp"
#include "persons.hpp"
#include "pictures_section.hpp"
#include "recorded_man.hpp"
#include "regularities.hpp"

namespace {

using namespace shigusa;
using namespace shigusa::bench;

constexpr const char* kUsage =
    "usage: shigusa_people DOCS_FOLDER SHARED_FOLDER [REGULARITIES_FOLDER]\n"
    "       shigusa_people --only SECTION DOCS_FOLDER SHARED_FOLDER [REGULARITIES_FOLDER]\n"
    "       shigusa_people --print SECTION SHARED_FOLDER [REGULARITIES_FOLDER]\n"
    "--only measures one section anew and keeps the rest of the page; --print leaves the page "
    "alone\n";

// Sources of data on people.
struct Sources {
  std::filesystem::path shared;
  std::filesystem::path regularities;  // output of regularities.py; may be empty
};

Result<Drawn> words_alone(Result<std::string> text) {
  if (!text) return tl::unexpected(text.error());
  return Drawn{std::move(*text)};
}

// A section of the page after the recorded man's: everything from its title to the next one.
struct Section {
  std::string_view name;  // of --only
  std::string_view title;
  Result<Drawn> (*made)(const Sources&);
};
constexpr std::array kSections{
    Section{
        "regularities", "What people do",
        [](const Sources& from) { return words_alone(regularities_section(from.regularities)); }},
    Section{"pictures", "What it looks like",
            [](const Sources& from) { return pictures_section(from.shared); }},
    Section{"persons", "Recorded persons",
            [](const Sources& from) {
              return words_alone(persons_section(from.shared / "people" / "reaches.tsv"));
            }},
    Section{"candidates", "Candidates",
            [](const Sources&) { return words_alone(candidates_section()); }},
    Section{"evenness", "Evenness", [](const Sources&) { return words_alone(evenness_section()); }},
    Section{"jolts", "Jolts", [](const Sources&) { return words_alone(jolts_section()); }},
    Section{"gaze", "Gaze", [](const Sources&) { return words_alone(gaze_section()); }},
};
// The other sections; the beginning of the page and the reaches are the recorded man's.
constexpr std::string_view kMan = "man";
constexpr std::string_view kReaches = "Reach by reach";
constexpr std::string_view kRemarks = "remarks";

int fault(const Error& error) {
  std::cerr << "shigusa_people: " << error.to_string() << "\n";
  return 2;
}

const Section* find_section(std::string_view name) {
  const auto found = std::find_if(kSections.begin(), kSections.end(),
                                  [name](const Section& section) { return section.name == name; });
  return found == kSections.end() ? nullptr : &*found;
}

bool is_part(std::string_view name) {
  return find_section(name) != nullptr || name == kMan || name == kRemarks;
}

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t place_of(const std::string& page, std::string_view title) {
  return page.find("\n## " + std::string(title) + "\n");
}

// Text from a title to the next one; empty if the page has no such title.
std::string part_of(const std::string& page, std::string_view title) {
  const std::size_t at = place_of(page, title);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + 1;
  const std::size_t end = page.find("\n## ", begin);
  return page.substr(begin, end == std::string::npos ? end : end - begin);
}

Result<void> write_pictures(const std::vector<NamedPicture>& pictures,
                            const std::filesystem::path& docs) {
  const std::filesystem::path images = docs / "images" / "people";
  std::filesystem::create_directories(images);
  for (const NamedPicture& picture : pictures) {
    std::ofstream(images / (picture.name + ".svg"), std::ios::binary) << picture.svg;
  }
  return {};
}

// The page with all sections regenerated, or only one of them.
Result<void> write_page(const std::filesystem::path& docs, const Sources& sources,
                        std::string_view only) {
  const std::filesystem::path file = docs / "people.md";
  const std::string before = file_text(file);
  const auto asked = [only](std::string_view name) { return only.empty() || only == name; };
  if (!only.empty() && place_of(before, kSections.front().title) == std::string::npos) {
    return fail(ErrorCode::parse, "is no page to put a section into; make all of it",
                file.string());
  }
  std::string page = before.substr(0, place_of(before, kSections.front().title));
  std::string reaches = part_of(before, kReaches);
  std::vector<NamedPicture> pictures;
  if (asked(kMan)) {
    SHG_TRY_ASSIGN(const std::vector<Compared> man, recorded_man(sources.shared / "reach"));
    page = people_page(man);
    reaches = reaches_section(man);
    SHG_TRY_ASSIGN(pictures, people_pictures(man));
  }
  for (const Section& section : kSections) {
    Drawn made{part_of(before, section.title)};
    if (asked(section.name)) {
      SHG_TRY_ASSIGN(made, section.made(sources));
    }
    if (!made.text.empty()) page += "\n" + made.text;
    std::move(made.pictures.begin(), made.pictures.end(), std::back_inserter(pictures));
  }
  page += "\n" + reaches;
  SHG_TRY(write_pictures(pictures, docs));
  std::ofstream(file, std::ios::binary) << page << "\n" << file_text(docs / "people_remarks.md");
  std::cout << file.string() << "\n";
  return {};
}

Result<void> print_section(std::string_view name, const Sources& sources) {
  if (const Section* section = find_section(name)) {
    SHG_TRY_ASSIGN(const Drawn made, section->made(sources));
    std::cout << made.text;
  } else if (name == kMan) {
    SHG_TRY_ASSIGN(const std::vector<Compared> man, recorded_man(sources.shared / "reach"));
    std::cout << people_page(man);
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> words(argv + 1, argv + argc);
  const bool print = !words.empty() && words[0] == "--print";
  const bool only = !words.empty() && words[0] == "--only";
  const std::size_t first = print || only ? 2 : 0;  // of the folders
  const std::size_t folders = print ? 1 : 2;        // that are needed
  if (words.size() < first + folders || words.size() > first + folders + 1) {
    std::cerr << kUsage;
    return 2;
  }
  const std::string_view part = first > 0 ? words[1] : std::string_view{};
  if (first > 0 && !is_part(part)) {
    std::cerr << "shigusa_people: no section " << part << "; there are " << kMan;
    for (const Section& section : kSections) std::cerr << " " << section.name;
    std::cerr << " " << kRemarks << "\n";
    return 2;
  }
  const std::size_t last = first + folders;
  const Sources sources{words[last - 1], words.size() > last ? words[last] : ""};
  const Result<void> done =
      print ? print_section(part, sources) : write_page(words[first], sources, part);
  return done ? 0 : fault(done.error());
}
