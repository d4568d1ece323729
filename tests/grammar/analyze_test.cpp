#include <tao/pegtl.hpp>
#include <tao/pegtl/contrib/analyze.hpp>

#include "catch.hpp"
#include "grammar/rules.hpp"

namespace {
// A rule that calls itself without taking anything: what analyze() is there to find.
struct endless : tao::pegtl::seq<tao::pegtl::opt<tao::pegtl::one<'a'>>, endless> {};
}  // namespace

TEST_CASE("the grammar has no rule that goes on without taking anything", "[grammar]") {
  CHECK(tao::pegtl::analyze<lancer::grammar::rules::script>() == 0);
}

TEST_CASE("the check of the grammar finds a rule that goes on forever", "[grammar]") {
  CHECK(tao::pegtl::analyze<endless>(-1) > 0);
}
