// What is asked of a design, and which of two answers it better.
#pragma once

#include <span>

namespace tencer::model {

// How well a design keeps its pose once it is built, the worst first.
enum class Footing {
  none,   // it does not come to rest there, or small errors make it fall to another pose
  keeps,  // neither, but errors move it further than is allowed, or it does not keep clear of
          // itself
  stands  // it keeps its pose within what is allowed
};

// What a goal judges of a network.
struct Score {
  int cables = 0;
  double max_percent = 0.0;  // the largest distance from the target, in % of its diagonal
  Footing footing = Footing::none;

  bool stands() const { return footing == Footing::stands; }
};

// The fewest cables within an error; with a number of cables, the closest with at most so many; or
// the closest of every number on the way.
struct Goal {
  double max_error_percent = 1.0;
  int cables = 0;  // the closest with at most so many, however far; 0: the fewest instead
  bool every_number = false;  // every number of cables is worth an answer

  bool by_number() const { return cables > 0; }

  // Whether the score is what is asked for, standing apart: few enough cables, or close enough.
  bool met(const Score& score) const {
    return by_number() ? score.cables <= cables : score.max_percent <= max_error_percent;
  }

  // Whether `next` answers clearly better than `best`: by its footing, then by fewer cables where
  // an error is asked for and both are within it, then by distance (at least 3 % less: smaller
  // gains are not worth a change).
  bool improves(const Score& next, const Score& best) const;

  // The index of what is asked for, or of what comes nearest to it, among scores with ascending
  // numbers of cables; -1 when there are none. Their footing is not looked at.
  int pick(std::span<const Score> scores) const;

  // Whether an answer of a better footing is to be taken in place of another: with a number of
  // cables asked for it may be at most twice as far away.
  bool prefers_footing(const Score& firmer, const Score& other) const;

  // Throws std::invalid_argument, naming the field, unless the numbers make sense.
  void validate() const;
};

}  // namespace tencer::model
