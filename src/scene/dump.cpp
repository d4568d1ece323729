#include <array>
#include <fmt/format.h>
#include <map>

#include "base/number.hpp"
#include "scene/scene.hpp"

namespace lancer::scene {
namespace {

std::string text(Vec3 v) { return fmt::format("<{}, {}, {}>", to_text(v.x), to_text(v.y), to_text(v.z)); }
std::string text(Color c) { return text(Vec3{c.r, c.g, c.b}); }

std::string text(const Texture& t) {
  return t.pattern == k_none ? text(t.color) : fmt::format("pattern {}", t.pattern);
}

/// As it would be written in a script.
std::string quoted(const std::string& name) {
  std::string out = "\"";
  for (const char c : name) {
    if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (c == '"' || c == '\\' || c == '{') {
      out += {'\\', c};
    } else if (static_cast<unsigned char>(c) < ' ') {
      out += fmt::format("\\u{{{:X}}}", static_cast<unsigned>(c));
    } else {
      out += c;
    }
  }
  return out + "\"";
}

class Dump {
 public:
  explicit Dump(const Scene& scene) : scene_(scene) {}

  std::string run() {
    settings();
    for (std::size_t i = 1; i < scene_.transforms.size(); ++i) transform(i);
    for (std::size_t i = 0; i < scene_.patterns.size(); ++i) pattern(i);
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) material(i);
    for (const Shape& s : scene_.shapes) shape(s);
    for (const Light& l : scene_.lights) light(l);
    for (const View& v : scene_.views) view(v);
    return std::move(out_);
  }

 private:
  template <class... Args>
  void line(fmt::format_string<Args...> form, Args&&... args) {
    out_ += fmt::format(form, std::forward<Args>(args)...) + "\n";
  }

  /// `sphere "bead 1"`, or `sphere 3` for the third sphere without a name.
  std::string heading(const std::string& kind, Index name) {
    if (name != 0) return kind + " " + quoted(scene_.names[name]);
    return fmt::format("{} {}", kind, ++unnamed_[kind]);
  }

  void settings();
  void transform(std::size_t i);
  void pattern(std::size_t i);
  void material(std::size_t i);
  void shape(const Shape& s);
  void mesh(const Shape& s, const std::string& look);
  void light(const Light& l);
  void view(const View& v);

