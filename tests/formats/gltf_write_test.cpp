// SPDX-License-Identifier: MIT
#include "formats/gltf_write.hpp"

#include <gmock/gmock.h>

#include "formats/json_splice.hpp"
#include "support/exported_glb.hpp"
#include "support/gltf_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

// A file with features that must survive: odd spacing and numbers, unordered members, an animation.
constexpr const char* kOdd = R"({ "extras":{"note":"}] \" {[","big":1.50e+00,"asset":0},
  "nodes" : [ {"name":"a","children":[1],"mesh":0,"extras":[]}, {"name":"b" , "translation":[0,1,0]} ],
  "animations":[{"name":"old","channels":[{"sampler":0,"target":{"node":1,"path":"scale"}}],"samplers":[{"input":0,"output":1}]}],
  "accessors":[{"bufferView":0,"componentType":5126,"count":1,"type":"SCALAR","min":[0],"max":[0]},
               {"bufferView":0,"byteOffset":4,"componentType":5126,"count":1,"type":"VEC3"}],
  "bufferViews":[{"buffer":0,"byteLength":16}], "buffers":[{"name":"b","byteLength" : 17}],
  "extensions":{"EXT_own":{"accessors":[1,2]}}, "asset":{"version":"2.0","generator":"someone"} })";

// node 1 turns by 0, 90° about x and moves in two frames
GltfAnimation turning(const std::string& name = "new") {
  const double half = sqrt(0.5);
  return {name, 0.5, 2, {{1, {}, {{0, 0, 0, 1}, {-half, 0, 0, -half}}, {{0, 1, 0}, {0, 2, 3}}}}};
}

Result<std::string> added(const std::string& bytes, const std::vector<GltfAnimation>& animations) {
  return add_animations(bytes, "file.glb", animations);
}

TEST(AddAnimations, KeepsAllElseByteForByte) {
  const std::string binary("0123456789abcdefg\0\0\0", 20);
  std::string file = glb(kOdd, binary);
  const std::string further = word_bytes(4) + "XTRAdata";
  file += further;
  file.replace(8, 4, word_bytes(static_cast<std::uint32_t>(file.size())));
  const std::string out = added(file, {turning()}).value();
  EXPECT_TRUE(out.ends_with(further));
  EXPECT_EQ(out.substr(8, 4), word_bytes(static_cast<std::uint32_t>(out.size())));
  const ExportedGlb exported(out);
  EXPECT_EQ(exported.binary().substr(0, 20), binary);
  EXPECT_EQ(exported.json().at("buffers").at(0).at("byteLength"), exported.binary().size());
  // removing the additions restores the old text
  std::string text = exported.text();
  const auto cut = [&text](const std::string& from, const std::string& until) {
    const std::size_t begin = text.find(from);
    ASSERT_NE(begin, text.npos) << from;
    text.erase(begin, text.find(until, begin) - begin);
  };
  cut(R"({"name":"new")", R"({"name":"old")");
  cut(R"(,{"bufferView":1)", "],\n  \"bufferViews\"");
  cut(R"(,{"buffer":0,"byteOffset":20)", "], \"buffers\"");
  const std::size_t length = text.find(R"("byteLength" : )") + 15;
  text.replace(length, text.find('}', length) - length, "17");
  EXPECT_EQ(text.substr(0, std::string(kOdd).size()), kOdd);
  EXPECT_EQ(text.find_first_not_of(' ', std::string(kOdd).size()), text.npos);
}

TEST(AddAnimations, WritesWhatMovesAndWhen) {
  const ExportedGlb file(
      added(glb(kOdd, std::string(20, 'x')), {turning(), turning("next")}).value());
  ASSERT_EQ(file.json().at("animations").size(), 3u);
  for (const char* name : {"new", "next"}) {
    EXPECT_EQ(file.frames(name), 2);
    const Transformd end = file.place(1, name, 1);
    // y turned by 90° about x is z
    EXPECT_LE(norm(end.rotation.cy - Vec3d{0, 0, 1}), 1e-6);
    EXPECT_EQ(end.translation, (Vec3d{0, 2, 3}));
  }
  const auto& animation = file.json().at("animations").at(0);
  const auto& times =
      file.json().at("accessors").at(animation.at("samplers").at(0).at("input").get<std::size_t>());
  EXPECT_EQ(times.at("min").at(0), 0);
  EXPECT_EQ(times.at("max").at(0), 0.5);
  for (const auto& sampler : animation.at("samplers"))
    EXPECT_EQ(sampler.at("interpolation"), "LINEAR");
}

