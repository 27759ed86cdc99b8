#include <algorithm>
#include <cmath>
#include <tencer/core/names.hpp>
#include <tencer/fabricate/names.hpp>
#include <tencer/fabricate/purchase.hpp>

namespace tencer::fabricate {
namespace {

void buy(const Offer& offer, Purchase& purchase) {
  std::vector<double> lengths;
  for (const Piece& piece : purchase.pieces) {
    lengths.push_back(piece.length);
    purchase.needed += piece.length;
  }
  purchase.bought = purchase.needed;
  if (offer.stock) {
    purchase.packing = pack(lengths, *offer.stock);
    purchase.bought = static_cast<double>(purchase.packing->bars.size()) * *offer.stock;
  }
  if (offer.price_per_metre) purchase.cost = purchase.bought / 1000 * *offer.price_per_metre;
}

}  // namespace

core::Expected<Purchase> buy_rods(const CutList& list, const Offer& offer) {
  const double joint = list.allowances.joint;
  Purchase purchase;
  for (std::size_t r = 0; r < list.rods.size(); ++r) {
    const double cut = list.rods[r].cut;
    if (offer.stock && cut > *offer.stock && *offer.stock <= joint)
      return core::Error{"", "bars of " + tenths(*offer.stock) + " mm are no longer than the " +
                                 tenths(joint) + " mm that a joint takes"};
    const auto pieces = offer.stock ? spliced(cut, *offer.stock, joint) : std::vector<double>{cut};
    double from = 0;
    for (const double length : pieces) {
      purchase.pieces.push_back({static_cast<int>(r), from, length});
      from += length - joint;
    }
  }
  buy(offer, purchase);
  return purchase;
}

core::Expected<Purchase> buy_cables(const CutList& list, const Offer& offer) {
  Purchase purchase;
  for (std::size_t c = 0; c < list.cables.size(); ++c) {
    const double cut = list.cables[c].cut;
    const auto name = core::cable_in_words(static_cast<int>(c));
    if (offer.stock && cut > *offer.stock)
      return core::Error{"", name + " is cut to " + tenths(cut) + " mm, longer than a coil of " +
                                 tenths(*offer.stock) + " mm"};
    purchase.pieces.push_back({static_cast<int>(c), 0.0, cut});
  }
  buy(offer, purchase);
  return purchase;
}

std::vector<Splice> splices(const CutList& list, const Purchase& rods) {
  std::vector<Splice> result;
  for (const Piece& piece : rods.pieces) {
    if (piece.from == 0) continue;
    Splice splice{piece.of, piece.from, piece.from + list.allowances.joint};
    for (const model::Mark& mark : list.rods[piece.of].marks) {
      const double at = list.rods[piece.of].from_end(mark.s);
      const double apart = std::abs(at - std::clamp(at, splice.from, splice.to));
      splice.nearest_mark = std::min(splice.nearest_mark.value_or(apart), apart);
    }
    result.push_back(splice);
  }
  return result;
}

}  // namespace tencer::fabricate
