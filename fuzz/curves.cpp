// Curve files, of the format whose extension is TENCER_FUZZ_EXTENSION: any bytes give curves that
// can be worked with, or an error that names the file and says something.
#include <tencer/io/curve.hpp>

#include "input_file.hpp"
#include "must.hpp"

using namespace tencer;
using fuzz::must;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  const auto path = folder.put("curve" TENCER_FUZZ_EXTENSION, fuzz::text_of(data, size));
  const auto curves = io::read_curves(path);
  if (!curves) {
    must(curves.error().where.starts_with(path.string()));
    must(!curves.error().message.empty());
    return 0;
  }
  must(!curves->empty());
  for (const geometry::Polyline& curve : *curves) {
    must(curve.points.allFinite());
    must(curve.vertices() >= (curve.closed ? 3 : 2));
    const Eigen::VectorXd lengths = geometry::edge_lengths(curve);
    must(lengths.allFinite() && lengths.minCoeff() > 0);
  }
  // What was read can be written and read again, to the last bit.
  const auto again = io::read_curves(folder.put("again.obj", io::obj_text(*curves)));
  must(again && again->size() == curves->size());
  for (std::size_t i = 0; i < curves->size(); ++i) {
    must((*again)[i].closed == (*curves)[i].closed);
    must((*again)[i].points == (*curves)[i].points);
  }
  return 0;
}
