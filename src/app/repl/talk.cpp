#include "app/repl/talk.hpp"

#include <utility>

#include "app/find_view.hpp"
#include "app/report.hpp"

namespace lancer::app {

Talk::Talk(const Console& c, session::RunOptions run_options)
    : console(c), host({}, c.interrupt), run(std::move(run_options)), document(host) {
  run.interrupt = &c.interrupt;
}

void Talk::tell(std::string_view text) const {
  console.out.write(text);
  console.out.flush();
}

void Talk::answer(const session::Reply& reply) const {
  tell(reply.printed);
  if (reply.run.outcome == session::Outcome::interrupted) throw Stopped{};
  report_mistakes(*reply.session, reply.run, console);
  if (reply.run.outcome != session::Outcome::fine) throw Refused{};
}

std::size_t Talk::view_index() const { return view.empty() ? 0 : find_view(document.session(), view); }

}  // namespace lancer::app
