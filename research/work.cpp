// SPDX-License-Identifier: MIT
// shigusa_work PIECES: draws pieces of work as the test work.pieces does, prints what is measured
// of them, and fails where a promise is broken. scripts/check_work runs it.
#include <cstdlib>
#include <iostream>

#include "support/pieces.hpp"

int main(int argc, char** argv) {
  using shigusa::testing_support::PiecesTally;
  const int pieces = argc == 2 ? std::atoi(argv[1]) : 0;
  if (pieces < 1) {
    std::cerr << "usage: shigusa_work PIECES\n";
    return 2;
  }
  PiecesTally tally;
  for (int k = 0; k < pieces; ++k) tally.add(k);
  std::cout << tally.table();
  return tally.holds() ? 0 : 1;
}
