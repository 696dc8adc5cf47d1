// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/object_option.h"
#include "app/texture_options.h"
#include "core/device.h"
#include "core/display_encoding.h"
#include "core/file.h"
#include "formats/surface_texture.h"
#include "formats/texture_slices.h"
#include "formats/texture_volume.h"
#include "geometry/mesh/uv_frame.h"
#include "geometry/plane/height_field.h"
#include "session/run_stats.h"
#include "session/texture_subject.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace scree {

namespace {

/// One run of the command.
struct TextureJob {
    const TextureOptions& options;
    const TextureRequest& request;
    const TextureSubject& subject;
    const Metadata& metadata;
    const Context& context;
    Console& console;
    Stages& stages;
    Facts facts{}; // for --stats
};

std::string channel_word(TextureChannel channel) {
    switch (channel) {
    case TextureChannel::color:
        return "color";
    case TextureChannel::height:
        return "height";
    case TextureChannel::roughness:
        return "roughness";
    case TextureChannel::value:
        return "value";
    default:
        return "normal";
    }
}

/// Colours are display-encoded; other channels are stored unchanged and marked as raw.
void write_texture_png(const std::string& path, Image image, TextureChannel channel) {
    if (channel != TextureChannel::color) {
        write_png(path, image, {{"oiio:ColorSpace", "raw"}});
        return;
    }
    for (float& v : image.pixels)
        v = display_from_linear(std::clamp(v, 0.0F, 1.0F));
    write_png(path, image);
}

// Whether a channel of every pixel is `value`.
bool is_everywhere(std::span<const Image> images, std::size_t channel, float value) {
    return std::all_of(images.begin(), images.end(), [&](const Image& image) {
        for (std::size_t i = channel; i < image.pixels.size(); i += image.channels.size())
            if (image.pixels[i] != value)
                return false;
        return true;
    });
}

bool is_somewhere(std::span<const Image> images, float value) {
    return std::any_of(images.begin(), images.end(), [&](const Image& image) {
        return std::find(image.pixels.begin(), image.pixels.end(), value) != image.pixels.end();
    });
}

// Throws or warns when the procedural does not provide the channel, so that the map is empty.
void check_channel(const TextureJob& job, std::span<const Image> images) {
    const TextureChannel channel = job.request.channel;
    const bool number = channel == TextureChannel::height || channel == TextureChannel::value;
    if (channel == TextureChannel::roughness && is_somewhere(images, ShadingSample::unset))
        throw job.subject.material_error("neither the procedural nor the material has a roughness",
                                         "material.plastic, metal and translucent have one");
    if ((number && is_everywhere(images, 0, 0)) ||
        (channel == TextureChannel::normal && is_everywhere(images, 2, 1)))
        job.console.warn(fmt::format("the {} is the same everywhere: this procedural gives "
                                     "none",
                                     channel_word(channel)));
}

/// Returns what `make` returns. Its errors about the mesh get the mesh's name and location.
template <class Make>
auto about_mesh(const TextureJob& job, const std::string& hint, const Make& make) {
    try {
        return make();
    } catch (const Error& error) {
        throw job.subject.mesh_error(error.diagnostics().front().message, hint);
    }
}

UvRaster uv_raster_of(const TextureJob& job) {
    const Mesh& mesh = *job.subject.source.mesh;
    if (mesh.uvs.empty())
        throw job.subject.mesh_error(
            "has no UVs, so a texture has no place on it",
            "unwrap it in a modelling program, or use --map slices or --map volume");
    const int height = job.request.height > 0 ? job.request.height : job.request.width;
    UvRaster raster = about_mesh(job, "unwrap it in a modelling program",
                                 [&] { return UvRaster(mesh, job.request.width, height); });
    if (raster.overlapped() > 0)
        job.console.warn(fmt::format("UVs of {} overlap: {:.3g}% of its texture stands for "
                                     "several places and shows "
                                     "the first",
                                     mesh.name,
                                     100.0 * double(raster.overlapped()) /
                                         double(raster.covered_texels().size())));
    if (raster.wraps())
        job.console.say(
            fmt::format("note: UVs of {} go beyond [0, 1]: show the texture repeated", mesh.name));
    return raster;
}

void write_displacement(TextureJob& job, Image image) {
    const UvScale scale = uv_scale(*job.subject.source.mesh);
    job.facts.emplace_back("uv_spread", scale.spread);
    job.console.say(fmt::format("the texture is {:.4g} x {:.4g} m large on the surface, give or "
                                "take {:.0f}%",
                                scale.size.x, scale.size.y, 100 * scale.spread));
    write_height(job.options.output, {std::move(image), scale.size, 0, false}, job.metadata);
}

void bake_uv(TextureJob& job) {
    job.stages.begin("texture");
    const UvRaster raster = uv_raster_of(job);
    Image image = surface_texture(job.subject.source, raster, job.request.channel, job.context);
    check_channel(job, {&image, 1});
    job.facts = {{"width", image.width},
                 {"height", image.height},
                 {"covered", double(raster.covered_texels().size())},
                 {"overlapped", double(raster.overlapped())}};
    job.stages.begin("write");
    if (job.request.ending == "png") {
        write_texture_png(job.options.output, std::move(image), job.request.channel);
    } else if (job.request.channel == TextureChannel::height) {
        write_displacement(job, std::move(image));
    } else {
        const ImagePart part{channel_word(job.request.channel), std::move(image)};
        write_exr(job.options.output, {&part, 1}, job.metadata);
    }
}

// The slices' geometry in object space, so that other programs can reassemble them.
HeaderNumbers stack_numbers(const SliceStack& stack) {
    const auto numbers = [](const Imath::V3d& v) {
        return std::vector<float>{float(v.x), float(v.y), float(v.z)};
    };
    return {{"sliceFirst", numbers(stack.first)},
            {"sliceRight", numbers(stack.right)},
            {"sliceDown", numbers(stack.down)},
            {"sliceStep", numbers(stack.step)}};
}

void write_slices(TextureJob& job, const SliceStack& stack, std::vector<Image> images) {
    check_channel(job, images);
    job.facts = {{"width", stack.width}, {"height", stack.height}, {"slices", stack.count}};
    job.stages.begin("write");
    if (job.request.ending == "png") {
        write_texture_png(job.options.output, contact_sheet(images), job.request.channel);
        return;
    }
    std::vector<ImagePart> parts;
    parts.reserve(images.size());
    for (int i = 0; i < stack.count; ++i)
        parts.push_back({slice_name(stack, i), std::move(images[std::size_t(i)])});
    write_exr(job.options.output, parts, job.metadata, stack_numbers(stack));
}

void bake_slices(TextureJob& job) {
    job.stages.begin("texture");
    const TextureRequest& request = job.request;
    const SliceStack stack = about_mesh(job, "", [&] {
        return slices_through(*job.subject.source.mesh, request.axis, request.slices, request.width,
                              request.height);
    });
    write_slices(job, stack,
                 slice_images(job.subject.source, stack, request.channel, {}, job.context));
}

void bake_volume(TextureJob& job) {
    job.stages.begin("texture");
    const Mesh& mesh = *job.subject.source.mesh;
    const TextureVolume volume =
        about_mesh(job, "", [&] { return texture_volume(mesh, job.request.width); });
    const std::size_t held =
        static_cast<std::size_t>(std::count(volume.inside.begin(), volume.inside.end(), 1));
    job.console.say(
        volume.inside.empty()
            ? fmt::format("{} is not closed: the whole of its bounding box is filled", mesh.name)
            : fmt::format("{} is closed: {} of {} voxels are inside", mesh.name, held,
                          volume.grid.size()));
    if (job.request.ending == "exr") {
        write_slices(job, slices_of(volume.grid, job.request.axis),
                     volume_images(job.subject.source, volume, job.request.axis,
                                   job.request.channel, job.context));
    } else {
        const std::unique_ptr<VdbFile> file =
            volume_file(job.subject.source, volume, job.subject.world_from_object, job.context);
        if (file->densest() == 0)
            job.console.warn("the density is 0 everywhere: this procedural gives no value");
        job.stages.begin("write");
        file->write(job.options.output, job.metadata);
    }
    job.facts.emplace_back("voxels", double(volume.inside.empty() ? volume.grid.size() : held));
    job.facts.emplace_back("voxel_size", volume.grid.side);
}

void check_fills_space(const TextureSubject& subject, TextureMap map) {
    if (map != TextureMap::uv && !subject.source.procedural->solid())
        throw subject.material_error("this procedural lies on the surface and has no inside; "
                                     "expected a solid one",
                                     "use --map uv");
}

int bake_texture(const TextureOptions& options) {
    const TextureRequest request = options.request();
    check_writable(options.output);
    if (!options.stats.empty())
        check_writable(options.stats);

    SceneRun run(options.scene);
    Session& session = run.session;
    SceneDraft draft = session.load();
    const int object =
        options.object.empty() ? 0 : chosen_object(options.object, options.scene.path, draft);
    if (object > 0)
        make_only(object, draft);
    const Scene scene = session.bake(std::move(draft));
    TextureSubject subject = texture_subject(options.scene.path, scene, object);
    check_fills_space(subject, request.map);
    if (subject.scales_differ && !subject.source.procedural->scales_with_object())
        run.console.warn("the instances differ in scale, so that each has another piece of "
                         "the texture; this is that of the first");
    if (!options.scene.device.empty()) // only on request, since the host is faster than PoCL
        subject.source.device = session.device();
    const Context context = session.context("texture");
    Metadata metadata = provenance(scene);
    metadata.emplace_back("scree:mesh", subject.source.mesh->name);
    TextureJob job{options, request, subject, metadata, context, run.console, session.stages()};
    if (request.map == TextureMap::uv)
        bake_uv(job);
    else if (request.map == TextureMap::slices)
        bake_slices(job);
    else
        bake_volume(job);
    session.stages().end();
    run.console.say("wrote " + options.output);
    if (!options.stats.empty())
        write_file(options.stats,
                   run_stats_json(session.stages(), scene.aggregates, nullptr, job.facts));
    return 0;
}

} // namespace

void add_texture_command(CLI::App& app, Run& run) {
    auto options = std::make_shared<TextureOptions>();
    CLI::App* command = app.add_subcommand(
        "texture", "Bake an object's procedural to a texture, slices or a volume.");
    options->add_to(*command);
    command->callback([options, &run] { run = [options] { return bake_texture(*options); }; });
}

} // namespace scree
