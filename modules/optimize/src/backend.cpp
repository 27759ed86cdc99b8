#include <algorithm>
#include <tencer/optimize/backend.hpp>

namespace tencer::optimize {

core::Expected<Backend> find_backend(std::span<const Backend> backends, std::string_view name) {
  const auto found = std::ranges::find(backends, name, &Backend::name);
  if (found != backends.end()) return *found;
  std::string known;
  for (const Backend& backend : backends) known += (known.empty() ? "" : ", ") + backend.name;
  return core::Error{
      .where = {},
      .message = "optimizer \"" + std::string(name) +
                 "\" is not in this build; this build has: " + (known.empty() ? "none" : known)};
}

}  // namespace tencer::optimize