// A property with keys in other animations but not in the new one gets two, at its rest value.
TEST(AddAnimations, HoldsWhatTheFilesOwnHaveKeysOf) {
  nlohmann::json file = nlohmann::json::parse(kOdd);
  file["meshes"] = {{{"primitives", {{{"targets", {1, 2}}}}}, {"weights", {0.25, 0.5}}}};
  file["nodes"][1]["scale"] = {2, 3, 4};
  const auto key = [&](int node, const char* path) {
    file["animations"][0]["channels"].push_back(
        {{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}});
  };
  key(1, "scale");
  key(1, "rotation");
  key(0, "weights");
  key(7, "scale");
  const ExportedGlb out(added(glb(file.dump(), std::string(20, 'x')), {turning()}).value());
  const auto& animation = out.json().at("animations").at(0);
  ASSERT_EQ(animation.at("channels").size(), 4u);
  const auto output = [&](std::size_t channel) {
    const std::size_t sampler = animation.at("channels").at(channel).at("sampler");
    return animation.at("samplers").at(sampler).at("output").get<std::size_t>();
  };
  EXPECT_EQ(animation.at("channels").at(2).at("target").at("path"), "scale");
  EXPECT_EQ(out.json().at("accessors").at(output(2)).at("count"), 2);
  for (const int at : {0, 1}) {
    EXPECT_THAT(out.element(output(2), at), testing::ElementsAre(2, 3, 4));
  }
  EXPECT_EQ(animation.at("channels").at(3).at("target").at("path"), "weights");
  EXPECT_EQ(out.json().at("accessors").at(output(3)).at("count"), 4);
  EXPECT_EQ(out.element(output(3), 2)[0], 0.25);
  EXPECT_EQ(out.element(output(3), 3)[0], 0.5);
}

TEST(AddAnimations, OwnOnesMayBeLeftOut) {
  const std::string bytes = glb(kOdd, std::string(20, 'x'));
  const GltfAnimation animation = turning();
  const ExportedGlb out(
      add_animations(bytes, "file.glb", {&animation, 1}, OwnAnimations::left_out).value());
  ASSERT_EQ(out.json().at("animations").size(), 1u);
  EXPECT_EQ(out.json().at("animations").at(0).at("name"), "new");
  EXPECT_EQ(out.json().at("animations").at(0).at("channels").size(), 2u);
}

TEST(AddAnimations, RotationsGoOnWithoutAJump) {
  const ExportedGlb file(added(glb(kOdd, std::string(20, 'x')), {turning()}).value());
  const auto& sampler = file.json().at("animations").at(0).at("samplers").at(0);
  const auto rotation = file.element(sampler.at("output").get<std::size_t>(), 1);
  EXPECT_GT(rotation[3], 0.0);
}

TEST(AddAnimations, AMatrixThatMovesBecomesItsParts) {
  nlohmann::json file = person_gltf();
  auto& node = file["nodes"][1];
  const auto place = nlohmann::json{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 3, 0, 1};
  node = {{"name", "b"}, {"matrix", place}, {"children", node["children"]}};
  const GltfCharacter character = parse_gltf(file.dump(), "file.gltf").value();
  GltfAnimation animation = turning();
  animation.tracks[0].rest = character.places[1];
  animation.tracks[0].translations.clear();
  const ExportedGlb out(added(file.dump(), {animation}).value());
  EXPECT_FALSE(out.json().at("nodes").at(1).contains("matrix"));
  EXPECT_EQ(out.json().at("nodes").at(1).at("name"), "b");
  const Transformd rest = out.place(1);
  EXPECT_LE(norm(rest.rotation.cx - ExportedGlb(glb(file.dump())).place(1).rotation.cx), 1e-12);
}

TEST(AddAnimations, ATextFileWithItsDataWithinBecomesGlb) {
  nlohmann::json file = person_gltf();
  file["buffers"] = {{{"byteLength", 4}, {"uri", "data:application/octet-stream;base64,AAAAAA=="}}};
  file["bufferViews"] = {{{"buffer", 0}, {"byteLength", 4}}};
  const std::string out = added("\xEF\xBB\xBF" + file.dump(), {turning()}).value();
  const ExportedGlb exported(out);
  EXPECT_EQ(exported.json().at("buffers").at(0),
            nlohmann::ordered_json::parse(file["buffers"][0].dump()));
  const std::string uri = exported.json().at("buffers").at(1).at("uri");
  // (2 times, 8 numbers of rotations, 6 of translations) · 4 bytes, 4 letters for 3 bytes
  EXPECT_EQ(exported.json().at("buffers").at(1).at("byteLength"), 64);
  EXPECT_EQ(uri.size() - uri.find(',') - 1, 88u);
  EXPECT_TRUE(uri.ends_with("=="));
  EXPECT_TRUE(parse_gltf(out, "again.glb"));
}

