// What to buy for a cut list, and what it costs. Lengths in mm, prices per metre in any currency.
#pragma once

#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/fabricate/cut_list.hpp>
#include <tencer/fabricate/packing.hpp>

namespace tencer::fabricate {

// What is not set is not told. Positive.
struct Offer {
  std::optional<double> stock{};  // length of a bar, or of a coil
  std::optional<double> price_per_metre{};
};

// A bar's worth of a rod or a whole cable.
struct Piece {
  int of = 0;         // the rod or cable
  double from = 0.0;  // where it begins, from the end of what the rod is cut to
  double length = 0.0;
};

struct Purchase {
  double needed = 0.0;  // the pieces' lengths
  std::vector<Piece> pieces{};
  std::optional<Packing> packing{};  // of the pieces; not set: no stock is
  double bought = 0.0;               // whole bars or coils, or what is needed
  std::optional<double> cost{};      // of what is bought
};

// Rods longer than a bar are made of several. Errors: bars no longer than the joint.
core::Expected<Purchase> buy_rods(const CutList& list, const Offer& offer);

// Cables are not spliced: errors name a cable that is longer than a coil.
core::Expected<Purchase> buy_cables(const CutList& list, const Offer& offer);

// Where a rod's pieces overlap each other, from `from` to `to` from the end of what it is cut to.
struct Splice {
  int rod = 0;
  double from = 0.0;
  double to = 0.0;
  std::optional<double> nearest_mark{};  // from the splice, 0 within it; not set: no mark
};
std::vector<Splice> splices(const CutList& list, const Purchase& rods);

}  // namespace tencer::fabricate
