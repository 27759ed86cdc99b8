// apps/tencer/view/page.html with its scripts and three.js in place, embedded at build time.
#pragma once

#include <string_view>

namespace tencer::app {

extern const std::string_view view_template;

}  // namespace tencer::app
