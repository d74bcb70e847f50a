// SPDX-License-Identifier: MIT
#include "formats/xml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace shigusa {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr XmlLimits kLimits{1000, 20, 5};

Result<XmlElement> parse(std::string_view text) { return parse_xml(text, kLimits, "a.xml"); }

std::string error_of(std::string_view text) {
  const Result<XmlElement> element = parse(text);
  return element ? "no error" : element.error().to_string();
}

TEST(Xml, ReadsElementsAttributesAndLines) {
  const XmlElement a =
      parse(
          "<?xml version=\"1.0\"?>\n<!DOCTYPE a>\n<!-- <b> --><a x = '1\"2' y=\"\">"
          "\n text <![CDATA[<c>]]><b/>\n<c d=\"a>b\"></c ></a>\n")
          .value();
  EXPECT_EQ(a.name, "a");
  EXPECT_EQ(a.line, 3);
  EXPECT_STREQ(a.attribute("x"), "1\"2");
  EXPECT_STREQ(a.attribute("y"), "");
  EXPECT_EQ(a.attribute("z"), nullptr);
  ASSERT_EQ(a.children.size(), 2u);
  EXPECT_EQ(a.children[0].line, 4);
  EXPECT_STREQ(a.child("c")->attribute("d"), "a>b");
  EXPECT_EQ(a.child("c")->line, 5);
  EXPECT_EQ(a.child("d"), nullptr);
}

TEST(Xml, ResolvesItsOwnEntitiesAndCharactersByNumber) {
  const auto value = [](std::string_view text) {
    return std::string(parse("<a b=\"" + std::string(text) + "\"/>").value().attribute("b"));
  };
  EXPECT_EQ(value("&lt;&gt;&amp;&quot;&apos;"), "<>&\"'");
  EXPECT_EQ(value("&#65;&#x3b1;&#x3042;&#x1F600;&#233;"), "Aαあ😀é");
  for (const char* text : {"&", "&;", "&none;", "&#;", "&#0;", "&#xD800;", "&#x110000;", "&#1x;",
                           "&#-1;", "&lt", "&#99999999999;"}) {
    EXPECT_EQ(value(text), text);
  }
  EXPECT_EQ(value("&amp;lt;"), "&lt;") << "what came of one is none";
}

TEST(Xml, WhatIsWrittenIsReadAsTheSame) {
  const XmlElement a = parse("<a b='&lt;\"&#10;&amp;lt;é'><b/><c d=\"1\"><d/></c></a>").value();
  const std::string text = write_xml(a);
  EXPECT_EQ(text, "<a b=\"&lt;&quot;\n&amp;lt;é\">\n<b/>\n<c d=\"1\"><d/></c>\n</a>\n");
  const XmlElement again = parse(text).value();
  EXPECT_STREQ(again.attribute("b"), "<\"\n&lt;é");
  EXPECT_EQ(write_xml(again), text);
  EXPECT_EQ(write_xml(parse("<a></a>").value()), "<a/>\n");
}

TEST(Xml, TellsWhatIsWrongAndWhere) {
  EXPECT_EQ(error_of(""), "line 1 of a.xml: no element: this is no XML file");
  EXPECT_EQ(error_of("<a>\n<b>\n</a>"), "line 3 of a.xml: </a> closes <b>");
  EXPECT_EQ(error_of("</a>"), "line 1 of a.xml: </a> closes nothing");
  EXPECT_EQ(error_of("<a>"), "line 1 of a.xml: <a> is never closed");
  EXPECT_EQ(error_of("<a"), "line 1 of a.xml: a tag is never closed");
  EXPECT_EQ(error_of("<a b=\">"), "line 1 of a.xml: a tag is never closed");
  EXPECT_EQ(error_of("<a><!-- </a>"), "line 1 of a.xml: a comment is never closed");
  EXPECT_EQ(error_of("<a/><b/>"), "line 1 of a.xml: a second element <b> beside <a>");
  EXPECT_EQ(error_of("<>"), "line 1 of a.xml: a tag without a name");
  EXPECT_EQ(error_of("<a b=\"1\" b=\"2\"/>"), "line 1 of a.xml: <a> has b twice");
  for (const char* tag : {"<a b/>", "<a b=1/>", "<a b=/>", "<a =\"1\"/>", "<a \"1\"/>"}) {
    EXPECT_THAT(error_of(tag), HasSubstr("where NAME=\"VALUE\" is expected")) << tag;
  }
  EXPECT_EQ(error_of(std::string("<a/>\0", 5)), "a.xml: a zero byte: this is no text");
}

TEST(Xml, BombsAreRefused) {
  EXPECT_THAT(error_of("<!DOCTYPE a [<!ENTITY b \"c\">]><a d=\"&b;\"/>"),
              HasSubstr("a document type with definitions"));
  EXPECT_THAT(error_of("<a><a><a><a><a><a>"), HasSubstr("<a> is nested deeper than 5 elements"));
  std::string many = "<a>";
  for (int k = 0; k < 20; ++k) many += "<b/>";
  EXPECT_EQ(error_of(many + "</a>"), "a.xml: more than 20 tags");
  EXPECT_EQ(error_of(std::string(1001, ' ')), "a.xml: 1001 bytes; 1000 are allowed");
  std::string wide = "<a";
  for (std::size_t k = 0; k <= kXmlMaxAttributes; ++k) wide += " b" + std::to_string(k) + "=\"\"";
  EXPECT_THAT(error_of(wide + "/>"), HasSubstr("<a> has more than 100 attributes"));
}

TEST(Xml, NumbersStandBetweenBlanks) {
  EXPECT_THAT(xml_numbers(" 1\n-2.5e1\t+3 ", 3).value(), ElementsAre(1.0, -25.0, 3.0));
  EXPECT_TRUE(xml_numbers("", 3).value().empty());
  EXPECT_FALSE(xml_numbers("1 2 3 4", 3));
  EXPECT_FALSE(xml_numbers("1 x", 3));
  EXPECT_FALSE(xml_numbers("1,2", 3));
}

}  // namespace
}  // namespace shigusa
