// Curve files that scenes of tests name.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <string_view>
#include <tencer/io/scene.hpp>

#include "fixtures/folder.hpp"

// A folder with curve files: a closed square, an open bent line, and both in one.
struct Curves : Folder {
  Curves() {
    put("ring.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nl 1 2 3 4 1\n");
    put("line.csv", "9,0,0\n10,0,0\n11,1,0\n");
    put("far.csv", "0,0,0\n1,0,0\n2,0.5,0\n3,0,0\n4,1,0\n5,1,0\n");
    put("both.obj",
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nl 1 2 3 4 1\nv 9 0 0\nv 10 0 0\nv 11 1 0\nl 5 6 7\n");
    put("spoilt.obj", "v 0 0 0\nv 1 0 x\n");
    put("tall.csv", "0,0,0\n1,0,0\n2,1,1\n");
    put("eight.csv", "0,0,0\n1,1,0\n2,0,0\n1,-1,0\n0,0,1\n-1,-1,0\n0,0,0\n1,1,1\n");
  }
  tencer::model::Scene scene(std::string_view text) const {
    const auto found = tencer::io::read_scene(put("s.toml", text));
    if (!found) FAIL(found.error().text());
    return *found;
  }
  std::string error(std::string_view text) const {
    const auto found = tencer::io::read_scene(put("s.toml", text));
    return found ? "no error" : local(found.error().text());
  }
};