TEST(AddAnimations, AFileWithoutBuffersGetsOne) {
  const ExportedGlb file(added(person_gltf().dump(), {turning()}).value());
  EXPECT_EQ(file.json().at("buffers").size(), 1u);
  EXPECT_EQ(file.json().at("buffers").at(0).at("byteLength"), file.binary().size());
}

TEST(AddAnimations, TellsWhatItCannotKeep) {
  nlohmann::json file = person_gltf();
  file["images"] = {{{"uri", "skin.png"}}};
  const auto picture = added(file.dump(), {turning()});
  ASSERT_FALSE(picture);
  EXPECT_EQ(picture.error().code, ErrorCode::unsupported);
  EXPECT_THAT(picture.error().to_string(),
              HasSubstr("file.glb: images[0] lies in another file, \"skin.png\""));
  std::string cut = glb(kOdd, std::string(20, 'x'));
  cut.resize(cut.size() - 4);
  cut.replace(8, 4, word_bytes(static_cast<std::uint32_t>(cut.size())));
  EXPECT_THAT(added(cut, {turning()}).error().message, HasSubstr("tells 20 bytes, but 16 follow"));
  std::string short_header = glb(kOdd, std::string(20, 'x'));
  short_header.replace(8, 4, word_bytes(40));
  EXPECT_THAT(added(short_header, {turning()}).error().message, HasSubstr("tells 40 bytes"));
  std::string no_chunk = glb(kOdd, std::string(20, 'x'));
  no_chunk.resize(no_chunk.size() - 28);
  no_chunk.replace(8, 4, word_bytes(static_cast<std::uint32_t>(no_chunk.size())));
  EXPECT_THAT(added(no_chunk, {turning()}).error().message, HasSubstr("there is none"));
  EXPECT_FALSE(added("no JSON", {turning()}));
  for (const char* list : {"accessors", "animations", "buffers", "bufferViews"}) {
    nlohmann::json odd = person_gltf();
    odd[list] = nlohmann::json::object();
    EXPECT_THAT(added(odd.dump(), {turning()}).error().message,
                HasSubstr(std::string(list) + " is not a list"));
  }
}

TEST(FormatVrmAnimation, IsAFileOfBonesAndTheirMotion) {
  VrmAnimation motion;
  motion.bones = {{"hips", -1, {0, 1, 0}}, {"spine", 0, {0, 0.2, 0}}, {"head", 1, {0, 0.4, 0}}};
  motion.animation = turning("dance");
  const ExportedGlb file(format_vrm_animation(motion).value());
  const auto& extension = file.json().at("extensions").at("VRMC_vrm_animation");
  EXPECT_EQ(extension.at("specVersion"), "1.0");
  EXPECT_EQ(extension.at("humanoid").at("humanBones").at("head").at("node"), 2);
  EXPECT_EQ(file.json().at("extensionsUsed").at(0), "VRMC_vrm_animation");
  EXPECT_LE(norm(file.place(2).translation - Vec3d{0, 1.6, 0}), 1e-12);
  EXPECT_EQ(file.frames("dance"), 2);
}

TEST(JsonSplice, FindsItsWayThroughAnyText) {
  const std::string text = R"( {"a\"b" : [ ], "\u0063":[1 , "],[" ,{"x":[3]},[4,5]], "d":-1e5 } )";
  JsonSplice splice(text);
  EXPECT_EQ(splice.count(splice.member(splice.root(), "a\"b")), 0u);
  const auto list = splice.elements(splice.member(splice.root(), "c"));
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(splice.text_of(list[1]), "\"],[\"");
  EXPECT_EQ(splice.text_of(list[3]), "[4,5]");
  EXPECT_EQ(splice.text_of(splice.member(list[2], "x")), "[3]");
  EXPECT_EQ(splice.text_of(splice.member(splice.root(), "d")), "-1e5");
  EXPECT_FALSE(splice.member(splice.root(), "e"));
  splice.append("a\"b", "7");
  splice.append("c", "8,9");
  splice.append("e", "1");
  EXPECT_EQ(
      nlohmann::json::parse(splice.finish()),
      nlohmann::json::parse(R"({"a\"b":[7],"c":[1,"],[",{"x":[3]},[4,5],8,9],"d":-1e5,"e":[1]})"));
}

TEST(JsonSplice, StaysInsideATextThatEndsTooEarly) {
  const std::string whole = R"({"a":[{"name":"b"},{"name":"c\"d"}],"e":1})";
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    const std::string_view text = std::string_view(whole).substr(0, size);
    const JsonSplice splice(text);
    EXPECT_LE(splice.text_of(splice.member(splice.root(), "e")).size(), size) << text;
    for (const auto& each : splice.elements(splice.member(splice.root(), "a"))) {
      EXPECT_LE(splice.text_of(splice.member(each, "name")).size(), size) << text;
    }
  }
}

}  // namespace
}  // namespace shigusa
