// SPDX-License-Identifier: GPL-3.0-or-later
// One run from a scene file to its outputs, without command-line types: called by the commands and
// the studio.
#pragma once

#include "core/device.h"
#include "core/parallel.h"
#include "model/scene.h"
#include "scenes/reader/description.h"
#include "session/catalog.h"
#include "session/stages.h"
#include "session/watcher.h"

#include <map>
#include <optional>

namespace scree {

/// Options of a session.
struct SessionOptions {
    std::string path;                               // of the scene
    std::map<std::string, std::string> overrides{}; // values for the script's arg(...)
    std::vector<std::string> readable_folders{};    // where include(...) may read too
    std::string device{};                           // as Device takes it, or "none"
    int threads = 0;                                // 0: all
};

/// The steps from a file to a finished scene. Limits the number of threads during its lifetime.
class Session {
  public:
    /// Without watcher and cancellation. The catalog holds what the scene can name.
    explicit Session(SessionOptions options, Catalog catalog = standard_catalog())
        : Session(std::move(options), nobody(), never(), std::move(catalog)) {}

    /// `watcher` and `cancel` must outlive this.
    Session(SessionOptions options, Watcher& watcher, const Cancel& cancel,
            Catalog catalog = standard_catalog());

    /// Reads the scene.
    DescriptionNode description() const;

    /// Reads and checks the scene (stage "parse"). Tells the watcher the warnings.
    SceneDraft load();

    /// Checks a scene that was read. Tells the watcher the warnings.
    SceneDraft check(const DescriptionNode& root);

    /// Bakes the items (stage "generate") and reports each generator to the watcher.
    Scene bake(SceneDraft draft);

    /// A context for a long computation, whose progress is shown as that of `what`.
    Context context(const std::string& what);

    /// The OpenCL device, opened on first use; null for the device "none".
    Device* device();

    const Catalog& catalog() const { return catalog_; }
    const SessionOptions& options() const { return options_; }
    Stages& stages() { return stages_; }
    Watcher& watcher() { return watcher_; }

  private:
    void say(Warnings& warnings);

    static Watcher& nobody();
    static const Cancel& never();

    SessionOptions options_;
    Watcher& watcher_;
    const Cancel& cancel_;
    ThreadLimit threads_;
    Catalog catalog_;
    Stages stages_;
    std::optional<Device> device_;
};

} // namespace scree
