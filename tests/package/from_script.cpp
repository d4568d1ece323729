// From a script to a picture and to the bytes of a file.

#include <cstdio>
#include <string>
#include <string_view>

#include "image/encode.hpp"
#include "session/session.hpp"

namespace {

/// A host without files.
class Nowhere : public lancer::session::Host {
 public:
  lancer::session::FileText read(const std::string&) override { return {}; }
  std::string canonical(const std::string&) override { return {}; }
  void print(std::string_view text) override { printed += text; }

  std::string printed;
};

constexpr const char* k_script = R"(
print("half", 1 / 2)
settings { background rgb(0, 0, 1)  ambient 1 }
sphere { <0, 0, 0>, 1  material { diffuse rgb(1, 0.5, 0) } }
view { eye <0, 0, 5>  look_at <0, 0, 0>  fov 90  size 3, 1 }
)";

}  // namespace

int main() {
  using namespace lancer;
  Nowhere host;
  session::Session session(host);
  const session::Run run = session.run_text("example.scn", k_script, "", {});
  if (run.outcome != session::Outcome::fine) {
    std::printf("%s%s\n", to_text(run.diagnostics, session.sources()).c_str(), run.problem.c_str());
    return 1;
  }
  const tracer::Rendered picture = session.render(session.views().at(0), {.samples = 1});
  // 0.5 is 188 (BC) in sRGB.
  const std::string bytes =
      image::encode(picture.image, image::Format::ppm, session.scene().settings.exposure);
  const bool right =
      bytes == std::string("P6\n3 1\n255\n\0\0\xFF\xFF\xBC\0\0\0\xFF", 20) && host.printed == "half 0.5\n";
  std::printf("from a script: %s", host.printed.c_str());
  return right ? 0 : 1;
}
