# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders a scene that bench/peer_scene.cpp has written, in Blender's Cycles, and prints the CPU
seconds that the samples took.
  blender -b --factory-startup -t 2 --python cycles.py -- FOLDER SAMPLES SEED OUT.exr >LOG
"""
import json
import math
import os
import sys
import time

import bpy
import numpy as np
from mathutils import Matrix, Vector

folder, samples, seed, out = sys.argv[sys.argv.index("--") + 1:]
with open(os.path.join(folder, "scene.json")) as file:
    description = json.load(file)
data = np.fromfile(os.path.join(folder, "scene.bin"), dtype="<u4")


def floats(place, columns):
    first, count = place
    return data[first:first + count].view("<f4").reshape(-1, columns)


def integers(place, columns):
    first, count = place
    return data[first:first + count].reshape(-1, columns)


def matrix(numbers):
    return Matrix((numbers[0:4], numbers[4:8], numbers[8:12], (0, 0, 0, 1)))


bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene


def place(name, of, world_from_object):
    placed = bpy.data.objects.new(name, of)
    placed.matrix_world = world_from_object
    scene.collection.objects.link(placed)
    return placed


# ---- what every renderer must do alike: size, filter, length of paths, no clamp

def set_up_render():
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = description["width"]
    scene.render.resolution_y = description["height"]
    scene.render.filepath = out
    scene.render.use_file_extension = False
    settings = scene.render.image_settings
    settings.file_format = "OPEN_EXR"
    settings.color_depth = "32"
    settings.color_mode = "RGB"
    cycles = scene.cycles
    cycles.samples = int(samples)
    cycles.device = "CPU"
    cycles.seed = int(seed)
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.pixel_filter_type = "BOX"
    cycles.filter_width = 1
    # A path of 2 edges, direct light, has no bounce by Cycles's count.
    bounces = max(0, description["depth"] - 2)
    cycles.max_bounces = bounces
    cycles.diffuse_bounces = bounces
    cycles.glossy_bounces = bounces
    cycles.transmission_bounces = bounces
    cycles.sample_clamp_direct = 0
    cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = 0


def add_camera():
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle_y = description["camera"]["fov"]
    camera.clip_start = 1e-4
    camera.clip_end = 1e5
    scene.camera = place("camera", camera, matrix(description["camera"]["matrix"]))


# ---- materials

class Nodes:
    """The nodes of a material or world."""

    def __init__(self, owner):
        owner.use_nodes = True
        self.tree = owner.node_tree
        self.tree.nodes.clear()

    def add(self, kind, inputs=(), **properties):
        """A node of a kind. Inputs by name or number: a value, or the output of another node."""
        node = self.tree.nodes.new("ShaderNode" + kind)
        for name, value in properties.items():
            setattr(node, name, value)
        for name, value in dict(inputs).items():
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, node.inputs[name])
            else:
                node.inputs[name].default_value = value
        return node


def paint(nodes, color):
    if color == "instance":
        return nodes.add("ObjectInfo").outputs["Color"]
    if isinstance(color, str):
        image = bpy.data.images.load(os.path.join(folder, color))
        image.colorspace_settings.name = "Non-Color"  # linear, as it is
        return nodes.add("TexImage", image=image, extension="EXTEND").outputs["Color"]
    return (*color, 1)


def surface(nodes, material):
    kind = material["kind"]
    if kind == "matte":
        return nodes.add("BsdfDiffuse", {"Color": paint(nodes, material["color"])})
    if kind == "metal":
        # Fresnel by half vectors, which Cycles's glossy node does not have.
        return nodes.add("BsdfPrincipled", {
            "Base Color": paint(nodes, material["color"]), "Metallic": 1,
            "Roughness": material["roughness"]}, distribution="GGX")
    if kind == "glass":
        rough = material["roughness"] > 0
        return nodes.add("BsdfGlass", {"IOR": material["ior"], "Color": (1, 1, 1, 1),
                                       "Roughness": material["roughness"]},
                         distribution="GGX" if rough else "SHARP")
    base = nodes.add("BsdfDiffuse", {"Color": paint(nodes, material["color"])})
    coat = nodes.add("BsdfGlossy", {"Color": (1, 1, 1, 1), "Roughness": material["roughness"]},
                     distribution="GGX")
    share = nodes.add("Fresnel", {"IOR": material["ior"]})
    return nodes.add("MixShader", {0: share.outputs[0], 1: base.outputs[0], 2: coat.outputs[0]})


def make_material(description_of):
    material = bpy.data.materials.new(description_of["kind"])
    nodes = Nodes(material)
    nodes.add("OutputMaterial", {"Surface": surface(nodes, description_of).outputs[0]})
    return material


# ---- lights

def add_sky(sky):
    world = bpy.data.worlds.new("sky")
    scene.world = world
    nodes = Nodes(world)
    color = (*sky["zenith"], 1)
    if not sky["zenith"] == sky["horizon"] == sky["ground"]:
        direction = nodes.add("TexCoord").outputs["Generated"]
        height = nodes.add("SeparateXYZ", {0: direction}).outputs["Y"]
        above = nodes.add("MixRGB", {0: height, 1: (*sky["horizon"], 1), 2: color}, use_clamp=False)
        is_above = nodes.add("Math", {0: height, 1: 0}, operation="GREATER_THAN")
        color = nodes.add("MixRGB", {0: is_above.outputs[0], 1: (*sky["ground"], 1),
                                     2: above.outputs[0]}).outputs[0]
    background = nodes.add("Background", {"Color": color})
    nodes.add("OutputWorld", {"Surface": background.outputs[0]})


def add_sun(sun):
    lamp = bpy.data.lights.new("sun", "SUN")
    lamp.angle = sun["angle"]
    set_emission(lamp, sun["irradiance"], 1)
    place("sun", lamp, Vector(sun["direction"]).to_track_quat("Z", "Y").to_matrix().to_4x4())


def set_emission(lamp, color, factor):
    """A colour of any brightness: the lamp's own ends at 1."""
    largest = max(color)
    lamp.color = [part / largest for part in color]
    lamp.energy = largest * factor


