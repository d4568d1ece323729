#pragma once
// A scene as a text that is built by entries, with every earlier state kept: what a front end that talks with
// the user holds. An entry is taken as a whole or not at all: what fails leaves scene, names and history as
// they were.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "session/host.hpp"
#include "session/session.hpp"

namespace lancer::session {

/// What came of an entry or a change.
struct Reply {
  Run run;
  std::string printed;         // by what is new
  bool is_incomplete = false;  // the entry ends too early: more is wanted
  bool is_changed = false;     // the text is another one now
  /// Which session the places of the messages belong to; it holds the scene where all went well.
  std::shared_ptr<const Session> session;
};

class Document {
 public:
  /// The host must outlive the document; what scripts print goes to the replies in its place.
  explicit Document(Host& host);

  /// Statements, or an expression, whose value then is printed and not kept. A `let`, `fn` or named object
  /// that is there already is replaced at its place; anything else goes to the end.
  Reply enter(std::string_view entry, const RunOptions& options);
  /// Makes this the text, as one change that the history calls `label`.
  Reply change(std::string text, const RunOptions& options, std::string label = {});
  /// Starts anew from a text that stands in a file; the history begins with it.
  Reply open(const std::string& path, std::string text, const RunOptions& options);

  /// Up to `count` changes back or forth; the number that it was. None at an end, or where the text of that
  /// time fails now, which the reply then tells.
  std::size_t undo(std::size_t count, const RunOptions& options, Reply& reply);
  std::size_t redo(std::size_t count, const RunOptions& options, Reply& reply);

  const std::string& text() const { return *states_[current_]; }
  const Session& session() const { return *session_; }
  /// What was entered, oldest first, and how many of them are in effect.
  std::vector<std::string> history() const;
  std::size_t in_effect() const { return current_; }
  /// What messages call the text: the file, or "session".
  const std::string& name() const { return name_; }
  void set_name(std::string path) { name_ = std::move(path); }

 private:
  struct Tried;
  Tried run(const std::string& text, const RunOptions& options) const;
  Reply settle(Tried tried, std::string text, std::string label);
  void accept(Tried& tried);
  std::size_t move_to(std::size_t state, const RunOptions& options, Reply& reply);
  std::string with_statements(std::string_view entry) const;

  Host& host_;
  std::string name_ = "session";
  std::vector<std::shared_ptr<const std::string>> states_;
  std::vector<std::string> labels_;  // of the change that led to each state
  std::size_t current_ = 0;
  std::shared_ptr<Session> session_;
  std::shared_ptr<Host> session_host_;
  std::string printed_;                // by the whole text
  std::vector<std::string> warnings_;  // of the whole text
};

}  // namespace lancer::session
