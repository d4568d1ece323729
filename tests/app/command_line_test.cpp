#include "app/option_values.hpp"
#include "app/run_lancer.hpp"
#include "catch.hpp"

using namespace lancer;
using test::Result;
using test::run_program;

TEST_CASE("command line: version and help go to standard output", "[app]") {
  const Result version = run_program({"--version"});
  CHECK(version.exit_code == 0);
  CHECK(version.out.find("lancer ") == 0);
  for (const std::string word : {"--help", "-h"}) {
    const Result help = run_program({word});
    CHECK(help.exit_code == 0);
    CHECK(help.err.empty());
    CHECK_THAT(help.out, ContainsSubstring("Examples:"));
    CHECK_THAT(help.out, ContainsSubstring("lancer check --run"));
  }
  for (const std::string word : {"render", "check", "dump"}) {
    const Result help = run_program({word, "--help"});
    CHECK(help.exit_code == 0);
    CHECK_THAT(help.out, ContainsSubstring("--max-steps"));
  }
}

TEST_CASE("command line: nothing at all is answered with help and 2", "[app]") {
  const Result r = run_program({});
  CHECK(r.exit_code == 2);
  CHECK(r.out.empty());
  CHECK_THAT(r.err, ContainsSubstring("lancer render FILE"));
}

TEST_CASE("command line: what is wrong is said in a line, with exit 2", "[app]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", "sphere { <0, 0, 0>, 1 }\n");
  const auto complaint = [&](std::vector<std::string> arguments) {
    const Result r = run_program(arguments);
    CAPTURE(arguments, r.err);
    CHECK(r.exit_code == 2);
    CHECK(r.out.empty());
    CHECK(f.names() == std::vector<std::string>{"a.scn"});
    return r.err.substr(0, r.err.find('\n'));
  };
  CHECK(complaint({"render"}) == "lancer: there is no FILE to work on");
  CHECK(complaint({"check"}) == "lancer: there is no FILE to work on");
  CHECK(complaint({"rendr", scene}) == "lancer: there is no command rendr; did you mean render?");
  CHECK(complaint({scene, "--sise", "3,3"}) == "lancer: there is no option --sise; did you mean --size?");
  CHECK(complaint({scene, "-x"}) == "lancer: there is no option -x");
  CHECK(complaint({scene, "b.scn"}) == "lancer: `b.scn` is one file too many");
  CHECK(complaint({scene, "--size"}) == "lancer: --size takes a value");
  CHECK(complaint({scene, "--size", ""}) == "lancer: --size takes a value");
  CHECK(complaint({scene, "-o", ""}) == "lancer: --output takes a value");
  CHECK(complaint({scene, "--size", "1,1", "--size", "2,2"}) == "lancer: --size is given twice");
  CHECK(complaint({scene, "--size", "3"}) == "lancer: --size takes W,H, such as 640,480; this is `3`");
  CHECK(complaint({scene, "--size", "0,3"}) ==
        "lancer: --size takes a whole number from 1 to 65536; this is `0`");
  CHECK(complaint({scene, "--samples", "0"}) ==
        "lancer: --samples takes a whole number from 1 to 1048576; this is `0`");
  CHECK(complaint({scene, "--samples", "2.5"}) ==
        "lancer: --samples takes a whole number from 1 to 1048576; this is `2.5`");
  for (const std::string wrong : {"0", "1.5", "nan", "0.02x", "-0.1"}) {
    CHECK(complaint({scene, "--error=" + wrong}) ==
          "lancer: --error takes a number from 0.001 to 1, such as 0.02; this is `" + wrong + "`");
  }
  CHECK(complaint({scene, "--error", "0.1", "--samples", "4"}) ==
        "lancer: --error and --samples exclude each other");
  CHECK(complaint({scene, "--threads=-1"}) ==
        "lancer: --threads takes a whole number from 0 to 1024; this is `-1`");
  CHECK(complaint({scene, "--region", "1,2,3"}) == "lancer: --region takes X0,Y0,X1,Y1; this is `1,2,3`");
  CHECK(complaint({scene, "--format", "gif"}).find("lancer: --format is one of png, ") == 0);
  CHECK(complaint({scene, "-o", "x.jpg"})
            .find("lancer: there is no picture format for .jpg; the endings are .png, ") == 0);
  CHECK(complaint({scene, "--stats=xml"}) ==
        "lancer: --stats is --stats or --stats=json; this is `--stats=xml`");
  CHECK(complaint({scene, "-D", "n"}) == "lancer: -D takes name=value, such as n=12; this is `n`");
  CHECK(complaint({scene, "-D", "2n=3"}).find("lancer: `2n` is no name") == 0);
  CHECK(complaint({scene, "-D", "n=("}).find("-D n:1:9: error[E009]") == 0);
  CHECK(complaint({scene, "--view", "a", "--all-views"}) ==
        "lancer: --view and --all-views exclude each other");
  CHECK(complaint({"check", scene, "--format", "xml"}) == "lancer: --format is text or json; this is `xml`");
  CHECK(complaint({"check", scene, "--max-steps", "many"}).find("lancer: --max-steps takes a whole number") ==
        0);
  CHECK(complaint({"dump", scene}) == "lancer: dump takes either --ast or --scene");
}

TEST_CASE("command line: values of options", "[app]") {
  tracer::Options options;
  app::read_size("640,480", options);
  CHECK(options.columns == 640);
  CHECK(options.rows == 480);
  const tracer::Region region = app::read_region("1,2,30,40");
  CHECK(region.x0 == 1);
  CHECK(region.y0 == 2);
  CHECK(region.x1 == 30);
  CHECK(region.y1 == 40);
  CHECK_THROWS_AS(app::read_region("5,0,5,9"), app::UsageError);
  CHECK(app::read_define("a=b=c").name == "a");
  CHECK(app::read_define("a=b=c").value == "b=c");
  CHECK_THROWS_AS(app::read_define("=1"), app::UsageError);
  CHECK_THROWS_AS(app::read_whole("-n", "", 0, 9), app::UsageError);
  CHECK_THROWS_AS(app::read_whole("-n", "99999999999999999999", 0, 9), app::UsageError);
  CHECK(app::read_whole("-n", "9", 0, 9) == 9);
}
