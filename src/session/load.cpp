#include "session/load.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <optional>
#include <utility>

#include "grammar/parse.hpp"

namespace lancer::session {
namespace {

namespace fs = std::filesystem;

bool is_under(const std::string& path, const std::string& folder) {
  if (folder.empty()) return false;
  const fs::path inner(path), outer(folder);
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

/// One load: the files read so far, and those that are still being read.
class Loader {
 public:
  Loader(Host& host, SourceMap& sources, const RunOptions& options)
      : host_(host), sources_(sources), options_(options) {}

  Loaded run(Start start) {
    allowed_.push_back(host_.canonical(start.folder.empty() ? "." : start.folder));
    for (const std::string& folder : options_.include_folders) allowed_.push_back(host_.canonical(folder));
    if (!options_.library_folder.empty()) allowed_.push_back(host_.canonical(options_.library_folder));
    if (!start.canonical.empty()) {
      reading_.push_back(start.canonical);
      read_.push_back(start.canonical);
    }
    parse(std::move(start));
    return std::move(out_);
  }

 private:
  struct Found {
    std::string name;  // as messages call it
    std::string canonical;
  };

  std::uint32_t parse(Start start) {
    const std::uint32_t file = sources_.add(start.name, std::move(start.text));
    grammar::Parsed parsed = grammar::parse(sources_, file);
    std::move(parsed.diagnostics.begin(), parsed.diagnostics.end(), std::back_inserter(out_.diagnostics));
    out_.skipped.insert(out_.skipped.end(), parsed.skipped.begin(), parsed.skipped.end());
    const auto index = static_cast<std::uint32_t>(out_.scripts.size());
    out_.scripts.push_back(std::move(parsed.script));
    for (ast::Stmt* statement : out_.scripts[index].statements) {
      if (statement->kind == ast::StmtKind::include) follow(ast::as<ast::Include>(*statement), start.folder);
    }
    return index;
  }

  void follow(ast::Include& include, const std::string& folder) {
    const std::optional<Found> found = find(std::string(include.path), folder);
    const auto refuse = [&](Code code, std::string message, std::string help) {
      out_.diagnostics.push_back(error(code, include.path_span, std::move(message), std::move(help)));
      out_.skipped.push_back(include.span);
    };
    if (!found) {
      refuse(Code::include_missing, fmt::format("there is no file \"{}\"", include.path),
             "files are looked for beside the including one, then in the folders given with -I, then in the "
             "library");
    } else if (std::none_of(allowed_.begin(), allowed_.end(),
                            [&](const auto& a) { return is_under(found->canonical, a); })) {
      refuse(Code::include_outside,
             fmt::format("\"{}\" lies outside the folders that this script may read", include.path),
             "a script reads files under its own folder, folders given with -I, and the library");
    } else if (std::find(reading_.begin(), reading_.end(), found->canonical) != reading_.end()) {
      refuse(Code::include_cycle,
             fmt::format("\"{}\" is still being read: files include each other in a circle", include.path),
             "");
    } else if (std::find(read_.begin(), read_.end(), found->canonical) == read_.end()) {
      include.script = read(*found, include.path_span);
      if (include.script == ast::k_no_script) out_.skipped.push_back(include.span);
    }
  }

  std::uint32_t read(const Found& found, Span where) {
    FileText file = host_.read(found.canonical);
    if (file.status != FileText::Status::read) {
      out_.diagnostics.push_back(error(Code::include_missing, where,
                                       fmt::format("\"{}\" cannot be read: {}", found.name, file.problem)));
      if (out_.problem.empty()) out_.problem = fmt::format("cannot read {}: {}", found.name, file.problem);
      return ast::k_no_script;
    }
    read_.push_back(found.canonical);
    reading_.push_back(found.canonical);
    const std::uint32_t index = parse(
        {found.name, std::move(file.text), found.canonical, fs::path(found.name).parent_path().string()});
    reading_.pop_back();
    return index;
  }

  std::optional<Found> find(const std::string& path, const std::string& folder) {
    std::vector<std::string> places{folder};
    places.insert(places.end(), options_.include_folders.begin(), options_.include_folders.end());
    if (!options_.library_folder.empty()) places.push_back(options_.library_folder);
    if (path.empty() || path.find('\0') != std::string::npos) return std::nullopt;
    for (const std::string& place : places) {
      std::string name = (fs::path(place) / path).lexically_normal().string();
      std::string canonical = host_.canonical(name);
      if (!canonical.empty()) return Found{std::move(name), std::move(canonical)};
    }
    return std::nullopt;
  }

  Host& host_;
  SourceMap& sources_;
  const RunOptions& options_;
  Loaded out_;
  std::vector<std::string> allowed_;  // folders, canonical
  std::vector<std::string> reading_;  // from the started file inwards
  std::vector<std::string> read_;
};

}  // namespace

std::vector<ast::Script*> Loaded::pointers() {
  std::vector<ast::Script*> out;
  for (ast::Script& script : scripts) out.push_back(&script);
  return out;
}

Loaded load(Start start, Host& host, SourceMap& sources, const RunOptions& options) {
  return Loader(host, sources, options).run(std::move(start));
}

}  // namespace lancer::session
