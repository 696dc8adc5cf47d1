// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/analysis_json.h"

#include "core/version.h"

#include <nlohmann/json.hpp>

namespace scree {

namespace {

using Json = nlohmann::ordered_json;

/// The middles of bins from 0 up, what a curve is plotted over.
std::vector<double> middles(double bin_width, std::size_t count) {
    std::vector<double> out(count);
    for (std::size_t k = 0; k < count; ++k)
        out[k] = (double(k) + 0.5) * bin_width;
    return out;
}

Json layout_json(const LayoutFigures& figures, const std::vector<std::string>& kinds) {
    Json out{{"seed", figures.seed}, {"count", figures.count}};
    out["components"] = Json::array();
    for (std::size_t i = 0; i < kinds.size(); ++i)
        out["components"].push_back({{"name", kinds[i]}, {"count", figures.count_by_kind[i]}});
    if (figures.fill)
        out["fill"] = *figures.fill;
    if (const auto& circle = figures.largest_empty_circle; circle)
        out["largest_empty_circle"] = {{"centre", {circle->centre.x, circle->centre.y}},
                                       {"radius", circle->radius}};
    return out;
}

Json distances_json(const Summary& summary, const Histogram& histogram) {
    return {{"samples", summary.count},
            {"mean", summary.mean},
            {"median", summary.median},
            {"percentile_95", summary.percentile_95},
            {"maximum", summary.maximum},
            {"histogram", {{"bin_width", histogram.bin_width}, {"density", histogram.density}}}};
}

Json pairs_json(const AnalysisReport& report) {
    Json out{
        {"bin_width", report.pair_correlation.bin_width},
        {"r", middles(report.pair_correlation.bin_width, report.pair_correlation.value.size())},
        {"g", report.pair_correlation.value}};
    out["components"] = Json::array();
    for (std::size_t i = 0; i < report.kind_names.size(); ++i)
        out["components"].push_back(
            {{"name", report.kind_names[i]}, {"g", report.pair_correlation_by_kind[i].value}});
    return out;
}

// NaN is written as null.
Json spectra_json(const AnalysisReport& report) {
    const RadialSpectrum& radial = report.radial;
    Json out{{"bin_width", radial.bin_width},
             {"f", middles(radial.bin_width, radial.power.size())},
             {"counts", radial.count},
             {"power", radial.power},
             {"anisotropy_db", radial.anisotropy_db}};
    out["components"] = Json::array();
    for (std::size_t i = 0; i < report.kind_names.size(); ++i)
        out["components"].push_back({{"name", report.kind_names[i]},
                                     {"power", report.radial_by_kind[i].power},
                                     {"anisotropy_db", report.radial_by_kind[i].anisotropy_db}});
    return out;
}

Json report_json(const NamedReport& named) {
    const AnalysisReport& report = named.report;
    Json out{{"generator", named.generator}};
    if (!named.name.empty())
        out["name"] = named.name;
    out.update({{"domain_area", report.window_area},
                {"torus", report.torus},
                {"mean_spacing", report.spacing}});
    out["layouts"] = Json::array();
    for (const LayoutFigures& figures : report.layouts)
        out["layouts"].push_back(layout_json(figures, report.kind_names));
    if (report.has_regions) {
        out["gaps"] = distances_json(report.gap, report.gap_histogram);
        out["neighbours"] = distances_json(report.neighbour, report.neighbour_histogram);
    }
    out["pair_correlation"] = pairs_json(report);
    out["radial_power"] = spectra_json(report);
    return out;
}

} // namespace

std::string analysis_json(const std::vector<NamedReport>& reports, const std::string& source) {
    Json root{{"scree", SCREE_VERSION}, {"source", source}};
    root["aggregates"] = Json::array();
    for (const NamedReport& report : reports)
        root["aggregates"].push_back(report_json(report));
    return root.dump(1) + "\n";
}

} // namespace scree
