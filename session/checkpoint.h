// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene.h"
#include "render/rendering.h"

#include <string>

namespace scree {

/// The file that an interrupted render continues from. It holds which picture it is of, in
/// lines of text, and the state of its Rendering.
class Checkpoint {
  public:
    /// `path` of the file, which need not exist, and the picture that it is to be of.
    Checkpoint(std::string path, const Scene& scene, const RenderOptions& options);

    bool exists() const;

    /// Writes it atomically: a program that is killed leaves the one before. Throws Error
    /// (resource) when that is not possible.
    void write(const Rendering& rendering) const;

    /// Throws Error (input) when the file is cut off or of another picture, naming what differs.
    void read(Rendering& rendering) const;

    const std::string& path() const { return path_; }

  private:
    std::string path_;
    std::string picture_; // lines of text
};

} // namespace scree