  const Scene& scene_;
  std::string out_;
  std::map<std::string, int> unnamed_;
};

void Dump::settings() {
  constexpr std::array k_shadows{"filtered", "opaque", "off"};
  constexpr std::array k_sums{"linear", "log"};
  const Settings& s = scene_.settings;
  line("settings background {} ambient {} depth {} ior {} shadows {} sum {} exposure {}", text(s.background),
       text(s.ambient), s.depth, to_text(s.ior), k_shadows[static_cast<std::size_t>(s.shadows)],
       k_sums[static_cast<std::size_t>(s.sum)], to_text(s.exposure));
}

std::string text(const Affine& a) {
  return fmt::format("{} {} {} translation {}", text(a.rows[0]), text(a.rows[1]), text(a.rows[2]),
                     text(a.translation));
}

void Dump::transform(std::size_t i) {
  const Transform& t = scene_.transforms[i];
  line("transform {} rows {}", i, text(t.to_world));
  line("  inverse rows {}", text(t.to_object));
}

void Dump::pattern(std::size_t i) {
  const Pattern& p = scene_.patterns[i];
  const std::string colors = fmt::format("{} {}", text(p.a), text(p.b));
  switch (p.kind) {
    case Pattern::Kind::checker: return line("pattern {} checker {} size {}", i, colors, to_text(p.size));
    case Pattern::Kind::stripes:
      return line("pattern {} stripes {} axis {} width {}", i, colors, text(p.axis), to_text(p.size));
    case Pattern::Kind::gradient:
      return line("pattern {} gradient {} from {} to {}", i, colors, text(p.from), text(p.to));
  }
}

void Dump::material(std::size_t i) {
  const Material& m = scene_.materials[i];
  line(
      "material {} diffuse {} ambient {} specular {} shininess {} reflection {} transmission {} ior {} "
      "fresnel {}",
      i, text(m.diffuse), text(m.ambient), text(m.specular), to_text(m.shininess), text(m.reflection),
      text(m.transmission), to_text(m.ior), m.fresnel);
}

void Dump::shape(const Shape& s) {
  const std::string look =
      fmt::format("material {} transform {} shadow {}", s.material, s.transform, s.shadow);
  switch (s.kind) {
    case ShapeKind::sphere: {
      const Sphere& sphere = scene_.spheres[s.record];
      return line("{} center {} radius {} {}", heading("sphere", s.name), text(sphere.center),
                  to_text(sphere.radius), look);
    }
    case ShapeKind::plane: {
      const Plane& p = scene_.planes[s.record];
      return line("{} point {} normal {} offset {} {}", heading("plane", s.name), text(p.point),
                  text(p.normal), to_text(p.offset), look);
    }
    case ShapeKind::box: {
      const Box& b = scene_.boxes[s.record];
      return line("{} corners {} {} frame {} {}", heading("box", s.name), text(b.lo), text(b.hi), b.frame,
                  look);
    }
    case ShapeKind::facet: {
      const Facet& f = scene_.facets[s.record];
      std::string normals;
      if (f.normals != k_none) {
        const auto& n = scene_.facet_normals[f.normals];
        normals = fmt::format(" normals {} {} {}", text(n[0]), text(n[1]), text(n[2]));
      }
      return line("{} points {} {} {}{} {}", heading("facet", s.name), text(f.a), text(f.b), text(f.c),
                  normals, look);
    }
    case ShapeKind::mesh: return mesh(s, look);
  }
}

void Dump::mesh(const Shape& s, const std::string& look) {
  const Mesh& m = scene_.meshes[s.record];
  line("{} points {} faces {} smooth {} solid {} {}", heading("mesh", s.name), m.points.size(),
       m.faces.size(), !m.normals.empty(), m.solid, look);
  for (std::size_t i = 0; i < m.points.size(); ++i) {
    line("  point {} {}{}", i, text(m.points[i]), m.normals.empty() ? "" : " normal " + text(m.normals[i]));
  }
  for (const auto& f : m.faces) line("  face {} {} {}", f[0], f[1], f[2]);
}

void Dump::light(const Light& l) {
  const std::string falloff = l.falloff > 0 ? " falloff " + to_text(l.falloff) : "";
  switch (l.kind) {
    case LightKind::point:
      return line("{} at {} color {}{}", heading("light", l.name), text(l.at), text(l.color), falloff);
    case LightKind::sun:
      return line("{} direction {} color {}", heading("sun", l.name), text(l.direction), text(l.color));
    case LightKind::spot:
      return line("{} at {} direction {} angle {} softness {} color {}{}", heading("spot", l.name),
                  text(l.at), text(l.direction), to_text(l.angle), to_text(l.softness), text(l.color),
                  falloff);
  }
}

void Dump::view(const View& v) {
  const std::string head = fmt::format("{} eye {}", heading("view", v.name), text(v.eye));
  const std::string size = fmt::format("size {}, {}", v.columns, v.rows);
  const std::string way = fmt::format("look {} up {}", text(v.look), text(v.up));
  switch (v.projection) {
    case Projection::perspective: return line("{} {} fov {} {}", head, way, to_text(v.fov), size);
    case Projection::orthographic: return line("{} {} width {} {}", head, way, to_text(v.width), size);
    case Projection::corners:
      return line("{} corners {} {} {} {}", head, text(v.corners[0]), text(v.corners[1]), text(v.corners[2]),
                  size);
  }
}

}  // namespace

std::string dump(const Scene& scene) { return Dump(scene).run(); }

}  // namespace lancer::scene
