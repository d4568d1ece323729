#!/usr/bin/env python3
"""Writes scenes for comparisons, the same one for Lancer (.scn), POV-Ray (.pov) and Tachyon (.dat).

    tests/bench/scenes/make_scenes.py FOLDER [WIDTH HEIGHT]

balls   five mirroring balls on a mirroring floor up to the horizon, two lights
flake   a sphereflake, after Eric Haines' Standard Procedural Databases: 820 mirroring balls on a square, three lights

All three languages have right-handed coordinates here: POV-Ray's camera gets its axes one by one. What has an
ambient term has it in full (Lancer's `ambient 1`), highlights are Blinn's with roughness 1 / shininess.
"""

import math
import pathlib
import sys


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def scaled(a, k):
    return [x * k for x in a]


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return scaled(a, 1 / math.sqrt(dot(a, a)))


def text(v):
    return ", ".join(f"{x:.17g}" for x in v)


class Material:
    def __init__(self, color, ambient, diffuse, specular, shininess, reflection):
        self.color, self.ambient, self.diffuse = color, ambient, diffuse
        self.specular, self.shininess, self.reflection = specular, shininess, reflection


class Scene:
    def __init__(self, name, eye, look_at, up, fov, background):
        self.name, self.eye, self.look_at, self.fov, self.background = name, eye, look_at, fov, background
        self.look = unit(sub(look_at, eye))
        self.right = unit(cross(self.look, up))
        self.up = cross(self.right, self.look)
        self.lights, self.materials, self.balls = [], [], []
        self.floor = None  # (height, half side or None, material); y is up
        self.ground = None  # the same with z up

    def scn(self, width, height):
        out = [f"settings {{ background rgb({text(self.background)})  ambient 1  depth 5 }}"]
        out.append(f"view {{ eye <{text(self.eye)}>  look <{text(self.look)}>  up <{text(self.up)}>  fov {self.fov}  size {width}, {height} }}")
        out += [f"light {{ at <{text(at)}>  color {level} }}" for at, level in self.lights]
        for i, m in enumerate(self.materials):
            out.append(f"let m{i} = material {{ ambient rgb({text(scaled(m.color, m.ambient))})  diffuse rgb({text(scaled(m.color, m.diffuse))})"
                       f"  specular {m.specular}  shininess {m.shininess}  reflection {m.reflection} }}")
        if self.floor:
            out.append(f"plane {{ point <0, {self.floor[0]}, 0>  normal y  material m{self.floor[2]} }}")
        if self.ground:
            z, s, m = self.ground
            out.append(f"facet {{ <{-s}, {-s}, {z}>, <{s}, {-s}, {z}>, <{s}, {s}, {z}>  material m{m} }}")
            out.append(f"facet {{ <{-s}, {-s}, {z}>, <{s}, {s}, {z}>, <{-s}, {s}, {z}>  material m{m} }}")
        out += [f"sphere {{ <{text(c)}>, {r:.17g}  material m{m} }}" for c, r, m in self.balls]
        return "\n".join(out) + "\n"

    def pov(self, width, height):
        half = math.tan(math.radians(self.fov / 2))
        out = ["#version 3.7;", "global_settings { assumed_gamma 1.0 max_trace_level 5 }",
               f"background {{ rgb <{text(self.background)}> }}",
               f"camera {{ perspective location <{text(self.eye)}> direction <{text(self.look)}> right <{text(scaled(self.right, 2 * half))}>"
               f" up <{text(scaled(self.up, 2 * half * height / width))}> }}"]
        out += [f"light_source {{ <{text(at)}> rgb {level} }}" for at, level in self.lights]
        for i, m in enumerate(self.materials):
            out.append(f"#declare T{i} = texture {{ pigment {{ rgb <{text(m.color)}> }} finish {{ ambient {m.ambient} diffuse {m.diffuse}"
                       f" specular {m.specular} roughness {1 / m.shininess:.17g} reflection {m.reflection} }} }}")
        if self.floor:
            out.append(f"plane {{ y, {self.floor[0]} texture {{ T{self.floor[2]} }} }}")
        if self.ground:
            z, s, m = self.ground
            out.append(f"triangle {{ <{-s}, {-s}, {z}>, <{s}, {-s}, {z}>, <{s}, {s}, {z}> texture {{ T{m} }} }}")
            out.append(f"triangle {{ <{-s}, {-s}, {z}>, <{s}, {s}, {z}>, <{-s}, {s}, {z}> texture {{ T{m} }} }}")
        out += [f"sphere {{ <{text(c)}>, {r:.17g} texture {{ T{m} }} }}" for c, r, m in self.balls]
        return "\n".join(out) + "\n"

    def dat(self, width, height):
        """Tachyon is left-handed: z changes its sign. Its zoom is for the picture's height."""
        def flipped(v):
            return f"{v[0]:.17g} {v[1]:.17g} {-v[2]:.17g}"

        zoom = width / height / (2 * math.tan(math.radians(self.fov / 2)))
        out = ["BEGIN_SCENE", f"RESOLUTION {width} {height}", "CAMERA", f"ZOOM {zoom:.17g}", "ASPECTRATIO 1.0", "ANTIALIASING 0",
               "RAYDEPTH 5", f"CENTER {flipped(self.eye)}", f"VIEWDIR {flipped(self.look)}", f"UPDIR {flipped(self.up)}", "END_CAMERA",
               "BACKGROUND " + " ".join(f"{x:.17g}" for x in self.background)]
        out += [f"LIGHT CENTER {flipped(at)} RAD 0.001 COLOR {level} {level} {level}" for at, level in self.lights]
        for i, m in enumerate(self.materials):
            out.append(f"TEXDEF t{i} AMBIENT {m.ambient} DIFFUSE {m.diffuse} SPECULAR {m.reflection} OPACITY 1.0 PHONG PLASTIC {m.specular}"
                       f" PHONG_SIZE {m.shininess} COLOR {' '.join(f'{x:.17g}' for x in m.color)} TEXFUNC 0")
        if self.floor:
            out.append(f"PLANE CENTER 0 {self.floor[0]} 0 NORMAL 0 1 0 t{self.floor[2]}")
        if self.ground:
            z, s, m = self.ground
            for a, b, c in (([-s, -s, z], [s, -s, z], [s, s, z]), ([-s, -s, z], [s, s, z], [-s, s, z])):
                out.append(f"TRI V0 {flipped(a)} V1 {flipped(b)} V2 {flipped(c)} t{m}")
        out += [f"SPHERE CENTER {flipped(c)} RAD {r:.17g} t{m}" for c, r, m in self.balls]
        return "\n".join(out + ["END_SCENE"]) + "\n"


