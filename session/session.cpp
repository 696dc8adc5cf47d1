// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include "core/text.h"
#include "scenes/reader/scene.h"
#include "session/show_pictures.h"

#include <fmt/format.h>

namespace scree {

namespace {

// "layout: 224 elements, fill 0.430, 0.05 s"
std::string describe(const Aggregate& aggregate) {
    std::size_t strands = 0;
    for (const Instance& instance : aggregate.instances)
        if (const Strands* shape = aggregate.prototypes[instance.prototype].strands())
            strands += shape->count();
    std::string out =
        title(aggregate) + ": " +
        (strands > 0 ? counted(strands, "strand") : counted(aggregate.instances.size(), "element"));
    for (const auto& [name, value] : aggregate.facts) {
        if (name == "fill")
            out += fmt::format(", fill {:.3f}", value);
        if (name == "removed" && value > 0)
            out += fmt::format(", {:g} removed that nothing held", value);
        if (name == "seconds")
            out += fmt::format(", {:.2f} s", value);
    }
    return out;
}

} // namespace

Watcher& Session::nobody() {
    static NoWatcher watcher;
    return watcher;
}

const Cancel& Session::never() {
    static const Cancel cancel;
    return cancel;
}

Session::Session(SessionOptions options, Watcher& watcher, const Cancel& cancel, Catalog catalog)
    : options_(std::move(options)), watcher_(watcher), cancel_(cancel), threads_(options_.threads),
      catalog_(std::move(catalog)) {}

DescriptionNode Session::description() const {
    return read_description(options_.path, options_.overrides, catalog_.constructor_families(),
                            options_.readable_folders);
}

SceneDraft Session::load() {
    stages_.begin("parse");
    if (!options_.device.empty() && options_.device != "none")
        device()->name(); // no such device is an error also where nothing runs on it
    SceneDraft draft = check(description());
    stages_.end();
    return draft;
}

SceneDraft Session::check(const DescriptionNode& root) {
    SceneDraft draft = resolve(root, options_.path, catalog_);
    say(*draft.warnings);
    return draft;
}

void Session::say(Warnings& warnings) {
    for (const Diagnostic& warning : warnings)
        watcher_.warn(warning.text());
    warnings.clear();
}

Device* Session::device() {
    if (!device_ && options_.device != "none")
        device_.emplace(options_.device);
    return device_ ? &*device_ : nullptr;
}

Context Session::context(const std::string& what) {
    return {device(), &cancel_, [this, what](std::string_view part, double fraction) {
                watcher_.progress(what, fraction, " " + std::string(part));
            }};
}

Scene Session::bake(SceneDraft draft) {
    stages_.begin("generate");
    Scene& scene = draft.scene;
    for (const std::shared_ptr<const SceneItem>& item : draft.items) {
        scene.aggregates.push_back(item->bake(context(item->kind), scene.aggregates.size()));
        scene.aggregates.back().where = item->where;
        say(*draft.warnings);
        if (item->kind != "object")
            watcher_.say(describe(scene.aggregates.back()));
    }
    show_pictures(scene.aggregates);
    stages_.end();
    return std::move(scene);
}

} // namespace scree
