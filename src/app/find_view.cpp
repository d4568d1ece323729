#include "app/find_view.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>
#include <vector>

#include "app/option_values.hpp"
#include "base/diagnostic.hpp"

namespace lancer::app {

std::size_t find_view(const session::Session& session, const std::string& name) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < session.views().size(); ++i) names.push_back(session.view_name(i));
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::string_view near = nearest(name, std::vector<std::string_view>(names.begin(), names.end()));
  throw UsageError(fmt::format("there is no view `{}`{}; the views are `{}`", name,
                               near.empty() ? "" : fmt::format(" (did you mean `{}`?)", near),
                               fmt::join(names, "`, `")));
}

}  // namespace lancer::app