def balls():
    scene = Scene("balls", [0, 2.4, 8], [0, 0.8, 0], [0, 1, 0], 50, [0.08, 0.35, 0.75])
    scene.lights = [([6, 9, 7], 0.45), ([-7, 6, 5], 0.3)]
    scene.materials = [Material([0.7, 0.7, 0.65], 0.15, 0.65, 0, 1, 0.15)]
    for place, radius, color in (([-2.5, 1, 0], 1, [0.9, 0.25, 0.15]), ([0.1, 1, -1.3], 1, [0.2, 0.7, 0.3]), ([2.4, 1, 0.2], 1, [0.2, 0.3, 0.9]),
                                 ([-1, 0.6, 1.8], 0.6, [0.9, 0.8, 0.2]), ([1.2, 0.7, 1.6], 0.7, [0.85, 0.85, 0.85])):
        scene.balls.append((place, radius, len(scene.materials)))
        scene.materials.append(Material(color, 0.1, 0.6, 0.4, 50, 0.3))
    scene.floor = (0, None, 0)
    return scene


def turned(v, axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return plus(plus(scaled(v, c), scaled(cross(axis, v), s)), scaled(axis, dot(axis, v) * (1 - c)))


def grow(out, middle, radius, up, levels):
    out.append((middle, radius, 1))
    if levels == 0:
        return
    side = unit(cross(up, [0, 1, 0] if abs(up[0]) > 0.9 else [1, 0, 0]))
    ways = [turned(side, up, 60 * i) for i in range(6)]
    ways += [unit(plus(turned(side, up, 120 * i + 30), scaled(up, 1.3))) for i in range(3)]
    for way in ways:
        grow(out, plus(middle, scaled(way, radius * 4 / 3)), radius / 3, way, levels - 1)


def flake():
    scene = Scene("flake", [2.1, 1.3, 1.7], [0, 0, 0], [0, 0, 1], 45, [0.08, 0.35, 0.75])
    scene.lights = [([4, 3, 2], 0.35), ([1, -4, 4], 0.3), ([-3, 1, 5], 0.25)]
    scene.materials = [Material([1, 0.75, 0.33], 0.1, 0.7, 0, 1, 0), Material([1, 0.9, 0.7], 0.1, 0.4, 0.3, 40, 0.35)]
    scene.ground = (-0.5, 12, 0)
    grow(scene.balls, [0, 0, 0], 0.5, [0, 0, 1], 3)
    return scene


def main():
    if len(sys.argv) not in (2, 4):
        sys.exit(__doc__)
    width, height = map(int, sys.argv[2:4]) if len(sys.argv) == 4 else (800, 600)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for scene in (balls(), flake()):
        for ending in ("scn", "pov", "dat"):
            (folder / f"{scene.name}.{ending}").write_text(getattr(scene, ending)(width, height))


if __name__ == "__main__":
    main()
