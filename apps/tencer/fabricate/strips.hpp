// Strips of paper as long as rods, with their marks, to lay along them.
#pragma once

#include <string>
#include <tencer/fabricate/cut_list.hpp>

#include "fabricate/book.hpp"

namespace tencer::app {

// The whole of a rod in one piece, at 1:1, for a plotter or a roll of paper.
std::string strip_svg(const fabricate::CutList& list, int rod);

// The same in pieces that fit on the book's pages, each overlapping the next, and on every page a
// ruler to find out whether the printer keeps the scale.
void add_strips(Book& book, const fabricate::CutList& list);

}  // namespace tencer::app
