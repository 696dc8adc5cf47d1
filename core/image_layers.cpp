// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image_layers.h"

#include "core/error.h"
#include "core/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace scree {

namespace {

std::string last_word(const std::string& name) { return name.substr(name.rfind('.') + 1); }

std::string role_of(const std::string& suffix) {
    static constexpr std::array<std::array<std::string_view, 2>, 11> roles{{{"r", "R"},
                                                                            {"red", "R"},
                                                                            {"g", "G"},
                                                                            {"green", "G"},
                                                                            {"b", "B"},
                                                                            {"blue", "B"},
                                                                            {"a", "A"},
                                                                            {"alpha", "A"},
                                                                            {"y", "Y"},
                                                                            {"ry", "RY"},
                                                                            {"by", "BY"}}};
    const std::string small = lower_case(suffix);
    for (const auto& [written, role] : roles)
        if (small == written)
            return std::string(role);
    return suffix;
}

bool has_any_value(const ImageLayer& layer) {
    return layer.has_color() || layer.find("R") != nullptr || layer.find("G") != nullptr ||
           layer.find("B") != nullptr || layer.find("A") != nullptr;
}

bool is_called_picture(const ImageLayer& layer) {
    static constexpr std::array<std::string_view, 5> usual{"combined", "rgba", "rgb", "beauty",
                                                           "color"};
    return std::find(usual.begin(), usual.end(), lower_case(last_word(layer.name))) != usual.end();
}

std::vector<std::string> names_of(const std::vector<const ImageLayer*>& layers) {
    std::vector<std::string> names;
    names.reserve(layers.size());
    for (const ImageLayer* layer : layers)
        names.push_back(layer->name.empty() ? "one without a name" : layer->name);
    return names;
}

std::vector<const ImageLayer*> those(std::span<const ImageLayer> layers, const auto& accepted) {
    std::vector<const ImageLayer*> out;
    for (const ImageLayer& layer : layers)
        if (accepted(layer))
            out.push_back(&layer);
    return out;
}

const ImageLayer& named_layer(std::span<const ImageLayer> layers, const std::string& wanted) {
    const std::string small = lower_case(wanted);
    const auto exactly = [&](const ImageLayer& layer) { return layer.name == wanted; };
    const auto in_any_case = [&](const ImageLayer& layer) {
        return lower_case(layer.name) == small;
    };
    const auto by_its_end = [&](const ImageLayer& layer) {
        return lower_case(layer.name).ends_with("." + small);
    };
    std::vector<const ImageLayer*> found = those(layers, exactly);
    if (found.empty())
        found = those(layers, in_any_case);
    if (found.empty())
        found = those(layers, by_its_end);
    if (found.size() == 1)
        return *found.front();
    const std::vector<std::string> names =
        names_of(those(layers, [](const ImageLayer&) { return true; }));
    if (found.empty())
        throw Error(Diagnostic{
            {},
            {},
            fmt::format("has no layer \"{}\"; its layers are: {}", wanted, fmt::join(names, ", ")),
            did_you_mean(wanted, names)});
    throw Error(
        fmt::format("has several layers \"{}\": {}", wanted, fmt::join(names_of(found), ", ")));
}

} // namespace

const ImageLayer::Channel* ImageLayer::find(const std::string& role) const {
    const auto found = std::find_if(channels.begin(), channels.end(),
                                    [&](const Channel& channel) { return channel.role == role; });
    return found == channels.end() ? nullptr : &*found;
}

bool ImageLayer::has_color() const {
    return (find("R") != nullptr && find("G") != nullptr && find("B") != nullptr) ||
           find("Y") != nullptr;
}

std::vector<ImageLayer> layers_of_part(int part, const std::string& part_name,
                                       const std::vector<std::string>& channels) {
    std::vector<ImageLayer> layers;
    for (const std::string& channel : channels) {
        const std::size_t dot = channel.rfind('.');
        const bool unnamed = dot == std::string::npos;
        const std::string name = unnamed ? part_name : channel.substr(0, dot);
        auto layer = std::find_if(layers.begin(), layers.end(), [&](const ImageLayer& known) {
            return known.name == name && known.unnamed == unnamed;
        });
        if (layer == layers.end())
            layer = layers.insert(layer, {part, name, unnamed, {}});
        layer->channels.push_back({channel, role_of(unnamed ? channel : channel.substr(dot + 1))});
    }
    for (ImageLayer& layer : layers)
        if (layer.find("X") != nullptr || layer.find("x") != nullptr)
            for (ImageLayer::Channel& channel : layer.channels)
                if (channel.role == "Y")
                    channel.role = "y"; // of a position or a direction
    return layers;
}

const ImageLayer& chosen_layer(std::span<const ImageLayer> layers, const std::string& wanted,
                               Meaning meaning) {
    if (!wanted.empty())
        return named_layer(layers, wanted);
    const std::vector<const ImageLayer*> usable = those(layers, [&](const ImageLayer& layer) {
        return meaning == Meaning::data ? has_any_value(layer) : layer.has_color();
    });
    for (const ImageLayer* layer : usable)
        if (layer->part == 0 && layer->unnamed)
            return *layer;
    if (usable.size() == 1 || (usable.empty() && meaning == Meaning::data && !layers.empty()))
        return usable.empty() ? layers.front() : *usable.front();
    std::vector<const ImageLayer*> pictures = usable;
    std::erase_if(pictures, [](const ImageLayer* layer) { return !is_called_picture(*layer); });
    if (pictures.size() == 1)
        return *pictures.front();
    if (usable.empty()) {
        std::vector<std::string> names;
        for (const ImageLayer& layer : layers)
            for (const ImageLayer::Channel& channel : layer.channels)
                names.push_back(channel.name);
        throw Error(fmt::format("is no picture: it has neither R, G and B nor Y; its channels "
                                "are: {}",
                                fmt::join(names, ", ")));
    }
    throw Error(
        Diagnostic{{},
                   {},
                   fmt::format("holds several pictures: {}", fmt::join(names_of(usable), ", ")),
                   fmt::format("name one with layer = \"{}\"", names_of(usable).front())});
}

} // namespace scree
