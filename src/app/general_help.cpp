#include "app/general_help.hpp"

#include <fmt/format.h>

namespace lancer::app {

const char* const k_examples = R"(Examples:
  lancer lamp.scn                            draws lamp.png beside the script
  lancer render lamp.scn -o big.png --size 1920,1080 --samples 64
  lancer render lamp.scn --all-views         lamp-VIEW.png for each view
  lancer render lamp.scn -D n=12 -o - | display
  lancer check lamp.scn                      finds mistakes without drawing
  lancer check --run lamp.scn                shows what the script prints
  lancer dump --scene lamp.scn               lists everything in the scene
  lancer repl lamp.scn                       changes a scene by talking to it
  lancer plan lamp.scn                       tells what a render does and leaves out

Exit codes: 0 fine, 1 the script is wrong, 2 the command line is wrong,
3 a file cannot be read or written, 130 interrupted.)";

std::string general_help() {
  return fmt::format(
      "Lancer draws scenes that are written in a small language.\n\n"
      "  lancer FILE                 the same as lancer render FILE\n"
      "  lancer render FILE ...      draw a script's views\n"
      "  lancer check FILE ...       find mistakes without drawing\n"
      "  lancer dump --ast|--scene FILE\n"
      "                              show what Lancer makes of a script\n"
      "  lancer plan FILE            tell what a render does and leaves out\n"
      "  lancer repl [FILE]          build a scene by talking to it\n"
      "  lancer COMMAND --help       the options of a command\n"
      "  lancer --version\n\n{}\n",
      k_examples);
}

}  // namespace lancer::app