def add_area(area):
    lamp = bpy.data.lights.new("area", "AREA")
    lamp.shape = "RECTANGLE"
    lamp.size, lamp.size_y = area["size"]
    # A quarter of the energy over the area is the radiance.
    set_emission(lamp, area["radiance"], 4 * lamp.size * lamp.size_y)
    turn = matrix(area["matrix"])
    place("area", lamp, turn @ Matrix.Rotation(math.pi, 4, "X"))  # a lamp shines along -z


def add_backs(areas):
    """Scree's area lights are opaque and black from behind; Cycles's lamps would not be there."""
    black = make_material({"kind": "matte", "color": (0, 0, 0)})
    positions, faces = [], []
    for area in areas:
        width, height = area["size"]
        behind = -1e-3 * min(width, height)
        faces.append([len(positions) + i for i in range(4)])
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            corner = Vector((x * width / 2, y * height / 2, behind))
            positions.append(matrix(area["matrix"]) @ corner)
    mesh = bpy.data.meshes.new("backs")
    mesh.from_pydata(positions, [], faces)
    mesh.materials.append(black)
    place("backs", mesh, Matrix.Identity(4))


def add_lights():
    for light in description["lights"]:
        {"sky": add_sky, "sun": add_sun, "area": add_area}[light["kind"]](light)
    areas = [light for light in description["lights"] if light["kind"] == "area"]
    if areas:
        add_backs(areas)


# ---- shapes

def make_mesh(shape, material):
    positions = floats(shape["positions"], 3)
    triangles = integers(shape["triangles"], 3)
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(positions.tolist(), [], triangles.tolist())
    mesh.materials.append(material)
    corners = triangles.reshape(-1)
    uvs = floats(shape["uvs"], 2)
    if len(uvs):
        mesh.uv_layers.new().data.foreach_set("uv", uvs[corners].reshape(-1))
    normals = floats(shape["normals"], 3)
    if len(normals):
        mesh.polygons.foreach_set("use_smooth", np.ones(len(triangles), dtype=bool))
        mesh.use_auto_smooth = True
        mesh.normals_split_custom_set_from_vertices(normals.tolist())
    return mesh


def make_strands(shape, material):
    """Hair curves: only nodes of geometry can make them in this version of Blender."""
    points = floats(shape["points"], 3)
    ends = integers(shape["ends"], 1)[:, 0]
    first = np.arange(len(points) - 1)
    first = first[~np.isin(first + 1, ends)]
    polylines = bpy.data.meshes.new("polylines")
    polylines.from_pydata(points.tolist(), np.stack([first, first + 1], -1).tolist(), [])
    source = place("polylines", polylines, Matrix.Identity(4))
    source.hide_render = True
    group = bpy.data.node_groups.new("strands", "GeometryNodeTree")
    group.inputs.new("NodeSocketGeometry", "Geometry")
    group.outputs.new("NodeSocketGeometry", "Geometry")
    info = group.nodes.new("GeometryNodeObjectInfo")
    info.inputs["Object"].default_value = source
    to_curve = group.nodes.new("GeometryNodeMeshToCurve")
    set_radius = group.nodes.new("GeometryNodeSetCurveRadius")
    set_radius.inputs["Radius"].default_value = shape["radius"]
    set_material = group.nodes.new("GeometryNodeSetMaterial")
    set_material.inputs["Material"].default_value = material
    group.nodes.new("NodeGroupInput")
    result = group.nodes.new("NodeGroupOutput")
    group.links.new(info.outputs["Geometry"], to_curve.inputs[0])
    group.links.new(to_curve.outputs[0], set_radius.inputs["Curve"])
    group.links.new(set_radius.outputs[0], set_material.inputs["Geometry"])
    group.links.new(set_material.outputs[0], result.inputs[0])
    scene.cycles_curves.shape = "THICK"
    hair = bpy.data.hair_curves.new("hair")
    hair.materials.append(material)
    return hair, group


def add_objects():
    materials = [make_material(material) for material in description["materials"]]
    shapes = []
    for shape in description["shapes"]:
        make = make_strands if "points" in shape else make_mesh
        shapes.append(make(shape, materials[shape["material"]]))
    for number, item in enumerate(description["objects"]):
        shape = shapes[item["shape"]]
        is_hair = isinstance(shape, tuple)
        placed = place(str(number), shape[0] if is_hair else shape, matrix(item["matrix"]))
        placed.color = (*item["color"], 1)
        if is_hair:
            placed.modifiers.new("strands", "NODES").node_group = shape[1]


# ---- time

class SampleClock:
    """CPU seconds from before the first sample to the end, without what prepares the scene. Cycles
    tells where it is only in the lines that Blender prints, so standard output must be a file."""

    def __init__(self):
        self.printed = open("/proc/self/fd/1", "rb")
        self.start = self.end = None
        bpy.app.handlers.render_stats.append(self.on_line)

    def on_line(self, *_):
        self.end = time.process_time()
        self.printed.seek(-200, os.SEEK_END)
        if self.start is None and b"Sample 0/" in self.printed.read():
            self.start = self.end

    def seconds(self):
        return self.end - self.start


set_up_render()
add_camera()
add_lights()
add_objects()
clock = SampleClock()
bpy.ops.render.render(write_still=True)
print("CPU_SECONDS", clock.seconds())
