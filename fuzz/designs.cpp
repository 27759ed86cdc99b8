// Design files: any bytes give a design that is written as read, or an error that names the file
// and says something.
#include <tencer/io/design.hpp>

#include "input_file.hpp"
#include "must.hpp"

using namespace tencer;
using fuzz::must;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  const auto path = folder.put("design.json", fuzz::text_of(data, size));
  const auto design = io::read_design(path);
  if (!design) {
    must(design.error().where.starts_with(path.string()));
    must(!design.error().message.empty());
    return 0;
  }
  must(!io::design_problem(path, *design));
  const std::string text = io::design_text(*design);
  const auto again = io::read_design(folder.put("again.json", text));
  must(again.has_value());
  must(io::design_text(*again) == text);
  return 0;
}
