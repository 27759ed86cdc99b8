#include <iomanip>
#include <sstream>
#include <tencer/core/words.hpp>
#include <tencer/model/at_least.hpp>

namespace tencer::model {

std::string in_words(const AtLeast& at_least) {
  if (at_least.cables == 0) return {};
  std::ostringstream text;
  text << std::setprecision(3) << "at least " << core::counted(at_least.cables, "cable")
       << (at_least.cables == 1 ? " is" : " are") << " needed within " << at_least.error_percent
       << " % of the target's size";
  return text.str();
}

}  // namespace tencer::model
