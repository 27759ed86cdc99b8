// What the page is drawn from: designs as their files have them, and what the program finds out
// about each for the eye.
#pragma once

#include <Eigen/Core>
#include <string>
#include <tencer/model/design.hpp>
#include <vector>

namespace tencer::app {

// A pose that the page can show beside the design's own.
struct PagePose {
  std::string label{};
  std::vector<Eigen::Matrix3Xd> pose{};  // per rod, 3 x n
};

struct PageDesign {
  const model::Design& design;
  // Its file's, which tells more than is read back: the check, and what fell short. Empty, or of
  // another program: what its file would be is made of the design.
  std::string file_text{};
  std::vector<PagePose> poses{};  // in the order in which the structure goes through them
};

// A JSON object: "file", the content of design.json, and "drawn", lengths and forces in the
// design's units:
//   axes     rows: to the right, up and towards the reader, as in the picture
//   rods     per rod "section_words" and "material_words", "grams", "half_sizes" along m1 and m2
//   (each
//            null where it is not known), and its vertex fields
//   closest  where strands, cables and marks come nearest, nearest first: "kind", "distance", and
//            the places: "rods" with "s", and "cables"
//   crossings  of rods, as seen along the axes: "over" and "under", each a rod and s, and the
//            "height" between them
//   poses    each a "label" and, per rod and vertex, the "shape" that it is of, less the design's
//            pose
//   modes    the lowest vibrations: "hertz" and, per rod and vertex, the "shape"
//   shoves   of the check, as pipeline::Shove has them, with "shapes" as poses have one
std::string page_data(const PageDesign& shown);

}  // namespace tencer::app
