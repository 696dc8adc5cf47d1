// SPDX-License-Identifier: GPL-3.0-or-later
// Checks constructors' tables against the plug-ins' declarations and makes their objects.
#pragma once

#include "model/catalog.h"
#include "scenes/reader/check_value.h"
#include "scenes/reader/field_hint.h"

#include <optional>
#include <unordered_map>

namespace scree {

/// Checks nodes and makes their objects, once for each node and once for equal ones, which a loop
/// in a script makes, so that sixty-four equal marbles share one lattice. Errors are collected; the
/// value of a parameter with errors is monostate.
class Maker {
  public:
    /// Both must outlive this.
    Maker(const Catalog& catalog, Mistakes& mistakes) : catalog_(catalog), mistakes_(mistakes) {}

    /// The fields of a table as parameters, with defaults; reports unknown, missing and invalid
    /// ones. `path` is that of the table: "generator.layout.components[2]". `family` is that of a
    /// constructor's table.
    Params params(const Description& table, const std::string& path,
                  const std::vector<ParamSpec>& specs,
                  const Registry<MakeObject>* family = nullptr);

  private:
    Params fields(const Description& table, const std::string& path,
                  const std::vector<ParamSpec>& specs);
    void doubt_lengths(const Params& given, const std::vector<ParamSpec>& specs);
    Value value(const Given& given, const ParamSpec& spec);
    Value object(const Given& given, const ParamSpec& spec);
    Value field(const Given& given, const ParamSpec& spec);
    Value texture(const Given& given, const ParamSpec& spec);
    Value record(const Given& given, const ParamSpec& spec);
    Value records(const Given& given, const ParamSpec& spec);
    Value absent(const Description& table, const std::string& path, const ParamSpec& spec);
    Value wrong_kind(const Given& given, const ParamSpec& spec);

    Value made(const Given& given, const Registry<MakeObject>& family);
    SharedObject make(const Given& given, const Registry<MakeObject>& family);
    SharedObject make_or_share(const Given& given, const Registry<MakeObject>& family);
    const Plugin<MakeObject>* plugin(const Given& given, const Registry<MakeObject>& family);

    const Catalog& catalog_;
    Mistakes& mistakes_;
    std::vector<OpenTable> open_; // outermost first
    std::unordered_map<const Description*, SharedObject> made_;
    std::unordered_map<std::string, SharedObject> equal_; // by what the nodes say
    // The sizes of shapes whose file does not tell its unit, none for those that were warned of.
    std::unordered_map<const void*, std::optional<Vec3>> unsure_sizes_;
};

} // namespace scree
