#include "drawing/picture.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace tencer;
using namespace tencer::app;

namespace {

// A ring, bent out of its plane unless it is flat, with a cable across.
model::Design ring(bool flat) {
  constexpr int n = 40;
  model::Design design;
  Eigen::Matrix3Xd pose(3, n);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    pose.col(i) << 10 * std::cos(angle), 8 * std::sin(angle), flat ? 0.0 : 3 * std::sin(2 * angle);
  }
  const geometry::Polyline curve{pose, true};
  design.structure.rods.push_back(
      {.closed = true, .section = {}, .rest_lengths = geometry::edge_lengths(curve)});
  const double half = design.structure.rods[0].length() / 2;
  design.structure.cables.push_back({.a = springs::OnRod{0, 0}, .b = springs::OnRod{0, half}});
  design.built.push_back({.length = 20, .tension = 1});
  design.pose = design.target = {pose};
  design.pose_directors = design.target_directors = {Eigen::Matrix3Xd(3, 0)};
  return design;
}

// In px of an SVG of Cairo's: width="170mm".
double size_in(const std::string& svg, const std::string& key) {
  const std::size_t at = svg.find(key + "=\"");
  return std::stod(svg.substr(at + key.size() + 2));
}

}  // namespace

TEST_CASE("A picture is of the format of its ending") {
  CHECK(picture_format("a.SVG") == PictureFormat::svg);
  CHECK(picture_format("a.pdf") == PictureFormat::pdf);
  CHECK_FALSE(picture_format("a.jpg"));
  const model::Design design = ring(false);
  CHECK(picture(design, PictureFormat::pdf).starts_with("%PDF"));
  CHECK(picture(design, PictureFormat::png).starts_with("\x89PNG"));
  const std::string svg = picture(design, PictureFormat::svg);
  CHECK(svg.find("<title>Rods held in shape by 1 cable</title>") != std::string::npos);
  // Printed as it is; only a page's follows its reader.
  CHECK(svg.find("prefers-color-scheme") == std::string::npos);
  const std::string element = picture_svg(design);
  CHECK(element.starts_with("<svg"));
  CHECK(element.find("prefers-color-scheme") != std::string::npos);
  // The colours that it exchanges are there.
  CHECK(element.find("fill:rgb(100%,100%,100%)", element.find("</style>")) != std::string::npos);
}

TEST_CASE("Several views stand beside and below each other, a caption below them") {
  const model::Design design = ring(false);
  const std::string one = picture(design, PictureFormat::svg, {.views = {View::front}});
  const std::string two = picture(design, PictureFormat::svg, {.views = {View::front, View::side}});
  const std::string four = picture(design, PictureFormat::svg,
                                   {.views = {View::front, View::side, View::top, View::oblique}});
  CHECK(size_in(two, "width") == Approx(170));
  CHECK(size_in(four, "height") > size_in(two, "height") + 20);
  const std::string told =
      picture(design, PictureFormat::svg, {.views = {View::front}, .caption = "Figure 1: a ring"});
  CHECK(size_in(told, "height") > size_in(one, "height") + 3);
  CHECK(size_in(told, "width") == size_in(one, "width"));
}

TEST_CASE("What is flat is seen from the front, unless another view is asked for") {
  const model::Design flat = ring(true);
  CHECK(picture(flat, PictureFormat::svg) ==
        picture(flat, PictureFormat::svg, {.views = {View::front}}));
  const model::Design bent = ring(false);
  CHECK(picture(bent, PictureFormat::svg) ==
        picture(bent, PictureFormat::svg, {.views = {View::oblique}}));
}

TEST_CASE("Without numbers there are fewer letters") {
  const model::Design design = ring(false);
  CHECK(picture(design, PictureFormat::svg, {.numbers = false}).size() <
        picture(design, PictureFormat::svg).size());
}

TEST_CASE("Every view has its name") {
  for (const std::string& name : view_names()) CHECK(view_named(name));
  CHECK_FALSE(view_named("behind"));
}

TEST_CASE("Words that are no text are drawn as far as they are") {
  model::Design design = ring(true);
  design.name = "a\xFFname \xC3\xA9\xC3";
  CHECK(picture(design, PictureFormat::pdf, {.caption = design.name}).starts_with("%PDF"));
  CHECK_NOTHROW(picture(design, PictureFormat::png, {.caption = "\xED\xA0\x80 \xF0\x9D\x84\x9E"}));
}
