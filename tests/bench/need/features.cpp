#include "bench/need/features.hpp"

#include <chrono>
#include <stdexcept>

#include "memory_host.hpp"
#include "session/session.hpp"

namespace lancer::need {

std::string plain_script() {
  return R"(
settings { background rgb(0.5, 0.6, 0.8)  ambient 0.2 }
plane "floor" { point <0, 0, 0>  normal y  material { diffuse 0.7 } }
box "wall" { <-20, 0, -6>, <20, 12, -5>  material { diffuse rgb(0.8, 0.7, 0.6) } }
for i in 0..9 { sphere { <1.1 * (i - 4), 0.5, -2>, 0.5  material { diffuse hsv(40 * i, 0.7, 0.9)  specular 0.3 } } }
light { at <5, 9, 8>  color 0.8 }
view "front" { eye <0, 2.2, 7>  look_at <0, 1, -2>  fov 50  size 64, 40 }
)";
}

const std::vector<Feature>& features() {
  static const std::vector<Feature> all{
      {"1,000 materials that nothing wears",
       "let palette = map(range(1000), fn (i) -> material { diffuse checker(hsv(i, 1, 1), 0.1)  transmission "
       "0.5  "
       "reflection 0.3  ior 1.5  fresnel true })\nprint(len(palette))",
       false},
      {"100 views that are not drawn", "for i in 0..100 { view { eye <i, 5, 9>  look_at <0, 0, 0> } }",
       false},
      {"1,000 balls behind the wall",
       "for i in 0..1000 { sphere { <(i % 50) - 25, 0.5 + floor(i / 50) * 0.4, -9 - (i % 7)>, 0.2  material "
       "{ "
       "diffuse checker(red, white, 0.1) } } }",
       false},
      {"100 lights that are off", "for i in 0..100 { light { at <i - 50, 9, 5>  color 0 } }", false},
      {"100 spots aimed at the sky",
       "for i in 0..100 { spot { at <i - 50, 9, 5>  look_at <i - 50, 20, 5>  angle 40 } }", false},
      {"100 lamps out of reach",
       "for i in 0..100 { light { at <40 * i, 300, 4000>  color 0.5  falloff 0.5 } }", false},
      {"glass that no ray meets",
       "sphere { <0, 3, -20>, 1  material { diffuse 0  transmission 0.9  ior 1.5  fresnel true  reflection "
       "0.1 } }",
       false},
      {"patterns on what is hidden",
       "for i in 0..50 { cube { center <i - 25, 1, -9>  side 0.6  material { diffuse stripes(red, blue, x, "
       "0.1) } } }",
       false},
      {"a pattern on the floor",
       "plane { point <0, 0.01, 0>  normal y  material { diffuse checker(0.9, 0.4) } }", true},
      {"a mirror", "sphere { <-2.5, 0.7, 0.5>, 0.7  material { diffuse 0.1  reflection 0.8 } }", true},
      {"a glass ball",
       "sphere { <2.5, 0.7, 0.5>, 0.7  material { diffuse 0  transmission 0.9  ior 1.5  fresnel true } }",
       true},
      {"a second lamp", "light { at <-5, 6, 8>  color 0.4 }", true},
  };
  return all;
}

Drawn draw(const std::string& script, int columns, int rows, int samples) {
  const auto start = std::chrono::steady_clock::now();
  test::MemoryHost host;
  session::Session session(host);
  if (session.run_text("need.scn", script, "", {}).outcome != session::Outcome::fine)
    throw std::runtime_error("the scene is wrong:\n" + script);
  Drawn out;
  out.script_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  tracer::Options options;
  options.columns = columns;
  options.rows = rows;
  options.samples = samples;
  options.threads = 1;
  options.error = 0.01;
  const tracer::Rendered rendered = session.render(session.views().front(), options);
  out.stats = rendered.stats;
  out.picture = rendered.image.data();
  return out;
}

}  // namespace lancer::need
