#include "command.hpp"

#include <cmath>

namespace tencer::app {

CLI::Validator positive_number() {
  return {[](std::string& text) {
            double value = 0;
            const bool fine =
                CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0;
            return fine ? std::string() : "expected a positive number, found " + text;
          },
          "POSITIVE"};
}

CLI::Validator not_negative_number() {
  return {[](std::string& text) {
            double value = 0;
            const bool fine =
                CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= 0;
            return fine ? std::string() : "expected a number that is not negative, found " + text;
          },
          "NOT NEGATIVE"};
}

CLI::Validator positive_integer() {
  return {[](std::string& text) {
            int value = 0;
            const bool fine = CLI::detail::lexical_cast(text, value) && value > 0;
            return fine ? std::string() : "expected a positive whole number, found " + text;
          },
          "POSITIVE INTEGER"};
}

}  // namespace tencer::app
