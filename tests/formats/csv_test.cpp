// SPDX-License-Identifier: MIT
#include "formats/csv.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace shigusa {
namespace {

using Table = std::vector<CsvColumn>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Csv, HeaderRowThenOneRowPerValue) {
  const Table table{{"time [s]", {0.0, 0.5}}, {"x [m]", {1.0, -2.25}}};
  EXPECT_EQ(format_csv(table).value(), "time [s],x [m]\n0,1\n0.5,-2.25\n");
}

TEST(Csv, ColumnsWithoutValuesGiveTheHeaderAlone) {
  EXPECT_EQ(format_csv(Table{{"a", {}}, {"b", {}}}).value(), "a,b\n");
}

TEST(Csv, NamesWithSeparatorsAreQuoted) {
  const Table table{{"a,b", {}}, {"say \"hip\"", {}}, {"two\nlines", {}}, {"plain [m/s]", {}}};
  EXPECT_EQ(format_csv(table).value(), "\"a,b\",\"say \"\"hip\"\"\",\"two\nlines\",plain [m/s]\n");
}

TEST(Csv, EmptyNameIsQuotedSoThatTheHeaderIsNoEmptyLine) {
  EXPECT_EQ(format_csv(Table{{"", {1.0}}}).value(), "\"\"\n1\n");
}

TEST(Csv, EmptyFirstNameKeepsItsSeparator) {
  EXPECT_EQ(format_csv(Table{{"", {}}, {"b", {}}}).value(), "\"\",b\n");
}

TEST(Csv, NumbersHaveTheFewestDigitsThatRoundTrip) {
  const Table table{{"a", {0.1, 1.0 / 3.0, 1e-300}}};
  EXPECT_EQ(format_csv(table).value(), "a\n0.1\n0.3333333333333333\n1e-300\n");
}

RC_GTEST_PROP(Csv, EveryNumberReadsBackAsTheSameDouble, (double value)) {
  RC_PRE(std::isfinite(value));
  const std::string text = format_csv(Table{{"a", {value}}}).value();
  RC_ASSERT(std::strtod(text.c_str() + 2, nullptr) == value);
}

TEST(Csv, ColumnsOfDifferentLengthAreRefusedByName) {
  const auto text = format_csv(Table{{"time", {1.0, 2.0}}, {"knee", {1.0}}});
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().to_string(), "column 'knee': 1 values, but column 'time' has 2");
}

TEST(Csv, NumbersThatAreNotFiniteAreRefusedWithTheirPlace) {
  for (const double bad : {std::nan(""), kInfinity, -kInfinity}) {
    const auto text = format_csv(Table{{"time", {0.0, 1.0}}, {"knee", {0.0, bad}}});
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().place, "column 'knee'");
    EXPECT_NE(text.error().message.text.find("value 2"), std::string::npos);
  }
}

TEST(Csv, TableWithoutColumnsIsRefused) { EXPECT_FALSE(format_csv(Table{})); }

}  // namespace
}  // namespace shigusa
