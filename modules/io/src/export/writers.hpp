// One writer a format; see export.hpp.
#pragma once

#include <string>
#include <tencer/model/design.hpp>

namespace tencer::io {

std::string obj_parts(const model::Design& design);
std::string vtp_text(const model::Design& design);
std::string gltf_text(const model::Design& design);  // with its numbers in it
std::string glb_bytes(const model::Design& design);
std::string dxf_parts(const model::Design& design);
std::string csv_table(const model::Design& design);

}  // namespace tencer::io
