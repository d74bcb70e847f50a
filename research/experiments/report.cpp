// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "core/check.hpp"

namespace shigusa::bench {

double quantile(std::vector<double> values, double q) {
  SHG_CHECK(!values.empty(), "a quantile of no values");
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
}

double median(const std::vector<double>& values) { return quantile(values, 0.5); }

std::string spread(const std::vector<double>& values) {
  return fmt::format("{:.3f} ({:.3f}–{:.3f})", median(values), quantile(values, 0.25),
                     quantile(values, 0.75));
}

std::string percent(double count, double all, int digits) {
  if (count == 0.0 || count == all) return count == 0.0 ? "0 %" : "100 %";
  return fmt::format("{:.{}f} %", 100.0 * count / all, digits);
}

double Stopwatch::now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

Table::Table(const std::vector<std::string>& head) {
  add(head);
  add(std::vector<std::string>(head.size(), "---"));
}

void Table::add(const std::vector<std::string>& cells) {
  text_ += "|";
  for (const std::string& cell : cells) text_ += " " + cell + " |";
  text_ += "\n";
}

}  // namespace shigusa::bench
