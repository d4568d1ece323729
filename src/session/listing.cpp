#include "session/listing.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "base/number.hpp"
#include "lang/glob.hpp"

namespace lancer::session {
namespace {

std::string to_text(Vec3 v) {
  return fmt::format("<{}, {}, {}>", lancer::to_text(v.x), lancer::to_text(v.y), lancer::to_text(v.z));
}

/// In the shape's own space: the centre, or a point that is on it.
Vec3 own_place(const scene::Scene& scene, const scene::Shape& shape) {
  switch (shape.kind) {
    case scene::ShapeKind::sphere: return scene.spheres[shape.record].center;
    case scene::ShapeKind::plane: {
      const scene::Plane& plane = scene.planes[shape.record];
      return plane.point + normalize(plane.normal) * plane.offset;
    }
    case scene::ShapeKind::box: {
      const scene::Box& box = scene.boxes[shape.record];
      return scene.transforms[box.frame].to_world.point((box.lo + box.hi) * 0.5);
    }
    case scene::ShapeKind::facet: return scene.facets[shape.record].a;
    case scene::ShapeKind::mesh: return scene.meshes[shape.record].points.front();
  }
  return {};
}

std::string look_of(const scene::Scene& scene, const scene::Shape& shape) {
  const scene::Texture& diffuse = scene.materials[shape.material].diffuse;
  const Color c = diffuse.color;
  const std::string color = diffuse.pattern != scene::k_none ? "a pattern"
                            : c.r == c.g && c.g == c.b       ? lancer::to_text(c.r)
                                                             : to_text(Vec3{c.r, c.g, c.b});
  return fmt::format("material {} ({})", shape.material + 1, color);
}

class Lister {
 public:
  explicit Lister(const Session& session) : session_(session), scene_(session.scene()) {}

  std::vector<Listed> run() {
    for (const scene::Shape& s : scene_.shapes) {
      Listed& line = add(Listed::Sort::shape, s.name, s.source);
      line.place = to_text(scene_.transforms[s.transform].to_world.point(own_place(scene_, s)));
      line.look = look_of(scene_, s);
    }
    for (const scene::Light& l : scene_.lights) {
      Listed& line = add(Listed::Sort::light, l.name, l.source);
      line.place = to_text(l.kind == scene::LightKind::sun ? l.direction : l.at);
    }
    for (const scene::View& v : scene_.views)
      add(Listed::Sort::view, v.name, v.source).place = to_text(v.eye);
    return std::move(out_);
  }

 private:
  Listed& add(Listed::Sort sort, scene::Index name, Span source) {
    Listed line;
    line.sort = sort;
    const std::string_view text = session_.sources().text(source);
    line.kind = text.substr(0, text.find_first_not_of("abcdefghijklmnopqrstuvwxyz"));
    line.is_named = name != 0;
    line.name = line.is_named ? scene_.names[name] : fmt::format("{} {}", line.kind, ++unnamed_[line.kind]);
    line.file = session_.sources()[source.file].name();
    line.line = session_.sources()[source.file].position(source.begin).line;
    line.source = source;
    return out_.emplace_back(std::move(line));
  }

  const Session& session_;
  const scene::Scene& scene_;
  std::map<std::string, int> unnamed_;
  std::vector<Listed> out_;
};

}  // namespace

bool name_matches(std::string_view pattern, std::string_view name) {
  return lang::matches_glob(pattern, name);
}

std::vector<Listed> list(const Session& session) { return Lister(session).run(); }

}  // namespace lancer::session
